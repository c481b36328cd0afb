#include "vm/json_tree.h"
#include "vm/messages.h"
#include "vm/reader.h"

namespace mirada::vm {
namespace {

class Reader {
 public:
  explicit Reader(ReadProgram& out) : out_(out), program_(out.program) {}

  void read(JsonValue root);

 private:
  /// One block of the file still to be read, and where it hangs.
  struct Task {
    JsonValue json;
    BlockIndex index;
  };

  void fault(std::string place, const Message& message, MessageArgs args = {}) {
    out_.faults.push_back(make_fault(std::move(place), message, std::move(args)));
  }
  void wrong(const std::string& place, const std::string& field, const char* expected, JsonValue value) {
    fault(place, messages::wrong_shape,
          {{"field", field}, {"expected", expected}, {"value", shown_json(value)}});
  }
  void read_envelope(JsonValue root);
  void read_variables(JsonValue workspace);
  void read_tops(JsonValue workspace);
  BlockIndex add_block(JsonValue json, BlockIndex parent, BlockIndex enclosing, bool shadow,
                       const std::string& path);
  void fill(const Task& task);
  void read_fields(JsonValue json, BlockIndex index, const std::string& place);
  void read_inputs(const Task& task);
  void read_signature(JsonValue json, BlockIndex index, const std::string& place);

  ReadProgram& out_;
  Program& program_;
  std::vector<Task> tasks_;
};

void Reader::read_envelope(JsonValue root) {
  program_.name = plain_text(root.find("name"));
  if (const JsonValue version = root.find("version");
      version && (!version.is_number() || version.number() != 1)) {
    fault("/version", messages::wrong_version, {{"value", shown_json(version)}});
  }
  const JsonValue packs = root.find("packs");
  if (!packs) return;
  if (!packs.is_array()) return wrong("/packs", "/packs", "[name, ...]", packs);
  std::size_t number = 0;
  for (const JsonValue pack : packs) {
    const std::string place = "/packs/" + std::to_string(number++);
    if (pack.is_text()) {
      program_.packs.emplace_back(pack.text());
    } else {
      wrong(place, place, "name", pack);
    }
  }
}

void Reader::read(JsonValue root) {
  if (!root.is_object()) return fault("/", messages::program_not_object);
  JsonValue workspace = root;
  const JsonValue inner = root.find("workspace");
  if (inner || root.find("format")) {
    read_envelope(root);
    if (!inner) return fault("/workspace", messages::workspace_missing);
    if (!inner.is_object()) return wrong("/workspace", "/workspace", "{...}", inner);
    workspace = inner;
  } else if (root.empty()) {
    return fault("/workspace",
                 messages::workspace_missing);  // an empty workspace is a program, nothing is none
  }
  read_variables(workspace);
  read_tops(workspace);
}

void Reader::read_variables(JsonValue workspace) {
  const JsonValue variables = workspace.find("variables");
  if (!variables) return;
  if (!variables.is_array()) return wrong("/workspace/variables", "variables", "[...]", variables);
  std::size_t number = 0;
  for (const JsonValue json : variables) {
    const std::string place = "/workspace/variables/" + std::to_string(number++);
    const JsonValue id = json.find("id");
    const JsonValue name = json.find("name");
    if (!id.is_text() || !name.is_text()) {
      wrong(place, place, "{name, id, type}", json);
      continue;
    }
    Variable variable{.id = plain_text(id),
                      .name = plain_text(name),
                      .initial = {.name = {}, .value = "0", .id = {}, .is_number = true}};
    const std::string type = plain_text(json.find("type"));
    if (type == "list") variable.kind = VariableKind::list;
    if (type == "broadcast_msg") variable.kind = VariableKind::message;
    if (!type.empty() && variable.kind == VariableKind::scalar) {
      fault(place, messages::wrong_choice,
            {{"field", "type"}, {"choices", "\"\", list, broadcast_msg"}, {"value", type}});
    }
    program_.variables.push_back(std::move(variable));
  }
}

void Reader::read_tops(JsonValue workspace) {
  const JsonValue blocks = workspace.find("blocks");
  if (!blocks) {
    // Blockly leaves the field out of an empty workspace; then variables, or nothing at all, may stand alone.
    if (!workspace.empty() && !workspace.find("variables")) {
      fault("/workspace/blocks", messages::workspace_missing);
    }
    return;
  }
  const JsonValue list = blocks.is_object() ? blocks.find("blocks") : blocks;
  if (!list) return;
  if (!list.is_array()) return wrong("/workspace/blocks", "blocks", "[...]", list);
  std::size_t number = 0;
  for (const JsonValue json : list) {
    const std::string path = "/workspace/blocks/blocks/" + std::to_string(number++);
    const BlockIndex top = add_block(json, kNone, kNone, false, path);
    if (top != kNone) program_.tops.push_back(top);
  }
  while (!tasks_.empty()) {
    const Task task = std::move(tasks_.back());
    tasks_.pop_back();
    fill(task);
  }
}

BlockIndex Reader::add_block(JsonValue json, BlockIndex parent, BlockIndex enclosing, bool shadow,
                             const std::string& path) {
  const JsonValue type = json.find("type");
  if (!type.is_text()) {
    wrong(path, path, "{type, id}", json);
    return kNone;
  }
  const auto index = static_cast<BlockIndex>(program_.blocks.size());
  Block& block = program_.blocks.emplace_back();
  block.opcode = type.text();
  block.id = plain_text(json.find("id"));
  if (block.id.empty()) block.id = "#" + std::to_string(index);
  block.parent = parent;
  block.enclosing = enclosing;
  block.is_shadow = shadow;
  const auto [known, fresh] = program_.by_id.emplace(block.id, index);
  if (!fresh && !(shadow && program_.at(known->second).is_shadow)) {
    fault(block.id, messages::duplicate_id, {{"id", block.id}});
  }
  tasks_.push_back({json, index});
  return index;
}

void Reader::fill(const Task& task) {
  const JsonValue json = task.json;
  const std::string place = program_.at(task.index).id;
  if (const JsonValue enabled = json.find("enabled"); enabled.is_truth() && !enabled.truth()) {
    program_.at(task.index).disabled = true;
  }
  if (const JsonValue reasons = json.find("disabledReasons"); reasons.is_array() && !reasons.empty()) {
    program_.at(task.index).disabled = true;
  }
  read_fields(json, task.index, place);
  read_signature(json, task.index, place);
  read_inputs(task);
  const JsonValue next = json.find("next");
  if (!next) return;
  const JsonValue block = next.find("block");
  if (!block) return wrong(place, "next", "{block}", next);
  const BlockIndex follower =
      add_block(block, task.index, program_.at(task.index).enclosing, false, place + "/next");
  program_.at(task.index).next = follower;
}

void Reader::read_fields(JsonValue json, BlockIndex index, const std::string& place) {
  const JsonValue fields = json.find("fields");
  if (!fields) return;
  if (!fields.is_object()) return wrong(place, "fields", "{...}", fields);
  for (const JsonValue value : fields.fields()) {
    const std::string name(value.key());
    Field field{.name = name, .value = plain_text(value), .id = {}, .is_number = value.is_number()};
    if (value.is_object()) {
      field.id = plain_text(value.find("id"));
      field.value = plain_text(value.find("name"));
    } else if (value.is_array()) {
      wrong(place, name, "text", value);
    }
    program_.at(index).fields.push_back(std::move(field));
  }
}

void Reader::read_inputs(const Task& task) {
  const std::string place = program_.at(task.index).id;
  const JsonValue inputs = task.json.find("inputs");
  if (!inputs) return;
  if (!inputs.is_object()) return wrong(place, "inputs", "{...}", inputs);
  for (const JsonValue value : inputs.fields()) {
    const std::string name(value.key());
    Input input{.name = name};
    const std::string path = place + "/inputs/" + name;
    const JsonValue shadow = value.find("shadow");
    const JsonValue block = value.find("block");
    if (shadow) input.shadow = add_block(shadow, task.index, task.index, true, path + "/shadow");
    if (block) input.block = add_block(block, task.index, task.index, false, path + "/block");
    if (!shadow && !block) wrong(place, name, "{shadow, block}", value);
    program_.at(task.index).inputs.push_back(std::move(input));
  }
}

void Reader::read_signature(JsonValue json, BlockIndex index, const std::string& place) {
  const std::string& opcode = program_.at(index).opcode;
  if (opcode != "procedures_definition" && opcode != "procedures_call" && opcode != "procedures_call_value")
    return;
  const JsonValue state = json.find("extraState");
  if (!state.is_object()) return fault(place, messages::signature_missing);
  Signature signature{
      .id = plain_text(state.find("id")), .name = plain_text(state.find("name")), .params = {}};
  const auto flag = [&](const char* name) {
    const JsonValue value = state.find(name);
    if (value && !value.is_truth()) wrong(place, name, "true|false", value);
    return value.truth();
  };
  signature.returns = flag("returns");
  signature.warp = flag("warp");
  if (signature.id.empty()) fault(place, messages::signature_missing);
  JsonValue params = state.find("params");
  if (params && !params.is_array()) {
    wrong(place, "params", "[...]", params);
    params = {};
  }
  for (const JsonValue param : params) {
    Parameter parameter{.id = plain_text(param.find("id")), .name = plain_text(param.find("name"))};
    const std::string type = plain_text(param.find("type"));
    if (type == "text") parameter.type = ParamType::text;
    if (type == "boolean") parameter.type = ParamType::truth;
    if (parameter.id.empty() || parameter.name.empty() ||
        (parameter.type == ParamType::number && type != "number")) {
      wrong(place, "params/" + std::to_string(signature.params.size()),
            "{id, name, type: number|text|boolean}", param);
    }
    signature.params.push_back(std::move(parameter));
  }
  program_.at(index).signature = static_cast<std::int32_t>(program_.signatures.size());
  program_.signatures.push_back(std::move(signature));
}

}  // namespace

ReadProgram read_blockly(JsonValue root) {
  ReadProgram out;
  Reader(out).read(root);
  return out;
}

}  // namespace mirada::vm
