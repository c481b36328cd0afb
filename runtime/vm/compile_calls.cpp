#include "vm/compiler.h"
#include "vm/literal.h"

namespace mirada::vm {

/// One argument in the form that the parameter keeps: a bare number (or truth), or a value.
Operand Compiler::argument(const Block& block, const Parameter& param, Types wanted) {
  if (param.type == ParamType::truth) return truth_input(block, param.id);
  if (param.type == ParamType::number) {
    const Operand given = number_input(block, param.id);
    build_->free(given);
    return emit_to(Kind::number, type::number, Op::no_nan, given.reg);
  }
  if (param.type == ParamType::raw && content(block, param.id) == kNone) {
    return {text_constant(param.fallback), Kind::value, type::text};
  }
  if (wanted == type::truth) return truth_input(block, param.id);
  return is_bare(wanted) ? bare_input(block, param.id, wanted) : value_input(block, param.id);
}

void Compiler::pass_arguments(const Block& block, int definition) {
  const Signature& signature = types_.signature(definition);
  bool effects = false;
  for (const Parameter& param : signature.params) effects = effects || has_effects(content(block, param.id));
  std::vector<std::pair<std::size_t, Operand>> later;
  for (std::size_t i = 0; i < signature.params.size(); ++i) {
    const Types wanted = types_.parameter(definition, i);
    Operand given = argument(block, signature.params[i], wanted);
    if (!effects && given.kind == Kind::number) {
      const std::int32_t place = build_->outgoing(i);
      if (!build_->retarget(given, place)) build_->emit(Op::set, place, given.reg);
      build_->free(given);
    } else {
      later.emplace_back(i, effects ? kept(given) : given);
    }
  }
  for (const auto& [i, operand] : later) {
    const std::int32_t place = build_->outgoing(i);
    build_->emit(operand.kind == Kind::number ? Op::set : Op::pass, place, operand.reg);
  }
  for (const auto& [i, operand] : later) build_->free(operand);
}

bool Compiler::call(const Block& block) {
  if (block.opcode != "procedures_call") return false;
  const int definition = types_.definition_of(block);
  build_->executed(1);
  if (definition < 0) return true;
  pass_arguments(block, definition);
  build_->emit_end(Op::call, definition, depth_);
  return true;
}

Operand Compiler::call_value(const Block& block) {
  const int definition = types_.definition_of(block);
  build_->executed(1);
  if (definition < 0) return {text_constant(""), Kind::value, type::text};
  pass_arguments(block, definition);
  build_->emit_end(Op::call, definition, depth_);
  const Types types = types_.returned(definition);
  const bool bare = is_bare(types) || types == type::truth;
  return emit_to(bare ? Kind::number : Kind::value, types, bare ? Op::take_n : Op::take_v);
}

/// Fields arrive as texts: a menu's value, a key, the name of a variable, list or message.
std::int32_t Compiler::native_argument(const Block& block, const ArgDef& arg) {
  if (!arg.is_field) {
    if (arg.type == ArgType::statements) return text_constant("");
    const BlockIndex at = content(block, arg.name);
    if (at == kNone && arg.type == ArgType::boolean) return text_constant("false");
    if (at == kNone) return text_constant(arg.default_value);
    return -1;
  }
  const Field* field = block.field(arg.name);
  if (!field) return text_constant(arg.default_value);
  for (const Variable& variable : program_.variables) {
    if (!field->id.empty() && variable.id == field->id) return text_constant(variable.name);
  }
  return text_constant(field->value);
}

Operand Compiler::native(const Block& block, bool wants_value) {
  const BlockDef& def = *block.def;
  NativeSite site{.def = &def, .block = build_->block(), .args = {}, .wants_value = wants_value};
  std::vector<Operand> given;
  bool later_effects = false;
  for (const ArgDef& arg : def.args) {
    later_effects = later_effects || (!arg.is_field && has_effects(content(block, arg.name)));
  }
  for (const ArgDef& arg : def.args) {
    const bool constant =
        arg.is_field || arg.type == ArgType::statements || content(block, arg.name) == kNone;
    if (constant) {
      site.args.push_back(native_argument(block, arg));
      continue;
    }
    Operand operand = value_input(block, arg.name);
    // The block may take many turns; what it was given must not change meanwhile.
    const BlockIndex at = content(block, arg.name);
    if (later_effects || !literal_field(program_.at(at))) operand = kept(operand);
    given.push_back(operand);
    site.args.push_back(operand.reg);
  }
  const Operand out = build_->temporary(Kind::value, type::any);
  const std::size_t number = natives_before_ + tables_.natives.size();
  tables_.natives.push_back(std::move(site));
  build_->emit_end(Op::native, static_cast<std::int32_t>(number), out.reg);
  for (const Operand& operand : given) build_->free(operand);
  return out;
}

}  // namespace mirada::vm
