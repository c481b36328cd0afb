// A Scratch 3 project (project.json) as the same tree that the editor's programs become: sprites and what
// they keep. Their blocks: sb3_blocks.cpp.
#include "vm/sb3_reader.h"

#include <algorithm>
#include <set>

#include "vm/literal.h"
#include "vm/messages.h"
#include "vm/scratch_blocks.h"

namespace mirada::vm {
namespace {

Field initial_value(JsonValue value) {
  Field field{.name = {}, .value = plain_text(value), .id = {}};
  field.is_number = value.is_number();
  field.is_truth = value.is_truth();
  return field;
}

double layer_of(JsonValue target) {
  const JsonValue order = target.find("layerOrder");
  return order.is_number() ? order.number() : 0.0;
}

}  // namespace

void ProjectReader::error(std::string place, const Message& message, MessageArgs args) {
  out_.faults.push_back(make_fault(std::move(place), message, std::move(args)));
}

void ProjectReader::warning(std::string place, const Message& message, MessageArgs args) {
  out_.faults.push_back(make_fault(std::move(place), message, std::move(args), Severity::warning));
}

void ProjectReader::wrong(const std::string& place, const char* expected, JsonValue value) {
  error(place, messages::wrong_shape,
        {{"field", place}, {"expected", expected}, {"value", shown_json(value)}});
}

JsonValue ProjectReader::object_field(JsonValue json, const char* name, const std::string& folder) {
  const JsonValue value = json.find(name);
  if (value.is_object()) return value;
  // Scratch's own files have an empty list where nothing is.
  if (!value.is_null() && !(value.is_array() && value.empty())) wrong(folder + "/" + name, "{...}", value);
  return {};
}

JsonValue ProjectReader::object_field(const Task& task, const char* name) {
  const JsonValue value = task.json.find(name);
  return value.is_object() ? value : object_field(task.json, name, path_of(task));
}

void ProjectReader::read(JsonValue project) {
  program_.from_scratch = true;
  program_.scratch_blocks = scratch_blocks();
  const JsonValue targets = project.find("targets");
  if (!targets.is_array()) return error("/targets", messages::no_targets);
  const std::vector<Target> ordered = order_targets(targets);
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    sprite_ = static_cast<std::int32_t>(i);
    read_variables(ordered[i]);
  }
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    sprite_ = static_cast<std::int32_t>(i);
    read_scripts(ordered[i]);
  }
  find_cloned();
  find_values_of_sprites();
}

/// The stage, then the sprites from the lowest layer. A project without a stage gets an empty one, so that
/// sprite 0 is everybody's in any case.
std::vector<ProjectReader::Target> ProjectReader::order_targets(JsonValue targets) {
  std::vector<Target> out{{JsonValue(), "/targets"}};
  bool stage_found = false;
  std::size_t number = 0;
  for (const JsonValue json : targets) {
    const Target target{json, "/targets/" + std::to_string(number++)};
    if (!json.is_object()) {
      wrong(target.path, "{...}", json);
      continue;
    }
    const bool stage = !stage_found && json.find("isStage").truth();
    stage_found = stage_found || stage;
    stage ? void(out.front() = target) : out.push_back(target);
  }
  if (!stage_found) warning("/targets", messages::no_stage);
  std::stable_sort(out.begin() + 1, out.end(),
                   [](const Target& a, const Target& b) { return layer_of(a.json) < layer_of(b.json); });
  program_.sprites.assign(1, Sprite{});
  for (std::size_t i = 1; i < out.size(); ++i) {
    program_.sprites.push_back({plain_text(out[i].json.find("name")), false, false});
  }
  return out;
}

/// Gives it an id that no other variable of the program has: sprites may use the same ones.
std::size_t ProjectReader::add_variable(const std::string& id, const std::string& name, VariableKind kind) {
  std::string unique = sprite_ == 0 ? id : std::to_string(sprite_) + "/" + id;
  while (!variable_ids_.insert(unique).second) unique += '\'';
  known_.emplace(std::tuple{sprite_, kind, "#" + id}, unique);
  known_.emplace(std::tuple{sprite_, kind, "=" + name}, unique);
  Variable variable{.id = unique, .name = name, .kind = kind};
  variable.sprite = sprite_;
  variable.initial.value = "0";
  variable.initial.is_number = true;
  program_.variables.push_back(std::move(variable));
  return program_.variables.size() - 1;
}

void ProjectReader::read_variables(const Target& target) {
  read_values(target, "variables", VariableKind::scalar);
  read_values(target, "lists", VariableKind::list);
  const JsonValue messages_sent = object_field(target.json, "broadcasts", target.path);
  for (const JsonValue name : messages_sent) {
    if (!name.is_text()) wrong(target.path + "/broadcasts/" + std::string(name.key()), "text", name);
  }
}

void ProjectReader::read_values(const Target& target, const char* field, VariableKind kind) {
  const JsonValue values = object_field(target.json, field, target.path);
  for (const JsonValue value : values.fields()) {
    const std::string id(value.key());
    const std::string place = target.path + "/" + field + "/" + id;
    const bool list = kind == VariableKind::list;
    if (!value.is_array() || value.empty() || (list && value.size() > 1 && !value[1].is_array())) {
      wrong(place, list ? "[name, [item, ...]]" : "[name, value]", value);
      continue;
    }
    Variable& variable = program_.variables[add_variable(id, plain_text(value[0]), kind)];
    if (value.size() < 2) continue;
    if (!list) {
      variable.initial = initial_value(value[1]);
    } else {
      for (const JsonValue item : value[1]) variable.initial_items.push_back(initial_value(item));
    }
  }
}

const std::string* ProjectReader::known_variable(std::int32_t sprite, const std::string& id,
                                                 const std::string& name, VariableKind kind) const {
  for (const std::string& key : {"#" + id, "=" + name}) {
    for (const std::int32_t where : {sprite, 0}) {
      const auto it = known_.find({where, kind, key});
      if (it != known_.end()) return &it->second;
    }
  }
  return nullptr;
}

/// The variable that a block of this sprite means: its own or everybody's, by id or else by name. A missing
/// one is made, as Scratch does.
std::string ProjectReader::variable_id(const std::string& name, const std::string& id, VariableKind kind) {
  if (const std::string* known = known_variable(sprite_, id, name, kind)) return *known;
  return program_.variables[add_variable(id.empty() ? name : id, name, kind)].id;
}

/// Which sprites some block may clone. One that names its sprite by a reporter may clone any.
void ProjectReader::find_cloned() {
  for (const Block& block : program_.blocks) {
    if (block.opcode != "control_create_clone_of") continue;
    const Input* option = block.input("CLONE_OPTION");
    const BlockIndex content = option ? option->content() : kNone;
    const Field* fixed = content == kNone ? nullptr : literal_field(program_.at(content));
    for (std::size_t i = 1; i < program_.sprites.size(); ++i) {
      Sprite& sprite = program_.sprites[i];
      const bool itself = fixed && fixed->value == "_myself_" && block.sprite == static_cast<std::int32_t>(i);
      if (!fixed || itself || sprite.name == fixed->value) sprite.is_cloned = true;
    }
  }
}

/// "[variable] of [sprite]" reads the variable of the sprite itself, whoever of its clones asks; 0 when it
/// has none. What else a sprite can tell needs the stage.
void ProjectReader::find_values_of_sprites() {
  static const std::set<std::string> kOfTheStage = {
      "x position", "y position", "direction",    "costume #",  "costume name",
      "size",       "volume",     "background #", "backdrop #", "backdrop name"};
  for (Block& block : program_.blocks) {
    if (block.opcode != "sensing_of") continue;
    const Field* property = block.field("PROPERTY");
    const Input* object = block.input("OBJECT");
    const BlockIndex content = object ? object->content() : kNone;
    const Field* whose = content == kNone ? nullptr : literal_field(program_.at(content));
    if (!property || !whose || kOfTheStage.contains(property->value)) continue;
    std::vector<Field> fields;
    for (std::size_t i = 0; i < program_.sprites.size() && fields.empty(); ++i) {
      if (i == 0 ? whose->value != "_stage_" : whose->value != program_.sprites[i].name) continue;
      const auto it =
          known_.find({static_cast<std::int32_t>(i), VariableKind::scalar, "=" + property->value});
      if (it == known_.end()) break;
      fields = {{.name = "VARIABLE", .value = property->value, .id = it->second}, {.name = "ORIGINAL"}};
    }
    block.opcode = fields.empty() ? "math_number" : "data_variable";
    if (fields.empty()) fields = {{.name = "NUM", .value = "0", .id = {}, .is_number = true}};
    block.fields = std::move(fields);
    block.inputs.clear();
  }
}

ReadProgram read_scratch_project(JsonValue root) {
  ReadProgram out;
  ProjectReader(out).read(root);
  return out;
}

}  // namespace mirada::vm
