// Many blocks and many scripts on one machine; prints JSON.
//  load: read, validate and compile 5,000 blocks, in several shapes of program.
//  many: 10,200 scripts (34 in each of 300 clones) that count for ever: how far apart they get.
//  waiting: CPU time that 1,000 waiting scripts cost for a second of ticks.
#include <algorithm>
#include <ctime>
#include <iostream>

#include "programs/support.h"

namespace {

using namespace mirada;
using namespace mirada::vm::test;

double cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

Json change(const std::string& name) {
  return block("data_changevariableby", {{"VALUE", number(1)}}, {{"VARIABLE", named(name)}});
}
Json forever(Json body) { return block("control_forever", {{"SUBSTACK", in(std::move(body))}}); }
/// 5 blocks: if a < b + 1 { set c to 2 * a }, and so on.
Json some_blocks(int i) {
  const std::string name = "v" + std::to_string(i % 50);
  const Json sum = block("operator_add", {{"NUM1", in(var(name))}, {"NUM2", number(i)}});
  const Json test = block("operator_lt", {{"OPERAND1", in(sum)}, {"OPERAND2", number(7)}});
  return block("control_if", {{"CONDITION", in(test)}, {"SUBSTACK", in(change(name))}});
}

std::vector<std::string> fifty_names() {
  std::vector<std::string> names;
  for (int i = 0; i < 50; ++i) names.push_back("v" + std::to_string(i));
  return names;
}

Json ten_scripts() {
  std::vector<Json> tops;
  for (int script = 0; script < 10; ++script) {
    std::vector<Json> blocks;
    for (int i = 0; i < 99; ++i) blocks.push_back(some_blocks(script * 99 + i));
    tops.push_back(hat(std::move(blocks)));
  }
  return program(std::move(tops), fifty_names());
}

Json one_stack() {
  std::vector<Json> blocks;
  for (int i = 0; i < 4999; ++i) blocks.push_back(change("v" + std::to_string(i % 50)));
  return program({hat(std::move(blocks))}, fifty_names());
}

Json many_scripts() {
  std::vector<Json> tops;
  for (int i = 0; i < 2500; ++i) tops.push_back(hat({change("v" + std::to_string(i % 50))}));
  return program(std::move(tops), fifty_names());
}

/// Sums of variables, 200 deep.
Json nested() {
  std::vector<Json> blocks;
  for (int row = 0; row < 12; ++row) {
    Json sum = var("v0");
    for (int i = 0; i < 200; ++i) {
      sum = block("operator_add",
                  {{"NUM1", in(std::move(sum))}, {"NUM2", in(var("v" + std::to_string(i % 50)))}});
    }
    blocks.push_back(
        block("data_setvariableto", {{"VALUE", in(std::move(sum))}}, {{"VARIABLE", named("v1")}}));
  }
  return program({hat(std::move(blocks))}, fifty_names());
}

/// 1,000 my-blocks of one parameter, each called by the one before it.
Json my_blocks() {
  const auto state = [](int i) {
    const Json param = {{"id", "p"}, {"name", "n"}, {"type", "number"}};
    return Json{{"id", "d" + std::to_string(i)},
                {"name", "block " + std::to_string(i)},
                {"params", Json::array({param})},
                {"returns", false},
                {"warp", false}};
  };
  std::vector<Json> tops;
  for (int i = 0; i < 1000; ++i) {
    Json head = block("procedures_definition");
    head["extraState"] = state(i);
    Json argument = block("argument_reporter_string_number", Json::object(), {{"VALUE", "n"}});
    Json sum = block("operator_add", {{"NUM1", in(std::move(argument))}, {"NUM2", number(1)}});
    Json call = block("procedures_call", {{"p", in(std::move(sum))}});
    call["extraState"] = state((i + 1) % 1000);
    tops.push_back(stack({std::move(head), change("v" + std::to_string(i % 50)), std::move(call)}));
  }
  return program(std::move(tops), fifty_names());
}

/// As the editor writes it: ids of twenty letters on shadows too, places of the stacks, indented by nobody.
std::string as_the_editor_writes(Json root) {
  std::vector<Json*> waiting{&root};
  int count = 0;
  while (!waiting.empty()) {
    Json& json = *waiting.back();
    waiting.pop_back();
    if (json.is_object() && json.contains("type") && !json.contains("name")) {
      std::string id = "q8!" + std::to_string(count++);
      json["id"] = id + std::string(20 - id.size(), 'k');
    }
    for (Json& inner : json) {
      if (inner.is_structured()) waiting.push_back(&inner);
    }
  }
  for (Json& top : root["workspace"]["blocks"]["blocks"]) {
    top["x"] = 40;
    top["y"] = 1200;
  }
  return root.dump();
}

Json load(const char* shape, const Json& json) {
  const std::string text = as_the_editor_writes(json);
  std::vector<double> values;
  for (int i = 0; i < 21; ++i) {
    const double before = cpu_s();
    const auto loaded = vm::load_program(text, core_catalog());
    values.push_back((cpu_s() - before) * 1e3);
    if (!loaded) return {{"shape", shape}, {"fault", to_text(loaded.faults(), Lang::en)}};
  }
  std::ranges::sort(values);
  return {{"shape", shape}, {"bytes", text.size()}, {"median_ms", values[10]}, {"max_ms", values.back()}};
}

Json load_all() {
  return {load("ten scripts", ten_scripts()), load("one stack", one_stack()),
          load("2,500 scripts", many_scripts()), load("sums 200 deep", nested()),
          load("1,000 my-blocks", my_blocks())};
}

/// A block of a Scratch project.
Json scratch(const char* opcode, Json next, Json inputs = Json::object(), Json fields = Json::object()) {
  return {{"opcode", opcode},
          {"next", std::move(next)},
          {"inputs", std::move(inputs)},
          {"fields", std::move(fields)},
          {"shadow", false},
          {"topLevel", false}};
}
Json amount(int number) { return Json::array({1, Json::array({4, std::to_string(number)})}); }

/// A Scratch project: 300 clones (its limit) with `kinds` scripts each, which count for ever: script k in
/// v<k>.
std::string clones(int kinds) {
  Json blocks;
  blocks["flag"] = scratch("event_whenflagclicked", "times");
  blocks["times"] = scratch("control_repeat", nullptr, {{"TIMES", amount(300)}, {"SUBSTACK", {2, "make"}}});
  blocks["make"] = scratch("control_create_clone_of", nullptr, {{"CLONE_OPTION", {1, "menu"}}});
  blocks["menu"] = scratch("control_create_clone_of_menu", nullptr, Json::object(),
                           {{"CLONE_OPTION", {"_myself_", nullptr}}});
  blocks["menu"]["shadow"] = true;
  blocks["flag"]["topLevel"] = true;
  Json variables;
  for (int k = 0; k < kinds; ++k) {
    const std::string id = std::to_string(k);
    blocks["born" + id] = scratch("control_start_as_clone", "ever" + id);
    blocks["born" + id]["topLevel"] = true;
    blocks["ever" + id] = scratch("control_forever", nullptr, {{"SUBSTACK", {2, "count" + id}}});
    blocks["count" + id] = scratch("data_changevariableby", nullptr, {{"VALUE", amount(1)}},
                                   {{"VARIABLE", {"v" + id, "v" + id}}});
    variables["v" + id] = {"v" + id, 0};
  }
  const Json stage = {
      {"isStage", true}, {"name", "Stage"}, {"variables", variables}, {"blocks", Json::object()}};
  const Json sprite = {
      {"isStage", false}, {"name", "Sprite"}, {"variables", Json::object()}, {"blocks", blocks}};
  return Json{{"targets", {stage, sprite}}, {"meta", {{"semver", "3.0.0"}}}}.dump();
}

Json many() {
  constexpr int kKinds = 34;
  Running run{std::string_view(clones(kKinds))};
  const double before = cpu_s();
  for (int tick = 0; tick < 2000; ++tick) {
    run.machine->tick();
    run.host.clock.advance(20 * kMillisecond);
  }
  const double used = cpu_s() - before;
  double least = 1e300;
  double most = 0;
  for (const auto& [name, value] : run.machine->variables()) {
    least = std::min(least, value.number / 300);
    most = std::max(most, value.number / 300);
  }
  return {{"scripts", 300 * kKinds},
          {"turns_each_least", least},
          {"turns_each_most", most},
          {"faults", run.machine->take_faults().size()},
          {"mblocks_per_cpu_s", static_cast<double>(run.machine->block_executions()) / used * 1e-6}};
}

Json waiting() {
  std::vector<Json> tops;
  for (int i = 0; i < 1000; ++i) {
    tops.push_back(hat({forever(block("control_wait", {{"DURATION", number(0.5 + 0.01 * (i % 50))}}))}));
  }
  Running run(program(std::move(tops), {}));
  const double before = cpu_s();
  constexpr int kSeconds = 20;
  for (int tick = 0; tick < 50 * kSeconds; ++tick) {
    run.machine->tick();
    run.host.clock.advance(20 * kMillisecond);
  }
  const double used = cpu_s() - before;
  return {{"scripts", 1000}, {"core_percent", used / kSeconds * 100}};
}

}  // namespace

int main() {
  std::cout
      << Json{{"bench", "scripts"}, {"load", load_all()}, {"many", many()}, {"waiting", waiting()}}.dump(1)
      << "\n";
  return 0;
}
