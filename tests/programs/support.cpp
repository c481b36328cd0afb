#include "programs/support.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "base/files.h"
#include "packs/packs.h"

namespace mirada::vm::test {
namespace {

// By a stack of its own: a sanitizer's frames are too large to recurse through 5,000 blocks.
void give_ids(Json& root, int& next) {
  std::vector<Json*> waiting{&root};
  while (!waiting.empty()) {
    Json& json = *waiting.back();
    waiting.pop_back();
    if (json.is_object() && json.contains("type") && !json.contains("id") && !json.contains("name"))
      json["id"] = "b" + std::to_string(next++);
    const std::size_t first = waiting.size();
    if (json.is_array()) {
      for (Json& item : json) waiting.push_back(&item);
    } else if (json.is_object()) {
      for (auto& [key, value] : json.items()) {
        if (key != "extraState") waiting.push_back(&value);
      }
    }
    std::reverse(waiting.begin() + static_cast<std::ptrdiff_t>(first), waiting.end());
  }
}

}  // namespace

BlockCatalog read_core_packs() {
  BlockCatalog catalog;
  for (const char* id : {"events", "control", "operators", "data", "procedures"}) {
    const std::string file = std::string(MIRADA_SOURCE_DIR) + "/blocks/" + id + "/pack.json";
    const Result<std::string> text = read_file(file);
    if (!text) throw std::runtime_error(to_text(text.faults(), Lang::en));
    Result<packs::Pack> pack = packs::read_pack(*text, file, {});
    if (!pack) throw std::runtime_error(to_text(pack.faults(), Lang::en));
    for (BlockDef& def : pack->blocks) catalog.add(std::move(def));
  }
  return catalog;
}

const BlockCatalog& core_catalog() {
  static const BlockCatalog catalog = read_core_packs();
  return catalog;
}

Json block(const std::string& type, Json inputs, Json fields) {
  return {{"type", type}, {"inputs", std::move(inputs)}, {"fields", std::move(fields)}};
}
Json text(const std::string& value) {
  return {{"shadow", {{"type", "text"}, {"fields", {{"TEXT", value}}}}}};
}
Json number(double value) { return {{"shadow", {{"type", "math_number"}, {"fields", {{"NUM", value}}}}}}; }
Json in(Json inner) { return {{"block", std::move(inner)}}; }
Json named(const std::string& name) { return {{"id", "id-" + name}}; }
Json var(const std::string& name) {
  return block("data_variable", Json::object(), {{"VARIABLE", named(name)}});
}

Json stack(std::vector<Json> blocks) {
  Json out;
  for (auto it = blocks.rbegin(); it != blocks.rend(); ++it) {
    if (!out.is_null()) (*it)["next"] = {{"block", std::move(out)}};
    out = std::move(*it);
  }
  return out;
}

Json hat(std::vector<Json> blocks) {
  blocks.insert(blocks.begin(), block("event_whenflagclicked"));
  return stack(std::move(blocks));
}

Json program(std::vector<Json> tops, const std::vector<std::string>& variables,
             const std::vector<std::string>& lists, const std::vector<std::string>& messages) {
  Json declared = Json::array();
  const auto declare = [&](const std::vector<std::string>& names, const char* type) {
    for (const std::string& name : names)
      declared.push_back({{"name", name}, {"id", "id-" + name}, {"type", type}});
  };
  declare(variables, "");
  declare(lists, "list");
  declare(messages, "broadcast_msg");
  int next = 0;
  for (Json& top : tops) give_ids(top, next);
  return {{"format", "mirada-program"},
          {"version", 1},
          {"packs", Json::array()},
          {"workspace", {{"blocks", {{"languageVersion", 0}, {"blocks", tops}}}, {"variables", declared}}}};
}

Running::Running(std::string_view program_text, Limits limits, const BlockCatalog& catalog) {
  Result<LoadedProgram> result = load_program(program_text, catalog);
  if (!result) throw std::runtime_error(to_text(result.faults(), Lang::en));
  loaded = std::move(*result);
  machine = std::make_unique<Machine>(loaded.code, catalog, host, limits);
  machine->flag();
}

bool Running::finish(double seconds, bool back_to_back) {
  const Micros end = host.clock.now() + micros(seconds);
  for (int ticks = 0; machine->any_script_alive() && host.clock.now() < end; ++ticks) {
    if (ticks == kMostTicks) return false;
    machine->tick(back_to_back);
    const Micros wake = machine->next_wake();
    if (wake == INT64_MAX) break;
    if (back_to_back) {
      host.clock.set(std::max(host.clock.now(), wake));
    } else {
      host.clock.advance(20 * kMillisecond);
    }
  }
  return true;
}

std::string Running::list(const std::string& name) const {
  std::string out;
  const auto lists = machine->lists(kWholeMonitors);
  for (const MonitorValue& item : lists.at(name)) out += (out.empty() ? "" : " ") + item.text;
  return out;
}

}  // namespace mirada::vm::test
