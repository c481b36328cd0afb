// The blocks of one target of a Scratch project.
#include <algorithm>
#include <cctype>

#include "vm/messages.h"
#include "vm/sb3_reader.h"

namespace mirada::vm {
namespace {

/// What the first number of a compressed socket says (Scratch's sb3 format); 4 to 10 are literals.
constexpr double kMessagePrimitive = 11;
constexpr double kVariablePrimitive = 12;
constexpr double kListPrimitive = 13;
constexpr double kFirstPrimitive = 4;

bool is_literal_opcode(const std::string& opcode) { return opcode == "text" || opcode.starts_with("math_"); }

std::string lower_ascii(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// JavaScript goes through keys that are whole numbers first, from the smallest.
bool is_index(std::string_view key) {
  if (key.empty() || key.size() > 9 || (key[0] == '0' && key.size() > 1)) return false;
  return std::all_of(key.begin(), key.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::vector<std::string_view> in_order_of_javascript(JsonValue object) {
  std::vector<std::string_view> keys;
  std::unordered_set<std::string_view> seen;
  for (const JsonValue field : object) {
    if (seen.insert(field.key()).second) keys.push_back(field.key());
  }
  const auto middle = std::stable_partition(keys.begin(), keys.end(), is_index);
  std::sort(keys.begin(), middle, [](std::string_view a, std::string_view b) {
    return std::pair(a.size(), a) < std::pair(b.size(), b);
  });
  return keys;
}

}  // namespace

/// Scripts start in the order in which the file lists their heads.
void ProjectReader::read_scripts(const Target& target) {
  path_ = target.path + "/blocks";
  const JsonValue blocks = object_field(target.json, "blocks", target.path);
  blocks_.clear();
  reached_.clear();
  for (const JsonValue json : blocks) {
    // A list is a variable or list reporter that lies about by itself.
    if (json.is_object()) {
      blocks_.insert_or_assign(json.key(), json);
    } else if (!json.is_array()) {
      wrong(path_ + "/" + std::string(json.key()), "{opcode, ...}", json);
    }
  }
  for (const std::string_view id : in_order_of_javascript(blocks)) {
    const auto it = blocks_.find(id);
    if (it == blocks_.end() || !it->second.find("topLevel").truth()) continue;
    const BlockIndex index = add_block(std::string(id), kNone, kNone);
    if (index != kNone) program_.tops.push_back(index);
    for (std::size_t next = 0; next < tasks_.size(); ++next) fill(Task(tasks_[next]));
    tasks_.clear();
  }
}

/// The block with this id, at the place where another names it. One that is not there, or that hangs
/// somewhere already, is left out and said: the rest can run.
BlockIndex ProjectReader::add_block(const std::string& id, BlockIndex parent, BlockIndex enclosing) {
  const auto it = blocks_.find(id);
  if (it == blocks_.end()) {
    warning(parent == kNone ? path_ : program_.at(parent).id, messages::dangling_block, {{"id", id}});
    return kNone;
  }
  if (!reached_.insert(id).second) {
    warning(parent == kNone ? id : program_.at(parent).id, messages::block_cycle, {{"id", id}});
    return kNone;
  }
  const JsonValue json = it->second;
  const JsonValue opcode = json.find("opcode");
  if (!opcode.is_text()) wrong(path_ + "/" + id + "/opcode", "text", opcode);
  const auto index = static_cast<BlockIndex>(program_.blocks.size());
  Block& block = program_.blocks.emplace_back();
  block.id = id;
  while (program_.by_id.contains(block.id)) block.id += "@" + std::to_string(sprite_);
  block.opcode = plain_text(opcode);
  block.parent = parent;
  block.enclosing = enclosing;
  block.sprite = sprite_;
  block.is_shadow = json.find("shadow").truth();
  program_.by_id.emplace(block.id, index);
  tasks_.push_back({json, index});
  return index;
}

BlockIndex ProjectReader::add_literal(JsonValue value, BlockIndex parent) {
  const auto index = static_cast<BlockIndex>(program_.blocks.size());
  Block& block = program_.blocks.emplace_back();
  block.id = program_.at(parent).id + "/" + std::to_string(index);
  block.opcode = "text";
  block.fields.push_back(
      {.name = "TEXT", .value = plain_text(value), .id = {}, .is_number = value.is_number()});
  block.parent = block.enclosing = parent;
  block.is_shadow = true;
  block.sprite = sprite_;
  return index;
}

BlockIndex ProjectReader::add_named(const char* opcode, const char* field, JsonValue primitive,
                                    VariableKind kind, BlockIndex parent) {
  const std::string name = plain_text(primitive[1]);
  const std::string id = primitive.size() > 2 ? plain_text(primitive[2]) : "";
  const BlockIndex index = add_literal(JsonValue(), parent);
  Block& block = program_.at(index);
  block.opcode = opcode;
  block.is_shadow = false;
  block.fields = {{.name = field, .value = name, .id = variable_id(name, id, kind)}};
  program_.by_id.emplace(block.id, index);
  return index;
}

/// What stands in a socket: nothing, a block's id, or a compressed literal, variable, list or message.
BlockIndex ProjectReader::add_content(JsonValue content, const Task& task, std::string_view name) {
  const BlockIndex parent = task.index;
  if (content.is_null()) return kNone;
  if (content.is_text()) return add_block(plain_text(content), parent, parent);
  const bool primitive = content.is_array() && content.size() >= 2 && content[0].is_number();
  const double kind = primitive ? content[0].number() : 0;
  if (!(kind >= kFirstPrimitive && kind <= kListPrimitive) || content[1].is_structured()) {
    wrong(path_of(task) + "/inputs/" + std::string(name), "id | [4..13, value]", content);
    return kNone;
  }
  if (kind == kVariablePrimitive) {
    return add_named("data_variable", "VARIABLE", content, VariableKind::scalar, parent);
  }
  if (kind == kListPrimitive) {
    return add_named("data_listcontents", "LIST", content, VariableKind::list, parent);
  }
  return add_literal(content[1], parent);
}

void ProjectReader::fill(const Task& task) {
  read_fields(task);
  const std::string opcode = program_.at(task.index).opcode;
  if (opcode == "procedures_definition") {
    read_definition(task);
  } else {
    if (opcode == "procedures_call") read_call(task);
    read_inputs(task);
  }
  settle(program_.at(task.index));
  read_next(task);
}

/// Blocks whose meaning hangs on a field, in words that the catalog knows.
void ProjectReader::settle(Block& block) {
  // A menu's shadow is the text of its only field.
  if (block.is_shadow && block.fields.size() == 1 && !block.opcode.starts_with("argument_reporter") &&
      !is_literal_opcode(block.opcode)) {
    block.opcode = "text";
    block.fields[0].name = "TEXT";
  }
  // Words that Scratch takes in any case.
  for (Field& field : block.fields) {
    if (field.name == "OPERATOR") field.value = lower_ascii(field.value);
    if (field.name == "WHENGREATERTHANMENU" && lower_ascii(field.value) == "timer") field.value = "TIMER";
  }
  const Field* what = block.field("WHENGREATERTHANMENU");
  if (block.opcode == "event_whengreaterthan" && what && what->value != "TIMER") {
    block.opcode += " " + what->value;  // the loudness: no robot hears
  }
}

void ProjectReader::read_next(const Task& task) {
  const JsonValue next = task.json.find("next");
  if (next.is_null()) return;
  if (!next.is_text()) return wrong(path_of(task) + "/next", "id", next);
  const BlockIndex follower = add_block(plain_text(next), task.index, program_.at(task.index).enclosing);
  program_.at(task.index).next = follower;
}

void ProjectReader::read_fields(const Task& task) {
  const JsonValue fields = object_field(task, "fields");
  for (const JsonValue value : fields.fields()) {
    const std::string name(value.key());
    if (!value.is_array() || value.empty() || value[0].is_structured()) {
      wrong(path_of(task) + "/fields/" + name, "[value, id]", value);
      continue;
    }
    Field field{.name = name, .value = plain_text(value[0]), .id = {}, .is_number = value[0].is_number()};
    const std::string id = value.size() > 1 ? plain_text(value[1]) : "";
    if (name == "VARIABLE") field.id = variable_id(field.value, id, VariableKind::scalar);
    if (name == "LIST") field.id = variable_id(field.value, id, VariableKind::list);
    program_.at(task.index).fields.push_back(std::move(field));
  }
}

void ProjectReader::read_inputs(const Task& task) {
  const JsonValue inputs = object_field(task, "inputs");
  for (const JsonValue value : inputs.fields()) {
    const std::string name(value.key());
    if (value.is_array()) {
      read_input(task, name, value);
    } else {
      wrong(path_of(task) + "/inputs/" + name, "[1..3, id | [...]]", value);
    }
  }
}

/// [1, shadow], [2, block] or [3, block, the shadow beneath]. Some writers have 1 where 2 is meant, so what
/// counts is whether the block says that it is a shadow.
void ProjectReader::read_input(const Task& task, const std::string& name, JsonValue value) {
  const JsonValue content = value[1];
  const bool message = content.is_array() && content.size() > 1 && content[0].is_number() &&
                       content[0].number() == kMessagePrimitive;
  if (name == "BROADCAST_INPUT" && message) {
    program_.at(task.index).fields.push_back({.name = name, .value = plain_text(content[1])});
    return;
  }
  Input input{.name = name};
  const BlockIndex first = add_content(content, task, name + "/1");
  const bool shadow = first != kNone && program_.at(first).is_shadow;
  (shadow ? input.shadow : input.block) = first;
  if (!shadow && value.size() > 2) input.shadow = add_content(value[2], task, name + "/2");
  program_.at(task.index).inputs.push_back(std::move(input));
}

/// A list that Scratch keeps as text within the JSON.
std::vector<std::string> ProjectReader::text_list(JsonValue mutation, const char* name, const Task& task) {
  std::vector<std::string> out;
  const JsonValue kept = mutation.find(name);
  if (!kept) return out;
  const JsonTree within = JsonTree::parse(kept.is_text() ? kept.text() : "null");
  const JsonValue list = within.broken() ? JsonValue() : kept.is_text() ? within.root() : kept;
  if (!list.is_array()) {
    wrong(path_of(task) + "/mutation/" + name, "\"[text, ...]\"", kept);
    return out;
  }
  for (const JsonValue item : list) out.push_back(plain_text(item));
  return out;
}

/// The head of a my-block is a block of its own, under the definition's socket.
void ProjectReader::read_definition(const Task& task) {
  const JsonValue head = task.json.find("inputs").find("custom_block")[1];
  const auto it = head.is_text() ? blocks_.find(head.text()) : blocks_.end();
  const JsonValue mutation = it == blocks_.end() ? JsonValue() : it->second.find("mutation");
  if (!mutation.is_object()) {
    return warning(program_.at(task.index).id, messages::signature_missing);
  }
  Signature signature;
  signature.id = signature.name = plain_text(mutation.find("proccode"));
  signature.warp = plain_text(mutation.find("warp")) == "true";
  const std::vector<std::string> ids = text_list(mutation, "argumentids", task);
  const std::vector<std::string> names = text_list(mutation, "argumentnames", task);
  const std::vector<std::string> defaults = text_list(mutation, "argumentdefaults", task);
  for (std::size_t i = 0; i < std::min(ids.size(), names.size()); ++i) {
    signature.params.push_back({ids[i], names[i], ParamType::raw, i < defaults.size() ? defaults[i] : ""});
  }
  program_.at(task.index).signature = static_cast<std::int32_t>(program_.signatures.size());
  program_.signatures.push_back(std::move(signature));
}

void ProjectReader::read_call(const Task& task) {
  const JsonValue mutation = task.json.find("mutation");
  if (!mutation.is_object()) {
    return warning(program_.at(task.index).id, messages::signature_missing);
  }
  Signature signature;
  signature.id = signature.name = plain_text(mutation.find("proccode"));
  program_.at(task.index).signature = static_cast<std::int32_t>(program_.signatures.size());
  program_.signatures.push_back(std::move(signature));
}

}  // namespace mirada::vm
