#include "vm/types.h"

#include <string_view>

#include "vm/digits.h"
#include "vm/literal.h"

namespace mirada::vm {
namespace {

/// What a parameter of this kind can hold whatever it is given.
Types of_param(ParamType declared) {
  if (declared == ParamType::number) return type::number;
  return declared == ParamType::truth ? type::truth : Types{0};
}

Types of_reporter(const BlockDef& def) {
  if (def.shape == Shape::boolean) return type::truth;
  if (def.implementation != Implementation::core) return type::any;
  static constexpr std::string_view kTexts[] = {"operator_join", "operator_letter_of", "data_listcontents"};
  for (const std::string_view opcode : kTexts) {
    if (def.opcode == opcode) return type::text | type::digits;
  }
  return type::number;
}

Types type_of(const Field& initial) {
  if (initial.is_truth) return type::truth;
  if (initial.is_number) return type::number;
  return is_canonical_number(initial.value) ? type::digits : type::text;
}

}  // namespace

TypeTable::TypeTable(const Program& program, const std::vector<bool>& runs) : program_(program), runs_(runs) {
  find_tops();
  add_variables();
  add_definitions();
  collect_assignments();
  follow_assignments();
  for (std::size_t i = 0; i < program_.variables.size(); ++i) {
    if (types_[i] == 0) types_[i] = type::number;
  }
}

void TypeTable::find_tops() {
  top_of_.resize(program_.blocks.size());
  for (std::size_t i = 0; i < program_.blocks.size(); ++i) {
    const BlockIndex parent = program_.blocks[i].parent;
    top_of_[i] = parent == kNone ? static_cast<BlockIndex>(i) : top_of_[static_cast<std::size_t>(parent)];
  }
}

void TypeTable::add_variables() {
  for (std::size_t i = 0; i < program_.variables.size(); ++i) {
    const Variable& variable = program_.variables[i];
    variable_ids_.emplace(variable.id, static_cast<int>(i));
    Types types = 0;
    if (variable.kind == VariableKind::list) {
      for (const Field& item : variable.initial_items) types |= type_of(item);
    } else {
      types = type_of(variable.initial);
    }
    types_.push_back(types);
  }
}

void TypeTable::add_definitions() {
  for (std::size_t i = 0; i < program_.blocks.size(); ++i) {
    const Block& block = program_.blocks[i];
    if (block.opcode != "procedures_definition" || block.signature < 0 || block.disabled) continue;
    const Signature& signature = program_.signatures[static_cast<std::size_t>(block.signature)];
    const auto number = static_cast<int>(definitions_.size());
    if (!definition_ids_.emplace(std::pair{std::string_view(signature.id), block.sprite}, number).second)
      continue;
    definitions_.push_back(static_cast<BlockIndex>(i));
    places_.push_back(static_cast<Place>(types_.size()));
    types_.push_back(falls_through(block.next) ? type::text : Types{0});
    for (const Parameter& param : signature.params) types_.push_back(of_param(param.type));
  }
}

/// Whether a stack's end can be reached without a return.
bool TypeTable::falls_through(BlockIndex first) const {
  for (BlockIndex at = first; at != kNone; at = program_.at(at).next) {
    const Block& block = program_.at(at);
    if (block.disabled) continue;
    if (block.opcode == "procedures_return" || block.opcode == "control_forever") return false;
    if (block.opcode != "control_if_else") continue;
    const Input* yes = block.input("SUBSTACK");
    const Input* no = block.input("SUBSTACK2");
    if (yes && no && !falls_through(yes->block) && !falls_through(no->block)) return false;
  }
  return true;
}

void TypeTable::collect_assignments() {
  for (std::size_t i = 0; i < program_.blocks.size(); ++i) {
    if (runs_[i] && program_.blocks[i].def) collect(static_cast<BlockIndex>(i));
  }
}

void TypeTable::collect(BlockIndex index) {
  const Block& block = program_.at(index);
  const std::string& opcode = block.opcode;
  if (opcode == "data_setvariableto") {
    assign(variable_of(block, "VARIABLE"), source_of_input(block, "VALUE"));
  } else if (opcode == "data_changevariableby" || opcode == "control_for_each") {
    assign(variable_of(block, "VARIABLE"), {type::number});
  } else if (opcode == "data_for_each_item") {
    const Place list = variable_of(block, "LIST");
    if (list >= 0) assign(variable_of(block, "VARIABLE"), {0, list});
  } else if (opcode == "data_addtolist" || opcode == "data_insertatlist" ||
             opcode == "data_replaceitemoflist") {
    assign(variable_of(block, "LIST"), source_of_input(block, "ITEM"));
  } else if (opcode == "procedures_return" || opcode == "control_stop") {
    // "this script" leaves a my-block as its end does: with an empty text.
    const int around = definition_around(index);
    if (around < 0) return;
    assign(place_returned(around),
           opcode == "control_stop" ? Source{type::text} : source_of_input(block, "VALUE"));
  } else if (opcode.starts_with("procedures_call")) {
    collect_call(block);
  }
}

void TypeTable::collect_call(const Block& block) {
  const int definition = definition_of(block);
  if (definition < 0) return;
  const std::vector<Parameter>& params = signature(definition).params;
  for (std::size_t i = 0; i < params.size(); ++i) {
    if (of_param(params[i].type) != 0) continue;
    assign(first_parameter(definition) + static_cast<Place>(i), source_of_input(block, params[i].id));
  }
}

/// What is new in a place goes on to those that take from it.
void TypeTable::follow_assignments() {
  std::vector<std::vector<Place>> takers(types_.size());
  std::vector<Place> fresh;
  const auto add = [&](Place to, Types what) {
    Types& types = types_[static_cast<std::size_t>(to)];
    const auto both = static_cast<Types>(types | what);
    if (both == types) return;
    types = both;
    fresh.push_back(to);
  };
  for (const Assignment& one : assignments_) {
    add(one.to, one.from.always);
    if (one.from.place < 0) continue;
    takers[static_cast<std::size_t>(one.from.place)].push_back(one.to);
    add(one.to, at(one.from.place));
  }
  while (!fresh.empty()) {
    const Place from = fresh.back();
    fresh.pop_back();
    for (const Place to : takers[static_cast<std::size_t>(from)]) add(to, at(from));
  }
}

TypeTable::Source TypeTable::literal(const Block& block) {
  const Field* field = literal_field(block);
  return {field ? type_of(*field) : type::text};
}

TypeTable::Source TypeTable::source_of_input(const Block& block, std::string_view name) const {
  const Input* input = block.input(name);
  if (!input) return {type::text};
  const bool off = input->block == kNone || program_.at(input->block).disabled;
  return source_of(off ? input->shadow : input->block);
}

TypeTable::Source TypeTable::source_of(BlockIndex index) const {
  if (index == kNone) return {type::text};
  const Block& block = program_.at(index);
  if (!block.def) return literal(block);
  if (block.opcode == "data_variable") return {0, variable_of(block, "VARIABLE")};
  if (block.opcode == "data_itemoflist") return {type::text, variable_of(block, "LIST")};
  if (block.opcode.starts_with("argument_reporter")) {
    const int param = parameter_of(index);
    if (param < 0) return {type::number};
    return {0, first_parameter(definition_around(index)) + param};
  }
  if (block.opcode == "procedures_call_value") {
    const int definition = definition_of(block);
    return definition < 0 ? Source{type::text} : Source{0, place_returned(definition)};
  }
  return {of_reporter(*block.def)};
}

Types TypeTable::of_input(const Block& block, std::string_view name) const {
  const Source source = source_of_input(block, name);
  return static_cast<Types>(source.always | (source.place < 0 ? 0 : at(source.place)));
}

Types TypeTable::of_block(BlockIndex index) const {
  const Source source = source_of(index);
  return static_cast<Types>(source.always | (source.place < 0 ? 0 : at(source.place)));
}

int TypeTable::variable_of(const Block& block, std::string_view field) const {
  const Field* named = block.field(field);
  if (!named) return -1;
  const auto it = variable_ids_.find(named->id);
  return it == variable_ids_.end() ? -1 : it->second;
}

int TypeTable::definition_named(const std::string& id, int sprite) const {
  const auto it = definition_ids_.find({id, sprite});
  return it == definition_ids_.end() ? -1 : it->second;
}

int TypeTable::definition_of(const Block& call) const {
  if (call.signature < 0) return -1;
  return definition_named(program_.signatures[static_cast<std::size_t>(call.signature)].id, call.sprite);
}

int TypeTable::definition_around(BlockIndex index) const {
  const Block& top = program_.at(top_of(index));
  if (top.opcode != "procedures_definition") return -1;
  return definition_of(top);
}

const Signature& TypeTable::signature(int definition) const {
  const Block& block = program_.at(definitions_[static_cast<std::size_t>(definition)]);
  return program_.signatures[static_cast<std::size_t>(block.signature)];
}

int TypeTable::parameter_of(BlockIndex reporter) const {
  const int around = definition_around(reporter);
  const Field* field = program_.at(reporter).field("VALUE");
  if (around < 0 || !field) return -1;
  const std::vector<Parameter>& params = signature(around).params;
  // Of two with one name the last counts, as in Scratch.
  for (std::size_t i = params.size(); i-- > 0;) {
    if (params[i].name == field->value) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace mirada::vm
