#include "vm/types.h"

#include <string_view>

#include "vm/digits.h"
#include "vm/literal.h"

namespace mirada::vm {
namespace {

Types of_param(ParamType declared, Types given) {
  if (declared == ParamType::number) return type::number;
  if (declared == ParamType::truth) return type::truth;
  return given;
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
  find_definitions();
  seed();
  while (pass()) {
  }
  for (std::size_t i = 0; i < variables_.size(); ++i) {
    if (variables_[i] == 0) variables_[i] = type::number;
  }
}

void TypeTable::find_tops() {
  top_of_.resize(program_.blocks.size());
  for (std::size_t i = 0; i < program_.blocks.size(); ++i) {
    const BlockIndex parent = program_.blocks[i].parent;
    top_of_[i] = parent == kNone ? static_cast<BlockIndex>(i) : top_of_[static_cast<std::size_t>(parent)];
  }
}

void TypeTable::find_definitions() {
  for (std::size_t i = 0; i < program_.blocks.size(); ++i) {
    const Block& block = program_.blocks[i];
    if (block.opcode != "procedures_definition" || block.signature < 0 || block.disabled) continue;
    const Signature& signature = program_.signatures[static_cast<std::size_t>(block.signature)];
    const auto number = static_cast<int>(definitions_.size());
    if (!definition_ids_.emplace(std::pair{signature.id, block.sprite}, number).second) continue;
    definitions_.push_back(static_cast<BlockIndex>(i));
    std::vector<Types> params;
    for (const Parameter& param : signature.params) params.push_back(of_param(param.type, 0));
    params_.push_back(std::move(params));
    returns_.push_back(falls_through(block.next) ? type::text : Types{0});
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

void TypeTable::seed() {
  for (std::size_t i = 0; i < program_.variables.size(); ++i) {
    const Variable& variable = program_.variables[i];
    variable_ids_.emplace(variable.id, static_cast<int>(i));
    Types types = 0;
    if (variable.kind == VariableKind::list) {
      for (const Field& item : variable.initial_items) {
        types |= type_of(item);
      }
    } else {
      types = type_of(variable.initial);
    }
    variables_.push_back(types);
  }
}

Types TypeTable::literal(const Block& block) {
  const Field* field = literal_field(block);
  return field ? type_of(*field) : type::text;
}

Types TypeTable::of_input(const Block& block, std::string_view name) const {
  const Input* input = block.input(name);
  if (!input) return type::text;
  const bool off = input->block == kNone || program_.at(input->block).disabled;
  return of_block(off ? input->shadow : input->block);
}

Types TypeTable::of_block(BlockIndex index) const {
  if (index == kNone) return type::text;
  const Block& block = program_.at(index);
  if (literal_field(block)) return literal(block);
  if (!block.def) return type::text;
  if (block.opcode == "data_variable") {
    const int variable = variable_of(block, "VARIABLE");
    const Types types = variable < 0 ? Types{0} : variables_[static_cast<std::size_t>(variable)];
    return types;
  }
  if (block.opcode == "data_itemoflist") {
    const int list = variable_of(block, "LIST");
    return list < 0 ? type::text
                    : static_cast<Types>(variables_[static_cast<std::size_t>(list)] | type::text);
  }
  if (block.opcode.starts_with("argument_reporter")) {
    const int param = parameter_of(index);
    const int around = definition_around(index);
    return param < 0 ? type::number
                     : params_[static_cast<std::size_t>(around)][static_cast<std::size_t>(param)];
  }
  if (block.opcode == "procedures_call_value") {
    const int definition = definition_of(block);
    return definition < 0 ? type::text : returns_[static_cast<std::size_t>(definition)];
  }
  return of_reporter(*block.def);
}

bool TypeTable::assign(Types& place, Types what) {
  const auto both = static_cast<Types>(place | what);
  const bool fresh = both != place;
  place = both;
  return fresh;
}

bool TypeTable::pass() {
  bool fresh = false;
  for (std::size_t i = 0; i < program_.blocks.size(); ++i) {
    if (runs_[i]) fresh = visit(static_cast<BlockIndex>(i)) || fresh;
  }
  return fresh;
}

bool TypeTable::visit(BlockIndex index) {
  const Block& block = program_.at(index);
  const auto place = [&](std::string_view field) -> Types* {
    const int variable = variable_of(block, field);
    return variable < 0 ? nullptr : &variables_[static_cast<std::size_t>(variable)];
  };
  const std::string& opcode = block.opcode;
  if (opcode == "data_setvariableto") {
    Types* variable = place("VARIABLE");
    return variable && assign(*variable, of_input(block, "VALUE"));
  }
  if (opcode == "data_changevariableby" || opcode == "control_for_each") {
    Types* variable = place("VARIABLE");
    return variable && assign(*variable, type::number);
  }
  if (opcode == "data_for_each_item") {
    Types* variable = place("VARIABLE");
    const Types* list = place("LIST");
    return variable && list && assign(*variable, *list);
  }
  if (opcode == "data_addtolist" || opcode == "data_insertatlist" || opcode == "data_replaceitemoflist") {
    Types* list = place("LIST");
    return list && assign(*list, of_input(block, "ITEM"));
  }
  if (opcode == "procedures_return") {
    const int around = definition_around(index);
    return around >= 0 && assign(returns_[static_cast<std::size_t>(around)], of_input(block, "VALUE"));
  }
  if (opcode == "control_stop") {
    // "this script" leaves a my-block as its end does: with an empty text.
    const int around = definition_around(index);
    return around >= 0 && assign(returns_[static_cast<std::size_t>(around)], type::text);
  }
  return opcode.starts_with("procedures_call") && visit_call(block);
}

bool TypeTable::visit_call(const Block& block) {
  const int definition = definition_of(block);
  if (definition < 0) return false;
  const Signature& real = signature(definition);
  bool fresh = false;
  for (std::size_t i = 0; i < real.params.size(); ++i) {
    Types& place = params_[static_cast<std::size_t>(definition)][i];
    fresh = assign(place, of_param(real.params[i].type, of_input(block, real.params[i].id))) || fresh;
  }
  return fresh;
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
