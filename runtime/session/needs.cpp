#include "session/needs.h"

#include <vector>

#include <nlohmann/json.hpp>

#include "base/json_reader.h"

namespace mirada::session {
namespace {

using nlohmann::json;

/// The object with this id anywhere in the text; null when there is none. Iterative: `next` chains are long.
const json* find_block(const json& root, const std::string& block_id) {
  std::vector<const json*> open{&root};
  while (!open.empty()) {
    const json& here = *open.back();
    open.pop_back();
    if (here.is_object() && here.contains("type") && here.contains("id") && here["id"] == block_id)
      return &here;
    if (!here.is_structured()) continue;
    for (const json& part : here) open.push_back(&part);
  }
  return nullptr;
}

}  // namespace

std::set<std::string> needs_of_block(const std::string& program_json, const std::string& block_id,
                                     const vm::LoadedProgram& program, const vm::BlockCatalog& catalog) {
  const auto parsed = parse_json(program_json, "");
  const json* block = parsed ? find_block(*parsed, block_id) : nullptr;
  if (block == nullptr) return program.needs;
  std::set<std::string> needs;
  std::vector<const json*> open{block};
  while (!open.empty()) {
    const json& here = *open.back();
    open.pop_back();
    if (const auto type = here.find("type"); type != here.end() && type->is_string()) {
      const std::string opcode = *type;
      if (const vm::BlockDef* def = catalog.find(opcode)) needs.insert(def->needs.begin(), def->needs.end());
      if (opcode.starts_with("procedures_")) needs.insert(program.needs.begin(), program.needs.end());
    }
    const auto inputs = here.find("inputs");
    if (inputs == here.end() || !inputs->is_object()) continue;
    for (const json& input : *inputs) {
      if (input.is_object() && input.contains("block") && input["block"].is_object())
        open.push_back(&input["block"]);
    }
  }
  return needs;
}

robot::Needs needs_of(const std::set<std::string>& names) {
  robot::Needs needs;
  needs.sonar = names.contains("sonar");
  needs.faces = names.contains("faces");
  needs.memory = names.contains("memory");
  needs.sonar = needs.sonar || needs.memory;
  needs.things = names.contains("things");
  needs.place = names.contains("place");
  needs.frames = needs.sonar || needs.faces || needs.things;
  return needs;
}

bool seen_enough(const robot::Robot& robot, const robot::Needs& needs) {
  if (!needs.any() || !robot.perception().has_camera()) return true;
  const bool sonar = !needs.sonar || robot.sonar().fresh();
  const bool faces =
      !needs.faces || robot.faces() != nullptr || robot.perception().faces_trouble().has_value();
  return sonar && faces;
}

}  // namespace mirada::session
