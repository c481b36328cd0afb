// Many blocks and many scripts on one machine; prints JSON.
//  load: read, validate and compile 5,000 blocks.
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

std::string five_thousand() {
  std::vector<Json> tops;
  std::vector<std::string> names;
  for (int i = 0; i < 50; ++i) names.push_back("v" + std::to_string(i));
  for (int script = 0; script < 10; ++script) {
    std::vector<Json> blocks;
    for (int i = 0; i < 99; ++i) blocks.push_back(some_blocks(script * 99 + i));
    tops.push_back(hat(std::move(blocks)));
  }
  return program(std::move(tops), names).dump();
}

Json load() {
  const std::string text = five_thousand();
  std::vector<double> values;
  for (int i = 0; i < 21; ++i) {
    const double before = cpu_s();
    const auto loaded = vm::load_program(text, core_catalog());
    values.push_back((cpu_s() - before) * 1e3);
    if (!loaded) return {{"fault", to_text(loaded.faults(), Lang::en)}};
  }
  std::ranges::sort(values);
  return {{"blocks", 4960}, {"bytes", text.size()}, {"median_ms", values[10]}, {"max_ms", values.back()}};
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
  std::cout << Json{{"bench", "scripts"}, {"load", load()}, {"many", many()}, {"waiting", waiting()}}.dump(1)
            << "\n";
  return 0;
}
