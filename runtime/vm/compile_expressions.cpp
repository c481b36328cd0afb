#include <array>
#include <utility>

#include "vm/compiler.h"
#include "vm/digits.h"
#include "vm/literal.h"
#include "vm/numbers.h"
#include "vm/value.h"

namespace mirada::vm {
namespace {

struct Arithmetic {
  std::string_view opcode;
  Op op;
};
constexpr std::array kArithmetic = {
    Arithmetic{"operator_add", Op::add}, Arithmetic{"operator_subtract", Op::subtract},
    Arithmetic{"operator_multiply", Op::multiply}, Arithmetic{"operator_divide", Op::divide},
    Arithmetic{"operator_mod", Op::mod}};

}  // namespace

Operand Compiler::emit_to(Kind kind, Types types, Op op, std::int32_t b, std::int32_t c) {
  const Operand out = build_->temporary(kind, types);
  build_->emit(op, out.reg, b, c);
  return out;
}

BlockIndex Compiler::content(const Block& block, std::string_view name) const {
  const Input* input = block.input(name);
  if (!input) return kNone;
  const bool off = input->block == kNone || program_.at(input->block).disabled;
  return off ? input->shadow : input->block;
}

Operand Compiler::expression(BlockIndex index) {
  if (index == kNone) return {text_constant(""), Kind::value, type::text};
  const Block& block = program_.at(index);
  if (literal_field(block)) return literal(block);
  if (!block.def) return {text_constant(""), Kind::value, type::text};
  const BlockIndex around = build_->block();
  build_->set_block(index);
  const Operand out = reporter(block, index);
  build_->set_block(around);
  return out;
}

Operand Compiler::literal(const Block& block) {
  const Types types = types_.of_block(static_cast<BlockIndex>(&block - program_.blocks.data()));
  const std::string& text = literal_field(block)->value;
  if (is_bare(types)) return {number_constant(string_to_number(text)), Kind::number, types};
  return {text_constant(text), Kind::value, types};
}

Operand Compiler::reporter(const Block& block, BlockIndex index) {
  const std::string& opcode = block.opcode;
  if (opcode == "procedures_call_value") return call_value(block);
  if (block.def->implementation == Implementation::native) {
    build_->executed(1);
    return native(block, true);
  }
  build_->executed(1);
  for (const Arithmetic& row : kArithmetic) {
    if (opcode == row.opcode) return arithmetic(block, row.op, "NUM1", "NUM2");
  }
  if (opcode == "operator_lt" || opcode == "operator_gt" || opcode == "operator_equals")
    return comparison(block);
  if (opcode == "operator_and") return truth_operator(block, Op::both);
  if (opcode == "operator_or") return truth_operator(block, Op::either);
  if (opcode == "data_variable") return variable(block);
  if (opcode.starts_with("argument_reporter")) return argument_reporter(block, index);
  if (opcode.starts_with("data_")) return list_reporter(block);
  return text_operator(block);
}

Operand Compiler::arithmetic(const Block& block, Op op, std::string_view a, std::string_view b) {
  Operand x = number_input(block, a);
  if (has_effects(content(block, b))) x = kept(x);
  const Operand y = number_input(block, b);
  build_->free(x);
  build_->free(y);
  return emit_to(Kind::number, type::number, op, x.reg, y.reg);
}

/// Both sides of a comparison as bare numbers, when that compares as Scratch does.
bool Compiler::two_numbers(const Block& block, Operand& a, Operand& b) {
  const Types x = types_.of_input(block, "OPERAND1");
  const Types y = types_.of_input(block, "OPERAND2");
  const BlockIndex left = content(block, "OPERAND1");
  const BlockIndex right = content(block, "OPERAND2");
  if (is_bare(x) && is_bare(y)) {
    a = expression(left);
    if (has_effects(right)) a = kept(a);
    b = expression(right);
    return true;
  }
  // An item of a number list is a number or (no such item) an empty text, which equals no number.
  if (block.opcode != "operator_equals") return false;
  const bool left_literal = left != kNone && literal_field(program_.at(left)) && is_bare(x);
  const bool right_literal = right != kNone && literal_field(program_.at(right)) && is_bare(y);
  if (right_literal && list_item_as_number(block, "OPERAND1", Op::list_peek_n, a)) {
    b = expression(right);
    return true;
  }
  if (left_literal && list_item_as_number(block, "OPERAND2", Op::list_peek_n, b)) {
    a = expression(left);
    return true;
  }
  return false;
}

Operand Compiler::comparison(const Block& block) {
  Operand a;
  Operand b;
  const bool bare = two_numbers(block, a, b);
  if (!bare) {
    a = value_input(block, "OPERAND1");
    if (has_effects(content(block, "OPERAND2"))) a = kept(a);
    b = value_input(block, "OPERAND2");
  }
  build_->free(a);
  build_->free(b);
  if (block.opcode == "operator_gt") std::swap(a, b);
  const bool equals = block.opcode == "operator_equals";
  const Op op = equals ? (bare ? Op::equal : Op::equal_v) : (bare ? Op::less : Op::less_v);
  return emit_to(Kind::number, type::truth, op, a.reg, b.reg);
}

/// Both sides are worked out, as Scratch does.
Operand Compiler::truth_operator(const Block& block, Op op) {
  Operand a = truth_input(block, "OPERAND1");
  if (has_effects(content(block, "OPERAND2"))) a = kept(a);
  const Operand b = truth_input(block, "OPERAND2");
  build_->free(a);
  build_->free(b);
  return emit_to(Kind::number, type::truth, op, a.reg, b.reg);
}

/// What is left of operators and sensing: one instruction over cast inputs.
Operand Compiler::text_operator(const Block& block) {
  const std::string& opcode = block.opcode;
  const auto two_values = [&](const char* first, const char* second, Kind kind, Types types, Op op) {
    Operand a = op == Op::letter ? number_input(block, first) : value_input(block, first);
    if (has_effects(content(block, second))) a = kept(a);
    const Operand b = value_input(block, second);
    build_->free(a);
    build_->free(b);
    return emit_to(kind, types, op, a.reg, b.reg);
  };
  const auto one = [&](const Operand& a, Kind kind, Types types, Op op, std::int32_t c = 0) {
    build_->free(a);
    return emit_to(kind, types, op, a.reg, c);
  };
  constexpr Types kText = type::text | type::digits;
  if (opcode == "operator_join") return two_values("STRING1", "STRING2", Kind::value, kText, Op::join);
  if (opcode == "operator_letter_of") return two_values("LETTER", "STRING", Kind::value, kText, Op::letter);
  if (opcode == "operator_contains")
    return two_values("STRING1", "STRING2", Kind::number, type::truth, Op::contains);
  if (opcode == "operator_random") return two_values("FROM", "TO", Kind::number, type::number, Op::random);
  if (opcode == "operator_not")
    return one(truth_input(block, "OPERAND"), Kind::number, type::truth, Op::negate);
  if (opcode == "operator_length")
    return one(value_input(block, "STRING"), Kind::number, type::number, Op::length);
  if (opcode == "operator_round")
    return one(number_input(block, "NUM"), Kind::number, type::number, Op::round);
  if (opcode == "operator_mathop") {
    const Field* field = block.field("OPERATOR");
    const MathFn fn = math_fn(field ? field->value : "");
    if (fn == MathFn::count) return {number_constant(0), Kind::number, type::number};
    const Operand a = number_input(block, "NUM");
    if (fn == MathFn::floor) return one(a, Kind::number, type::number, Op::floor);
    return one(a, Kind::number, type::number, Op::math, static_cast<std::int32_t>(fn));
  }
  if (opcode == "control_get_counter") return emit_to(Kind::number, type::number, Op::counter);
  if (opcode == "sensing_timer") return emit_to(Kind::number, type::number, Op::timer);
  return {text_constant(""), Kind::value, type::text};
}

Operand Compiler::variable(const Block& block) {
  const Place* place = place_of(block, "VARIABLE");
  if (!place) return {number_constant(0), Kind::number, type::number};
  if (!place->own || !block.field("ORIGINAL")) return read(*place);
  const int index = types_.variable_of(block, "VARIABLE");
  const std::int32_t sprite = program_.variables[static_cast<std::size_t>(index)].sprite;
  return emit_to(place->kind, place->types, place->kind == Kind::number ? Op::load_of_n : Op::load_of_v,
                 place->reg, sprite);
}

Operand Compiler::argument_reporter(const Block&, BlockIndex index) {
  const int param = types_.parameter_of(index);
  if (param < 0 || definition_ < 0) return {number_constant(0), Kind::number, type::number};
  return read(params_[static_cast<std::size_t>(param)]);
}

Operand Compiler::list_reporter(const Block& block) {
  const std::string& opcode = block.opcode;
  if (opcode == "data_itemoflist") return item_of_list(block);
  const std::int32_t list = list_of(block);
  if (opcode == "data_lengthoflist") return emit_to(Kind::number, type::number, Op::list_length, list);
  if (opcode == "data_listcontents")
    return emit_to(Kind::value, type::text | type::digits, Op::list_text, list);
  const Operand item = value_input(block, "ITEM");
  build_->free(item);
  if (opcode == "data_itemnumoflist") {
    return emit_to(Kind::number, type::number, Op::list_find, list, item.reg);
  }
  return emit_to(Kind::number, type::truth, Op::list_has, list, item.reg);
}

Operand Compiler::item_of_list(const Block& block) {
  const auto types =
      static_cast<Types>(types_.of_block(static_cast<BlockIndex>(&block - program_.blocks.data())));
  const std::int32_t list = list_of(block);
  const bool bare_index = is_bare(types_.of_input(block, "INDEX"));
  const Operand index = bare_index ? number_input(block, "INDEX") : value_input(block, "INDEX");
  build_->free(index);
  return emit_to(Kind::value, types, bare_index ? Op::list_get_at : Op::list_get, list, index.reg);
}

/// An item of a number list by a number, unboxed. `op` says what stands for an item that is not there.
bool Compiler::list_item_as_number(const Block& block, std::string_view name, Op op, Operand& out) {
  const BlockIndex at = content(block, name);
  if (at == kNone) return false;
  const Block& item = program_.at(at);
  if (item.opcode != "data_itemoflist" || !list_is_bare(item)) return false;
  if (!is_bare(types_.of_input(item, "INDEX"))) return false;
  const BlockIndex around = build_->block();
  build_->set_block(at);
  build_->executed(1);
  const std::int32_t list = list_of(item);
  const Operand index = number_input(item, "INDEX");
  build_->free(index);
  const Types kept = types_.variable(types_.variable_of(item, "LIST"));
  out = emit_to(Kind::number, is_mixed(kept) ? kept : type::number, op, list, index.reg);
  build_->set_block(around);
  return true;
}

Operand Compiler::input(const Block& block, std::string_view name) {
  return expression(content(block, name));
}

/// For a place that keeps it bare, as its types want it.
Operand Compiler::bare_input(const Block& block, std::string_view name, Types wanted) {
  const Operand given = input(block, name);
  if (!is_mixed(wanted) || given.types != type::digits) return given;
  const BlockIndex at = content(block, name);
  if (const Field* field = literal_field(program_.at(at))) {
    return {number_constant(digits_of(string_to_number(field->value))), Kind::number, wanted};
  }
  build_->free(given);
  return emit_to(Kind::number, wanted, Op::digits, given.reg);
}

Operand Compiler::number_input(const Block& block, std::string_view name) {
  Operand out;
  if (list_item_as_number(block, name, Op::list_get_n, out)) return out;
  const BlockIndex at = content(block, name);
  if (at == kNone) return {number_constant(0), Kind::number, type::number};
  if (const Field* field = literal_field(program_.at(at))) {
    const double number = number_of(field->value);
    return {number_constant(number == number ? number : 0), Kind::number, type::number};
  }
  return as_number(expression(at));
}

Operand Compiler::value_input(const Block& block, std::string_view name) {
  const BlockIndex at = content(block, name);
  if (at != kNone) {
    const Block& inner = program_.at(at);
    const Field* field = literal_field(inner);
    if (field && !field->is_number) return {text_constant(field->value), Kind::value, types_.of_block(at)};
  }
  return as_value(expression(at));
}

/// An empty slot is false.
Operand Compiler::truth_input(const Block& block, std::string_view name) {
  const BlockIndex at = content(block, name);
  if (at == kNone) return {number_constant(0), Kind::number, type::truth};
  return as_truth(expression(at));
}

Operand Compiler::as_number(Operand operand) {
  if (operand.kind == Kind::number) return operand;
  build_->free(operand);
  return emit_to(Kind::number, type::number, Op::number, operand.reg);
}

Operand Compiler::as_value(Operand operand) {
  if (operand.kind == Kind::value) return operand;
  build_->free(operand);
  return emit_to(Kind::value, operand.types, box_of(operand), operand.reg);
}

/// The instruction that makes a value of what a number register holds.
Op Compiler::box_of(const Operand& operand) {
  if (operand.types == type::truth) return Op::box_t;
  if (is_mixed(operand.types)) return Op::box_mixed;
  return operand.types == type::digits ? Op::box_digits : Op::box_n;
}

Operand Compiler::as_truth(Operand operand) {
  if (operand.types == type::truth && operand.kind == Kind::number) return operand;
  build_->free(operand);
  const Op op = operand.kind == Kind::number ? Op::truth_n : Op::truth;
  return emit_to(Kind::number, type::truth, op, operand.reg);
}

Operand Compiler::kept(Operand operand) {
  if (operand.temporary) return operand;
  return emit_to(operand.kind, operand.types, operand.kind == Kind::number ? Op::set : Op::copy, operand.reg);
}

bool Compiler::jump_compare(BlockIndex condition, bool wanted, Label& to) {
  const Block& block = program_.at(condition);
  const bool equals = block.opcode == "operator_equals";
  if (!equals && block.opcode != "operator_lt" && block.opcode != "operator_gt") return false;
  Operand a;
  Operand b;
  build_->executed(1);
  if (!two_numbers(block, a, b)) {
    const Operand truth = comparison(block);
    build_->free(truth);
    build_->jump(wanted ? Op::jump_if : Op::jump_unless, to, truth.reg);
    return true;
  }
  build_->free(a);
  build_->free(b);
  if (block.opcode == "operator_gt") std::swap(a, b);
  const Op yes = equals ? Op::jump_equal : Op::jump_less;
  const Op no = equals ? Op::jump_unequal : Op::jump_not_less;
  build_->jump(wanted ? yes : no, to, a.reg, b.reg);
  return true;
}

void Compiler::jump_when(const Block& block, std::string_view name, bool wanted, Label& to) {
  BlockIndex at = content(block, name);
  while (at != kNone && program_.at(at).opcode == "operator_not" && program_.at(at).def) {
    build_->executed(1);
    wanted = !wanted;
    at = content(program_.at(at), "OPERAND");
  }
  if (at != kNone && jump_compare(at, wanted, to)) return;
  const Operand truth =
      at == kNone ? Operand{number_constant(0), Kind::number, type::truth} : as_truth(expression(at));
  build_->free(truth);
  build_->jump(wanted ? Op::jump_if : Op::jump_unless, to, truth.reg);
}

}  // namespace mirada::vm
