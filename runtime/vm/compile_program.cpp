#include <algorithm>

#include "vm/compiler.h"
#include "vm/digits.h"
#include "vm/letter_case.h"
#include "vm/literal.h"
#include "vm/message_name.h"
#include "vm/numbers.h"

namespace mirada::vm {
namespace {

std::vector<bool> find_effects(const Program& program) {
  std::vector<bool> effects(program.blocks.size(), false);
  for (std::size_t i = program.blocks.size(); i-- > 0;) {
    const Block& block = program.blocks[i];
    const bool native = block.def && block.def->implementation == Implementation::native;
    if (native || block.opcode == "procedures_call_value") effects[i] = true;
    if (effects[i] && block.enclosing != kNone) effects[static_cast<std::size_t>(block.enclosing)] = true;
  }
  return effects;
}

GlobalInit initial_of(const Field& field) {
  if (field.is_truth) return {Kind::value, false, field.value == "true" ? 1.0 : 0.0, {}, true};
  if (field.is_number) return {Kind::number, false, string_to_number(field.value), {}};
  return {Kind::value, true, 0, field.value};
}

/// The same for a place that keeps its content bare.
GlobalInit bare_initial_of(const Field& field, Types types) {
  const double number = string_to_number(field.value);
  return {Kind::number, false, is_mixed(types) && !field.is_number ? digits_of(number) : number, {}};
}

std::string shown_name(const Program& program, const Variable& variable) {
  const std::string& sprite = program.sprites[static_cast<std::size_t>(variable.sprite)].name;
  return variable.sprite == 0 || sprite.empty() ? variable.name : sprite + "." + variable.name;
}

}  // namespace

std::string message_key(std::string_view name) {
  std::string out;
  for (const char16_t unit : utf16_of(name)) {
    const char16_t lower = lower_case(unit);
    out += static_cast<char>(lower & 0xFF);
    out += static_cast<char>(lower >> 8);
  }
  return out;
}

Compiler::Compiler(const Program& program, const std::vector<bool>& runs, CodeTables& tables)
    : program_(program), types_(program, runs), tables_(tables), effects_(find_effects(program)) {
  for (std::size_t i = 0; i < program_.blocks.size(); ++i) {
    if (program_.blocks[i].opcode != "data_scriptvariable") continue;
    const auto index = static_cast<BlockIndex>(i);
    script_variables_[types_.top_of(index)].push_back(index);
  }
}

std::int32_t Compiler::number_constant(double number) {
  const std::string key(reinterpret_cast<const char*>(&number), sizeof number);
  const auto [it, fresh] = numbers_.emplace(key, 0);
  if (fresh) {
    it->second = global_operand(globals_before_ + tables_.globals.size());
    tables_.globals.push_back({Kind::number, false, number, {}});
  }
  return it->second;
}

std::int32_t Compiler::text_constant(const std::string& text) {
  const auto [it, fresh] = texts_.emplace(text, 0);
  if (fresh) {
    it->second = global_operand(globals_before_ + tables_.globals.size());
    tables_.globals.push_back({Kind::value, true, 0, text});
  }
  return it->second;
}

/// Variables come first among the globals; a cloned sprite's own live in each of its copies.
void Compiler::place_variables(Code& code) {
  code.own.resize(program_.sprites.size());
  places_.resize(program_.variables.size());
  list_places_.assign(program_.variables.size(), 0);
  for (std::size_t i = 0; i < program_.variables.size(); ++i) {
    if (program_.variables[i].kind == VariableKind::scalar) place_scalar(code, i);
    if (program_.variables[i].kind == VariableKind::list) place_list(code, i);
  }
  list_of_none_ = static_cast<std::int32_t>(code.lists.size());
}

void Compiler::place_scalar(Code& code, std::size_t i) {
  const Variable& variable = program_.variables[i];
  const Types types = types_.variable(static_cast<int>(i));
  const Kind kind = is_bare(types) ? Kind::number : Kind::value;
  const GlobalInit initial =
      is_bare(types) ? bare_initial_of(variable.initial, types) : initial_of(variable.initial);
  const bool own = program_.sprites[static_cast<std::size_t>(variable.sprite)].is_cloned;
  VariableInfo info{.name = shown_name(program_, variable),
                    .kind = kind,
                    .digits = types == type::digits,
                    .own = own,
                    .sprite = variable.sprite};
  if (own) {
    std::vector<OwnVariable>& mine = code.own[static_cast<std::size_t>(variable.sprite)].variables;
    info.place = static_cast<std::int32_t>(mine.size());
    places_[i] = {info.place, kind, types, true};
    mine.push_back({kind, initial});
  } else {
    info.place = static_cast<std::int32_t>(tables_.globals.size());
    places_[i] = {global_operand(tables_.globals.size()), kind, types, false};
    tables_.globals.push_back({kind, initial.is_text, initial.number, initial.text, initial.is_truth});
  }
  code.variables.push_back(std::move(info));
}

void Compiler::place_list(Code& code, std::size_t i) {
  const Variable& variable = program_.variables[i];
  const Types types = types_.variable(static_cast<int>(i));
  const bool own = program_.sprites[static_cast<std::size_t>(variable.sprite)].is_cloned;
  ListInfo info{.name = shown_name(program_, variable),
                .numbers = is_bare(types),
                .digits = types == type::digits,
                .mixed = is_mixed(types),
                .own = own,
                .sprite = variable.sprite,
                .initial = {}};
  for (const Field& item : variable.initial_items) info.initial.push_back(initial_of(item));
  const auto number = static_cast<std::int32_t>(code.lists.size());
  code.lists.push_back(std::move(info));
  list_places_[i] = number;
  if (!own) return;
  std::vector<std::int32_t>& mine = code.own[static_cast<std::size_t>(variable.sprite)].lists;
  list_places_[i] = ~static_cast<std::int32_t>(mine.size());
  mine.push_back(number);
}

const Compiler::Place* Compiler::place_of(const Block& block, std::string_view field) {
  const int variable = types_.variable_of(block, field);
  if (variable < 0) return nullptr;
  const auto local = locals_.find(variable);
  return local != locals_.end() ? &local->second : &places_[static_cast<std::size_t>(variable)];
}

Operand Compiler::read(const Place& place) {
  if (!place.own) return {place.reg, place.kind, place.types, false};
  return emit_to(place.kind, place.types, place.kind == Kind::number ? Op::load_n : Op::load_v, place.reg);
}

/// `given` stays the caller's, who frees it.
void Compiler::write(const Place& place, const Operand& given) {
  Operand from = given;
  if (is_mixed(place.types) && given.types == type::digits) {
    from = emit_to(Kind::number, place.types, Op::digits, given.reg);
  }
  const bool boxes = place.kind == Kind::value && from.kind == Kind::number;
  if (boxes && !place.own) {
    build_->emit(box_of(from), place.reg, from.reg);
    return;
  }
  const Operand source = boxes ? emit_to(Kind::value, from.types, box_of(from), from.reg) : from;
  if (place.own) {
    build_->emit(place.kind == Kind::number ? Op::store_n : Op::store_v, source.reg, place.reg);
  } else if (!build_->retarget(source, place.reg)) {
    build_->emit(place.kind == Kind::number ? Op::set : Op::copy, place.reg, source.reg);
  }
  if (boxes) build_->free(source);
  if (from.reg != given.reg) build_->free(from);
}

std::int32_t Compiler::list_of(const Block& block) {
  const int list = types_.variable_of(block, "LIST");
  return list < 0 ? list_of_none_ : list_places_[static_cast<std::size_t>(list)];
}

bool Compiler::list_is_bare(const Block& block) const {
  const int list = types_.variable_of(block, "LIST");
  return list >= 0 && is_bare(types_.variable(list));
}

/// Variables that a script declares as its own live in its frame.
void Compiler::declare_locals(BlockIndex top) {
  locals_.clear();
  const auto declared = script_variables_.find(top);
  if (declared == script_variables_.end()) return;
  for (const BlockIndex index : declared->second) {
    const Block& block = program_.at(index);
    const int variable = types_.variable_of(block, "VARIABLE");
    if (variable < 0 || locals_.contains(variable) ||
        program_.variables[static_cast<std::size_t>(variable)].kind != VariableKind::scalar) {
      continue;
    }
    Place place = places_[static_cast<std::size_t>(variable)];
    place.own = false;
    place.reg = build_->new_register(place.kind);
    if (place.kind == Kind::number) build_->emit(Op::set, place.reg, number_constant(0));
    locals_.emplace(variable, place);
  }
}

std::int32_t Compiler::compile_script(BlockIndex top) {
  Function function{.name = program_.at(top).id, .sprite = program_.at(top).sprite};
  FunctionBuilder build(function);
  build_ = &build;
  definition_ = -1;
  warp_ = false;
  params_.clear();
  build.set_block(top);
  declare_locals(top);
  stack(program_.at(top).next);
  build.set_block(top);
  build.emit_end(Op::end);
  build.finish();
  tables_.functions.push_back(std::move(function));
  return static_cast<std::int32_t>(tables_.functions.size()) - 1;
}

std::int32_t Compiler::compile_condition(BlockIndex hat) {
  const Block& block = program_.at(hat);
  Function function{.name = block.id, .sprite = block.sprite};
  FunctionBuilder build(function);
  build_ = &build;
  definition_ = -1;
  locals_.clear();
  params_.clear();
  build.set_block(hat);
  Operand truth;
  if (block.def->implementation == Implementation::native) {
    truth = as_truth(native(block, true));
  } else if (block.opcode == "event_whengreaterthan") {
    const Operand limit = number_input(block, "VALUE");
    const Operand timer = emit_to(Kind::number, type::number, Op::timer);
    truth = emit_to(Kind::number, type::truth, Op::less, limit.reg, timer.reg);
  } else {
    truth = truth_input(block, "CONDITION");
  }
  build.emit_end(Op::ret_n, truth.reg);
  build.finish();
  tables_.functions.push_back(std::move(function));
  return static_cast<std::int32_t>(tables_.functions.size()) - 1;
}

void Compiler::compile_definition(int definition) {
  const BlockIndex head = types_.definitions()[static_cast<std::size_t>(definition)];
  const Signature& signature = types_.signature(definition);
  Function function{.params = static_cast<std::uint32_t>(signature.params.size()),
                    .name = signature.name,
                    .warp = signature.warp,
                    .sprite = program_.at(head).sprite};
  FunctionBuilder build(function);
  build_ = &build;
  definition_ = definition;
  warp_ = signature.warp;
  params_.clear();
  for (std::size_t i = 0; i < signature.params.size(); ++i) {
    const Types types = types_.parameter(definition, i);
    const Kind kind = is_bare(types) || types == type::truth ? Kind::number : Kind::value;
    params_.push_back({build.new_register(kind), kind, types, false});
  }
  build.set_block(head);
  declare_locals(head);
  stack(program_.at(head).next);
  build.set_block(head);
  end_script();
  build.finish();
  tables_.functions[static_cast<std::size_t>(definition)] = std::move(function);
}

void Compiler::add_script(Code& code, BlockIndex top) {
  const Block& block = program_.at(top);
  if (!block.def || block.def->shape != Shape::hat || block.disabled ||
      block.opcode == "procedures_definition")
    return;
  Script script{.hat = top, .sprite = block.sprite, .name = {}};
  const auto named = [&](const char* name) -> std::string {
    const Field* field = block.field(name);
    if (!field) return {};
    for (const Variable& variable : program_.variables) {
      if (!field->id.empty() && variable.id == field->id) return variable.name;
    }
    return field->value;
  };
  if (block.opcode == "event_whenkeypressed") {
    script.kind = HatKind::key;
    script.name = named("KEY_OPTION");
  } else if (block.opcode == "event_whenbroadcastreceived") {
    script.kind = HatKind::message;
    script.name = message_key(named("BROADCAST_OPTION"));
  } else if (block.opcode == "control_start_as_clone") {
    script.kind = HatKind::clone;
  } else if (block.opcode != "event_whenflagclicked") {
    script.kind = HatKind::edge;
    script.from_outside = block.def->implementation == Implementation::native;
    script.condition = compile_condition(top);
  }
  script.function = compile_script(top);
  code.scripts.push_back(std::move(script));
}

void Compiler::compile_program(Code& code) {
  place_variables(code);
  tables_.functions.resize(types_.definitions().size());
  for (std::size_t i = 0; i < types_.definitions().size(); ++i) compile_definition(static_cast<int>(i));
  for (const BlockIndex top : program_.tops) add_script(code, top);
}

void Compiler::compile_reporter(const Code&, BlockIndex reporter, std::size_t globals, std::size_t natives) {
  Code places;
  place_variables(places);
  tables_.globals.clear();
  globals_before_ = globals;
  natives_before_ = natives;
  Function function{.name = program_.at(reporter).id, .sprite = program_.at(reporter).sprite};
  FunctionBuilder build(function);
  build_ = &build;
  build.set_block(reporter);
  const Operand value = as_value(expression(reporter));
  build.emit_end(Op::answer, value.reg);
  build.emit_end(Op::end);
  build.finish();
  tables_.functions.push_back(std::move(function));
}

}  // namespace mirada::vm
