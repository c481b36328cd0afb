#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "vm/json_access.h"
#include "vm/messages.h"
#include "vm/reader.h"

namespace mirada::vm {
namespace {

using Json = nlohmann::json;

class Reader {
 public:
  explicit Reader(ReadProgram& out) : out_(out), program_(out.program) {}

  void read(const Json& root);

 private:
  /// One block of the file still to be read, and where it hangs.
  struct Task {
    const Json* json;
    BlockIndex index;
  };

  void fault(std::string place, const Message& message, MessageArgs args = {}) {
    out_.faults.push_back(make_fault(std::move(place), message, std::move(args)));
  }
  void wrong(const std::string& place, const std::string& field, const char* expected, const Json& value) {
    fault(place, messages::wrong_shape,
          {{"field", field}, {"expected", expected}, {"value", shown_json(value)}});
  }
  void read_envelope(const Json& root);
  void read_variables(const Json& workspace);
  void read_tops(const Json& workspace);
  BlockIndex add_block(const Json& json, BlockIndex parent, BlockIndex enclosing, bool shadow,
                       const std::string& path);
  void fill(const Task& task);
  void read_fields(const Json& json, BlockIndex index, const std::string& place);
  void read_inputs(const Task& task);
  void read_signature(const Json& json, BlockIndex index, const std::string& place);

  ReadProgram& out_;
  Program& program_;
  std::vector<Task> tasks_;
};

void Reader::read_envelope(const Json& root) {
  program_.name = text_at(root, "name");
  if (const Json* version = find_field(root, "version"); version && *version != 1) {
    fault("/version", messages::wrong_version, {{"value", shown_json(*version)}});
  }
  const Json* packs = find_field(root, "packs");
  if (!packs) return;
  if (!packs->is_array()) return wrong("/packs", "/packs", "[name, ...]", *packs);
  for (std::size_t i = 0; i < packs->size(); ++i) {
    const std::string place = "/packs/" + std::to_string(i);
    if (!(*packs)[i].is_string()) {
      wrong(place, place, "name", (*packs)[i]);
      continue;
    }
    program_.packs.push_back((*packs)[i].get<std::string>());
  }
}

void Reader::read(const Json& root) {
  if (!root.is_object()) return fault("/", messages::program_not_object);
  const Json* workspace = &root;
  const Json* inner = find_field(root, "workspace");
  if (inner || find_field(root, "format")) {
    read_envelope(root);
    if (!inner) return fault("/workspace", messages::workspace_missing);
    if (!inner->is_object()) return wrong("/workspace", "/workspace", "{...}", *inner);
    workspace = inner;
  }
  read_variables(*workspace);
  read_tops(*workspace);
}

void Reader::read_variables(const Json& workspace) {
  const Json* variables = find_field(workspace, "variables");
  if (!variables) return;
  if (!variables->is_array()) return wrong("/workspace/variables", "variables", "[...]", *variables);
  for (std::size_t i = 0; i < variables->size(); ++i) {
    const Json& json = (*variables)[i];
    const std::string place = "/workspace/variables/" + std::to_string(i);
    const Json* id = find_field(json, "id");
    const Json* name = find_field(json, "name");
    if (!id || !id->is_string() || !name || !name->is_string()) {
      wrong(place, place, "{name, id, type}", json);
      continue;
    }
    Variable variable{
        .id = *id, .name = *name, .initial = {.name = {}, .value = "0", .id = {}, .is_number = true}};
    const std::string type = text_at(json, "type");
    if (type == "list") variable.kind = VariableKind::list;
    if (type == "broadcast_msg") variable.kind = VariableKind::message;
    if (!type.empty() && variable.kind == VariableKind::scalar) {
      fault(place, messages::wrong_choice,
            {{"field", "type"}, {"choices", "\"\", list, broadcast_msg"}, {"value", type}});
    }
    program_.variables.push_back(std::move(variable));
  }
}

void Reader::read_tops(const Json& workspace) {
  const Json* blocks = find_field(workspace, "blocks");
  if (!blocks) {
    // Blockly leaves the field out of an empty workspace; then variables, or nothing at all, may stand alone.
    if (!workspace.empty() && !find_field(workspace, "variables")) {
      fault("/workspace/blocks", messages::workspace_missing);
    }
    return;
  }
  const Json* list = blocks->is_object() ? find_field(*blocks, "blocks") : blocks;
  if (!list) return;
  if (!list->is_array()) return wrong("/workspace/blocks", "blocks", "[...]", *list);
  for (std::size_t i = 0; i < list->size(); ++i) {
    const std::string path = "/workspace/blocks/blocks/" + std::to_string(i);
    const BlockIndex top = add_block((*list)[i], kNone, kNone, false, path);
    if (top != kNone) program_.tops.push_back(top);
  }
  while (!tasks_.empty()) {
    const Task task = std::move(tasks_.back());
    tasks_.pop_back();
    fill(task);
  }
}

BlockIndex Reader::add_block(const Json& json, BlockIndex parent, BlockIndex enclosing, bool shadow,
                             const std::string& path) {
  const Json* type = find_field(json, "type");
  if (!type || !type->is_string()) {
    wrong(path, path, "{type, id}", json);
    return kNone;
  }
  const auto index = static_cast<BlockIndex>(program_.blocks.size());
  Block& block = program_.blocks.emplace_back();
  block.opcode = type->get<std::string>();
  block.id = text_at(json, "id");
  if (block.id.empty()) block.id = "#" + std::to_string(index);
  block.parent = parent;
  block.enclosing = enclosing;
  block.is_shadow = shadow;
  const auto [known, fresh] = program_.by_id.emplace(block.id, index);
  if (!fresh && !(shadow && program_.at(known->second).is_shadow)) {
    fault(block.id, messages::duplicate_id, {{"id", block.id}});
  }
  tasks_.push_back({&json, index});
  return index;
}

void Reader::fill(const Task& task) {
  const Json& json = *task.json;
  const std::string place = program_.at(task.index).id;
  if (const Json* enabled = find_field(json, "enabled");
      enabled && enabled->is_boolean() && !enabled->get<bool>()) {
    program_.at(task.index).disabled = true;
  }
  if (const Json* reasons = find_field(json, "disabledReasons");
      reasons && reasons->is_array() && !reasons->empty()) {
    program_.at(task.index).disabled = true;
  }
  read_fields(json, task.index, place);
  read_signature(json, task.index, place);
  read_inputs(task);
  const Json* next = find_field(json, "next");
  if (!next) return;
  const Json* block = find_field(*next, "block");
  if (!block) return wrong(place, "next", "{block}", *next);
  const BlockIndex follower =
      add_block(*block, task.index, program_.at(task.index).enclosing, false, place + "/next");
  program_.at(task.index).next = follower;
}

void Reader::read_fields(const Json& json, BlockIndex index, const std::string& place) {
  const Json* fields = find_field(json, "fields");
  if (!fields) return;
  if (!fields->is_object()) return wrong(place, "fields", "{...}", *fields);
  for (const auto& [name, value] : fields->items()) {
    Field field{.name = name, .value = plain_text(value), .id = {}, .is_number = value.is_number()};
    if (value.is_object()) {
      field.id = text_at(value, "id");
      field.value = text_at(value, "name");
    } else if (value.is_array()) {
      wrong(place, name, "text", value);
    }
    program_.at(index).fields.push_back(std::move(field));
  }
}

void Reader::read_inputs(const Task& task) {
  const std::string place = program_.at(task.index).id;
  const Json* inputs = find_field(*task.json, "inputs");
  if (!inputs) return;
  if (!inputs->is_object()) return wrong(place, "inputs", "{...}", *inputs);
  for (const auto& [name, value] : inputs->items()) {
    Input input{.name = name};
    const std::string path = place + "/inputs/" + name;
    const Json* shadow = find_field(value, "shadow");
    const Json* block = find_field(value, "block");
    if (shadow) input.shadow = add_block(*shadow, task.index, task.index, true, path + "/shadow");
    if (block) input.block = add_block(*block, task.index, task.index, false, path + "/block");
    if (!shadow && !block) wrong(place, name, "{shadow, block}", value);
    program_.at(task.index).inputs.push_back(std::move(input));
  }
}

void Reader::read_signature(const Json& json, BlockIndex index, const std::string& place) {
  const std::string& opcode = program_.at(index).opcode;
  if (opcode != "procedures_definition" && opcode != "procedures_call" && opcode != "procedures_call_value")
    return;
  const Json* state = find_field(json, "extraState");
  if (!state || !state->is_object()) return fault(place, messages::signature_missing);
  Signature signature{.id = text_at(*state, "id"), .name = text_at(*state, "name"), .params = {}};
  const auto flag = [&](const char* name) {
    const Json* value = find_field(*state, name);
    if (value && !value->is_boolean()) wrong(place, name, "true|false", *value);
    return value && value->is_boolean() && value->get<bool>();
  };
  signature.returns = flag("returns");
  signature.warp = flag("warp");
  if (signature.id.empty()) fault(place, messages::signature_missing);
  const Json* params = find_field(*state, "params");
  if (params && !params->is_array()) wrong(place, "params", "[...]", *params);
  for (std::size_t i = 0; params && params->is_array() && i < params->size(); ++i) {
    const Json& param = (*params)[i];
    Parameter parameter{.id = text_at(param, "id"), .name = text_at(param, "name")};
    const std::string type = text_at(param, "type");
    if (type == "text") parameter.type = ParamType::text;
    if (type == "boolean") parameter.type = ParamType::truth;
    if (parameter.id.empty() || parameter.name.empty() ||
        (parameter.type == ParamType::number && type != "number")) {
      wrong(place, "params/" + std::to_string(i), "{id, name, type: number|text|boolean}", param);
    }
    signature.params.push_back(std::move(parameter));
  }
  program_.at(index).signature = static_cast<std::int32_t>(program_.signatures.size());
  program_.signatures.push_back(std::move(signature));
}

}  // namespace

ReadProgram read_blockly(std::string_view json_text) {
  ReadProgram out;
  if (json_text.size() > limits::kProgramBytes) {
    out.faults.push_back(make_fault(
        "", messages::program_too_large,
        {{"bytes", std::to_string(json_text.size())}, {"limit", std::to_string(limits::kProgramBytes)}}));
    return out;
  }
  const Result<Json> root = parse_json(json_text, "");
  if (!root) {
    out.faults = root.faults();
    return out;
  }
  Reader(out).read(*root);
  return out;
}

}  // namespace mirada::vm
