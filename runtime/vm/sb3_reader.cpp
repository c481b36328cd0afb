// A Scratch 3 project (project.json) as the same tree that the editor's programs become.
#include <algorithm>
#include <set>

#include <nlohmann/json.hpp>

#include "vm/messages.h"
#include "vm/numbers.h"
#include "vm/reader.h"
#include "vm/scratch_blocks.h"

namespace mirada::vm {
namespace {

// Scripts start in the order in which the file lists them, so its order must be kept.
using Json = nlohmann::ordered_json;

std::string plain_text(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "true" : "false";
  if (value.is_number()) return number_to_string(value.get<double>());
  return {};
}

const Json* find(const Json& object, const char* name) {
  if (!object.is_object()) return nullptr;
  const auto it = object.find(name);
  return it == object.end() ? nullptr : &*it;
}

std::string text_at(const Json& object, const char* name) {
  const Json* value = find(object, name);
  return value ? plain_text(*value) : std::string();
}

class ProjectReader {
 public:
  explicit ProjectReader(ReadProgram& out) : out_(out), program_(out.program) {}
  void read(const Json& root);

 private:
  struct Task {
    const Json* json;
    BlockIndex index;
    std::string id;
  };
  void fault(std::string place, const Message& message, MessageArgs args = {}) {
    out_.faults.push_back(make_fault(std::move(place), message, std::move(args)));
  }
  void read_variables(const Json& target);
  void read_scripts(const Json& target);
  void add_variable(const std::string& id, const std::string& name, VariableKind kind);
  std::string variable_id(const std::string& name, const std::string& id, VariableKind kind);
  BlockIndex add_block(const std::string& id, BlockIndex parent, BlockIndex enclosing);
  BlockIndex add_literal(std::string text, BlockIndex parent);
  BlockIndex add_named(const char* opcode, const char* field, const Json& primitive, VariableKind kind,
                       BlockIndex parent);
  BlockIndex add_content(const Json& content, BlockIndex parent);
  void fill(const Task& task);
  void read_fields(const Json& json, BlockIndex index);
  void read_inputs(const Json& json, BlockIndex index);
  void read_broadcast(const Json& value, BlockIndex index);
  void read_definition(const Json& json, BlockIndex index);
  void read_call(const Json& json, BlockIndex index);
  void find_cloned();

  ReadProgram& out_;
  Program& program_;
  std::int32_t sprite_ = 0;
  std::unordered_map<std::string, const Json*> blocks_;  // of this sprite
  std::set<std::string> reached_;
  std::vector<Task> tasks_;
};

void ProjectReader::read(const Json& root) {
  const Json* targets = find(root, "targets");
  if (!targets || !targets->is_array()) return fault("/targets", messages::workspace_missing);
  program_.from_scratch = true;
  program_.scratch_blocks = scratch_blocks();
  std::vector<const Json*> ordered;
  for (const Json& target : *targets) {
    if (target.is_object()) ordered.push_back(&target);
  }
  const auto layer = [](const Json* target) {
    const Json* stage = find(*target, "isStage");
    if (stage && stage->is_boolean() && stage->get<bool>()) return -1.0;
    const Json* order = find(*target, "layerOrder");
    return order && order->is_number() ? order->get<double>() : 0.0;
  };
  std::stable_sort(ordered.begin(), ordered.end(),
                   [&](const Json* a, const Json* b) { return layer(a) < layer(b); });
  program_.sprites.clear();
  for (const Json* target : ordered) {
    const bool stage = layer(target) < 0;
    program_.sprites.push_back({stage ? "" : text_at(*target, "name"), stage, false});
  }
  if (program_.sprites.empty()) program_.sprites.emplace_back();
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    sprite_ = static_cast<std::int32_t>(i);
    read_variables(*ordered[i]);
  }
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    sprite_ = static_cast<std::int32_t>(i);
    read_scripts(*ordered[i]);
  }
  find_cloned();
}

void ProjectReader::add_variable(const std::string& id, const std::string& name, VariableKind kind) {
  const bool shared = program_.sprites[static_cast<std::size_t>(sprite_)].is_stage;
  Variable variable{.id = (shared ? "" : std::to_string(sprite_) + "/") + id, .name = name, .kind = kind};
  variable.sprite = sprite_;
  variable.initial.value = "0";
  variable.initial.is_number = true;
  program_.variables.push_back(std::move(variable));
}

void ProjectReader::read_variables(const Json& target) {
  const auto literal = [](const Json& value) {
    return Field{.name = {}, .value = plain_text(value), .id = {}, .is_number = value.is_number()};
  };
  if (const Json* variables = find(target, "variables"); variables && variables->is_object()) {
    for (const auto& [id, value] : variables->items()) {
      if (!value.is_array() || value.size() < 2) continue;
      add_variable(id, plain_text(value[0]), VariableKind::scalar);
      program_.variables.back().initial = literal(value[1]);
    }
  }
  const Json* lists = find(target, "lists");
  if (!lists || !lists->is_object()) return;
  for (const auto& [id, value] : lists->items()) {
    if (!value.is_array() || value.size() < 2 || !value[1].is_array()) continue;
    add_variable(id, plain_text(value[0]), VariableKind::list);
    for (const Json& item : value[1]) program_.variables.back().initial_items.push_back(literal(item));
  }
}

/// The variable that a block of this sprite means: its own or everybody's, by id or else by name. A missing
/// one is made, as Scratch does.
std::string ProjectReader::variable_id(const std::string& name, const std::string& id, VariableKind kind) {
  const std::string own = std::to_string(sprite_) + "/" + id;
  const Variable* by_name = nullptr;
  for (const Variable& variable : program_.variables) {
    if (variable.kind != kind) continue;
    if (variable.id == own || variable.id == id) return variable.id;
    const bool visible = variable.sprite == sprite_ || variable.sprite == 0;
    if (visible && variable.name == name && (!by_name || variable.sprite == sprite_)) by_name = &variable;
  }
  if (by_name) return by_name->id;
  add_variable(id.empty() ? name : id, name, kind);
  return program_.variables.back().id;
}

void ProjectReader::read_scripts(const Json& target) {
  const Json* blocks = find(target, "blocks");
  if (!blocks || !blocks->is_object()) return;
  blocks_.clear();
  reached_.clear();
  for (const auto& [id, json] : blocks->items()) blocks_.emplace(id, &json);
  for (const auto& [id, json] : blocks->items()) {
    const Json* top = find(json, "topLevel");
    if (!top || !top->is_boolean() || !top->get<bool>()) continue;
    const BlockIndex index = add_block(id, kNone, kNone);
    if (index != kNone) program_.tops.push_back(index);
    for (std::size_t next = 0; next < tasks_.size(); ++next) fill(Task(tasks_[next]));
    tasks_.clear();
  }
}

BlockIndex ProjectReader::add_block(const std::string& id, BlockIndex parent, BlockIndex enclosing) {
  const auto it = blocks_.find(id);
  const std::string around = parent == kNone ? std::string() : program_.at(parent).id;
  if (it == blocks_.end()) {
    fault(around, messages::dangling_block, {{"id", id}});
    return kNone;
  }
  if (!it->second->is_object()) return kNone;
  if (!reached_.insert(id).second) {
    fault(id, messages::block_cycle);
    return kNone;
  }
  const auto index = static_cast<BlockIndex>(program_.blocks.size());
  Block& block = program_.blocks.emplace_back();
  block.id = program_.by_id.contains(id) ? id + "@" + std::to_string(sprite_) : id;
  block.opcode = text_at(*it->second, "opcode");
  block.parent = parent;
  block.enclosing = enclosing;
  block.sprite = sprite_;
  const Json* shadow = find(*it->second, "shadow");
  block.is_shadow = shadow && shadow->is_boolean() && shadow->get<bool>();
  program_.by_id.emplace(block.id, index);
  tasks_.push_back({it->second, index, id});
  return index;
}

BlockIndex ProjectReader::add_literal(std::string text, BlockIndex parent) {
  const auto index = static_cast<BlockIndex>(program_.blocks.size());
  Block& block = program_.blocks.emplace_back();
  block.id = program_.at(parent).id + "/" + std::to_string(index);
  block.opcode = "text";
  block.fields.push_back({.name = "TEXT", .value = std::move(text)});
  block.parent = block.enclosing = parent;
  block.is_shadow = true;
  block.sprite = sprite_;
  return index;
}

BlockIndex ProjectReader::add_named(const char* opcode, const char* field, const Json& primitive,
                                    VariableKind kind, BlockIndex parent) {
  const std::string name = primitive.size() > 1 ? plain_text(primitive[1]) : "";
  const std::string id = primitive.size() > 2 ? plain_text(primitive[2]) : "";
  const BlockIndex index = add_literal("", parent);
  Block& block = program_.at(index);
  block.opcode = opcode;
  block.is_shadow = false;
  block.fields = {{.name = field, .value = name, .id = variable_id(name, id, kind)}};
  program_.by_id.emplace(block.id, index);
  return index;
}

/// What stands in a socket: a block's id, or a compressed literal, variable, list or message.
BlockIndex ProjectReader::add_content(const Json& content, BlockIndex parent) {
  if (content.is_string()) return add_block(content.get<std::string>(), parent, parent);
  if (!content.is_array() || content.size() < 2 || !content[0].is_number()) return kNone;
  const int kind = content[0].get<int>();
  if (kind == 12) return add_named("data_variable", "VARIABLE", content, VariableKind::scalar, parent);
  if (kind == 13) return add_named("data_listcontents", "LIST", content, VariableKind::list, parent);
  return add_literal(plain_text(content[1]), parent);
}

void ProjectReader::fill(const Task& task) {
  const Json& json = *task.json;
  read_fields(json, task.index);
  const std::string opcode = program_.at(task.index).opcode;
  if (opcode == "procedures_definition") {
    read_definition(json, task.index);
  } else {
    if (opcode == "procedures_call") read_call(json, task.index);
    read_inputs(json, task.index);
  }
  // A menu's shadow is the text of its only field.
  Block& block = program_.at(task.index);
  if (block.is_shadow && block.fields.size() == 1 && !block.opcode.starts_with("argument_reporter") &&
      block.opcode != "text" && !block.opcode.starts_with("math_")) {
    block.opcode = "text";
    block.fields[0].name = "TEXT";
  }
  const Json* next = find(json, "next");
  if (!next || !next->is_string()) return;
  const BlockIndex follower =
      add_block(next->get<std::string>(), task.index, program_.at(task.index).enclosing);
  program_.at(task.index).next = follower;
}

void ProjectReader::read_fields(const Json& json, BlockIndex index) {
  const Json* fields = find(json, "fields");
  if (!fields || !fields->is_object()) return;
  for (const auto& [name, value] : fields->items()) {
    if (!value.is_array() || value.empty()) continue;
    Field field{.name = name, .value = plain_text(value[0])};
    const std::string id = value.size() > 1 ? plain_text(value[1]) : "";
    if (name == "VARIABLE") field.id = variable_id(field.value, id, VariableKind::scalar);
    if (name == "LIST") field.id = variable_id(field.value, id, VariableKind::list);
    program_.at(index).fields.push_back(std::move(field));
  }
}

void ProjectReader::read_inputs(const Json& json, BlockIndex index) {
  const Json* inputs = find(json, "inputs");
  if (!inputs || !inputs->is_object()) return;
  for (const auto& [name, value] : inputs->items()) {
    if (!value.is_array() || value.size() < 2) continue;
    if (name == "BROADCAST_INPUT" && value[1].is_array() && value[1].size() > 1 && value[1][0] == 11) {
      read_broadcast(value[1], index);
      continue;
    }
    Input input{.name = name};
    const bool shadow = value[0] == 1;
    const BlockIndex content = value[1].is_null() ? kNone : add_content(value[1], index);
    (shadow ? input.shadow : input.block) = content;
    if (!shadow && value.size() > 2 && value[2].is_array()) input.shadow = add_content(value[2], index);
    program_.at(index).inputs.push_back(std::move(input));
  }
}

void ProjectReader::read_broadcast(const Json& value, BlockIndex index) {
  program_.at(index).fields.push_back({.name = "BROADCAST_INPUT", .value = plain_text(value[1])});
}

namespace {

std::vector<std::string> text_list(const Json& mutation, const char* name) {
  std::vector<std::string> out;
  const Json parsed = Json::parse(text_at(mutation, name), nullptr, false);
  if (!parsed.is_array()) return out;
  for (const Json& item : parsed) out.push_back(plain_text(item));
  return out;
}

}  // namespace

void ProjectReader::read_definition(const Json& json, BlockIndex index) {
  const Json* inputs = find(json, "inputs");
  const Json* head = inputs ? find(*inputs, "custom_block") : nullptr;
  const bool named = head && head->is_array() && head->size() > 1 && (*head)[1].is_string();
  const auto it = named ? blocks_.find((*head)[1].get<std::string>()) : blocks_.end();
  const Json* mutation = it == blocks_.end() ? nullptr : find(*it->second, "mutation");
  if (!mutation) return fault(program_.at(index).id, messages::signature_missing);
  Signature signature;
  signature.id = signature.name = text_at(*mutation, "proccode");
  signature.warp = text_at(*mutation, "warp") == "true";
  const std::vector<std::string> ids = text_list(*mutation, "argumentids");
  const std::vector<std::string> names = text_list(*mutation, "argumentnames");
  for (std::size_t i = 0; i < std::min(ids.size(), names.size()); ++i) {
    signature.params.push_back({ids[i], names[i], ParamType::raw});
  }
  program_.at(index).signature = static_cast<std::int32_t>(program_.signatures.size());
  program_.signatures.push_back(std::move(signature));
}

void ProjectReader::read_call(const Json& json, BlockIndex index) {
  const Json* mutation = find(json, "mutation");
  if (!mutation) return fault(program_.at(index).id, messages::signature_missing);
  Signature signature;
  signature.id = signature.name = text_at(*mutation, "proccode");
  program_.at(index).signature = static_cast<std::int32_t>(program_.signatures.size());
  program_.signatures.push_back(std::move(signature));
}

/// Which sprites some block may clone. One that names its sprite by a reporter may clone any.
void ProjectReader::find_cloned() {
  for (const Block& block : program_.blocks) {
    if (block.opcode != "control_create_clone_of") continue;
    const Input* option = block.input("CLONE_OPTION");
    const BlockIndex content = option ? option->content() : kNone;
    const bool fixed = content != kNone && program_.at(content).opcode == "text";
    const std::string name = fixed ? program_.at(content).fields.front().value : "";
    for (std::size_t i = 0; i < program_.sprites.size(); ++i) {
      Sprite& sprite = program_.sprites[i];
      const bool itself = name == "_myself_" && block.sprite == static_cast<std::int32_t>(i);
      if (!sprite.is_stage && (!fixed || itself || sprite.name == name)) sprite.is_cloned = true;
    }
  }
}

}  // namespace

ReadProgram read_scratch_project(std::string_view json_text) {
  ReadProgram out;
  Json root;
  try {
    root = Json::parse(json_text);
  } catch (const Json::parse_error& error) {
    out.faults.push_back(make_fault("", messages::project_broken, {{"byte", std::to_string(error.byte)}}));
    return out;
  } catch (const Json::exception&) {
    out.faults.push_back(make_fault("", messages::project_broken, {{"byte", "-"}}));
    return out;
  }
  ProjectReader(out).read(root);
  return out;
}

}  // namespace mirada::vm
