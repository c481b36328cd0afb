// The hot instructions: each has one copy of its handler for every place (frame or global) that its operands
// can be in, and goes straight on to the next instruction's handler. Those of interpreter_slow.cpp go back to
// the loop in run_turn.
#include "vm/digits.h"
#include "vm/handlers.h"
#include "vm/numbers.h"

namespace mirada::vm {
namespace {

template <bool kGlobal>
Slot& reg(Slot* frame, Slot* globals, std::int32_t operand) {
  return kGlobal ? globals[~operand] : frame[operand];
}

#define HOT_HANDLER(name)                                                             \
  template <bool kA, bool kB, bool kC>                                                \
  const Instr* hot_##name([[maybe_unused]] const Instr* at, [[maybe_unused]] Slot* f, \
                          [[maybe_unused]] Slot* g, [[maybe_unused]] Turn& t)
#define A (reg<kA>(f, g, at->a).n)
#define B (reg<kB>(f, g, at->b).n)
#define C (reg<kC>(f, g, at->c).n)

/// Where an operand is no number, or a text of digits. A function of its own, as those below, so that the
/// usual way needs no stack.
[[gnu::noinline]] const Instr* calculate(const Instr* at, Slot* f, Slot* g, [[maybe_unused]] Turn& t) {
  const double b = plain(any_reg(f, g, at->b).n);
  const double c =
      at->op == Op::round || at->op == Op::floor || at->op == Op::no_nan ? 0 : plain(any_reg(f, g, at->c).n);
  double& a = any_reg(f, g, at->a).n;
  if (at->op == Op::add) a = b + c;
  if (at->op == Op::subtract) a = b - c;
  if (at->op == Op::multiply) a = b * c;
  if (at->op == Op::divide) a = b / c;
  if (at->op == Op::mod) a = modulo(b, c);
  if (at->op == Op::round) a = round_half_up(b);
  if (at->op == Op::floor) a = floor_of(b);
  if (at->op == Op::no_nan) a = b;
  NEXT(at + 1);
}

// A result that is no number may come from an operand that is none.
HOT_HANDLER(add) {
  const double r = B + C;
  if (r != r) [[unlikely]]
    return calculate(at, f, g, t);
  A = r;
  NEXT(at + 1);
}
HOT_HANDLER(subtract) {
  const double r = B - C;
  if (r != r) [[unlikely]]
    return calculate(at, f, g, t);
  A = r;
  NEXT(at + 1);
}
HOT_HANDLER(multiply) {
  const double r = B * C;
  if (r != r) [[unlikely]]
    return calculate(at, f, g, t);
  A = r;
  NEXT(at + 1);
}
HOT_HANDLER(divide) {
  const double r = B / C;
  if (r != r) [[unlikely]]
    return calculate(at, f, g, t);
  A = r;
  NEXT(at + 1);
}
HOT_HANDLER(mod) {
  constexpr double kMost = 2147483647;
  const double x = B;
  const double y = C;
  if (!(x >= 1 && x <= kMost && y >= 1 && y <= kMost)) [[unlikely]]
    return calculate(at, f, g, t);
  const auto ix = static_cast<std::int32_t>(x);
  const auto iy = static_cast<std::int32_t>(y);
  if (static_cast<double>(ix) != x || static_cast<double>(iy) != y) [[unlikely]]
    return calculate(at, f, g, t);
  A = static_cast<double>(
      static_cast<std::int32_t>(static_cast<std::uint32_t>(ix) % static_cast<std::uint32_t>(iy)));
  NEXT(at + 1);
}
HOT_HANDLER(set) {
  A = B;
  NEXT(at + 1);
}
HOT_HANDLER(no_nan) {
  const double x = B;
  if (x != x) [[unlikely]]
    return calculate(at, f, g, t);
  A = x;
  NEXT(at + 1);
}
HOT_HANDLER(round) {
  const double x = B;
  if (x != x) [[unlikely]]
    return calculate(at, f, g, t);
  A = round_half_up(x);
  NEXT(at + 1);
}
HOT_HANDLER(floor) {
  const double x = B;
  if (x != x) [[unlikely]]
    return calculate(at, f, g, t);
  A = floor_of(x);
  NEXT(at + 1);
}

#define JUMP_WHEN(condition)                           \
  const Instr* to = (condition) ? at + at->c : at + 1; \
  if ((t.fuel -= at->executions) < 0) [[unlikely]]     \
    return out_of_fuel(to, t);                         \
  NEXT(to)

HOT_HANDLER(repeat) {
  const double left = A - 1;
  A = left;
  JUMP_WHEN(left < 0);
}
HOT_HANDLER(repeat_back) {
  const double left = A - 1;
  A = left;
  JUMP_WHEN(left >= 0);
}
HOT_HANDLER(jump_if) { JUMP_WHEN(A != 0); }
HOT_HANDLER(jump_unless) { JUMP_WHEN(A == 0); }

/// Comparing where an operand is no number, or a text of digits.
[[gnu::noinline]] const Instr* compare_and_jump(const Instr* at, Slot* f, Slot* g, Turn& t) {
  const double a = behind_digits(any_reg(f, g, at->a).n);
  const double b = behind_digits(any_reg(f, g, at->b).n);
  const bool less = at->op == Op::jump_less || at->op == Op::jump_not_less;
  const bool holds = less ? less_numbers(a, b) : equal_numbers(a, b);
  JUMP_WHEN(holds == (at->op == Op::jump_less || at->op == Op::jump_equal));
}
#define COMPARED(condition)               \
  const double a = A;                     \
  const double b = B;                     \
  if (!(a < b) && !(a >= b)) [[unlikely]] \
    return compare_and_jump(at, f, g, t); \
  JUMP_WHEN(condition)
HOT_HANDLER(jump_less) { COMPARED(a < b); }
HOT_HANDLER(jump_not_less) { COMPARED(!(a < b)); }
HOT_HANDLER(jump_equal) { COMPARED(a == b); }
HOT_HANDLER(jump_unequal) { COMPARED(a != b); }
#undef COMPARED

/// The 0-based place of a 1-based, perhaps broken index; past the end when there is none.
std::size_t place_of(double index, std::size_t length) {
  if (!(index >= 1) || index >= static_cast<double>(length) + 1) return length;
  return static_cast<std::size_t>(static_cast<std::int64_t>(index)) - 1;
}

HOT_HANDLER(list_add_n) {
  List& list = list_at(t, at->a);
  if (list.numbers.size() == list.numbers.capacity()) return slow_add_number(at, list, B, t);
  if (list.numbers.size() < List::kMaxItems) list.numbers.push_back(B);
  NEXT(at + 1);
}
/// The same where there is no such place at first sight: the index may be a text of digits.
[[gnu::noinline]] const Instr* look_in_list(const Instr* at, Slot* f, Slot* g, Turn& t) {
  if (at->op == Op::list_set_n) {
    List& list = list_at(t, at->a);
    const std::size_t i = place_of(plain(any_reg(f, g, at->b).n), list.numbers.size());
    if (i < list.numbers.size()) list.numbers[i] = any_reg(f, g, at->c).n;
    NEXT(at + 1);
  }
  const List& list = list_at(t, at->b);
  const std::size_t i = place_of(plain(any_reg(f, g, at->c).n), list.numbers.size());
  const double nothing = at->op == Op::list_get_n ? 0 : std::numeric_limits<double>::quiet_NaN();
  any_reg(f, g, at->a).n = i < list.numbers.size() ? list.numbers[i] : nothing;
  NEXT(at + 1);
}
HOT_HANDLER(list_get_n) {
  const List& list = list_at(t, at->b);
  const std::size_t i = place_of(C, list.numbers.size());
  if (i >= list.numbers.size()) [[unlikely]]
    return look_in_list(at, f, g, t);
  A = list.numbers[i];
  NEXT(at + 1);
}
HOT_HANDLER(list_peek_n) {
  const List& list = list_at(t, at->b);
  const std::size_t i = place_of(C, list.numbers.size());
  if (i >= list.numbers.size()) [[unlikely]]
    return look_in_list(at, f, g, t);
  A = list.numbers[i];
  NEXT(at + 1);
}
HOT_HANDLER(list_set_n) {
  List& list = list_at(t, at->a);
  const std::size_t i = place_of(B, list.numbers.size());
  if (i >= list.numbers.size()) [[unlikely]]
    return look_in_list(at, f, g, t);
  list.numbers[i] = C;
  NEXT(at + 1);
}
HOT_HANDLER(list_length) {
  A = static_cast<double>(list_at(t, at->b).size());
  NEXT(at + 1);
}

#undef A
#undef B
#undef C

#define OP(name, a, b, c, meaning) \
  {slow_##name, slow_##name, slow_##name, slow_##name, slow_##name, slow_##name, slow_##name, slow_##name},
#define HOT(name, a, b, c, meaning)                                                                 \
  {hot_##name<false, false, false>, hot_##name<true, false, false>, hot_##name<false, true, false>, \
   hot_##name<true, true, false>,   hot_##name<false, false, true>, hot_##name<true, false, true>,  \
   hot_##name<false, true, true>,   hot_##name<true, true, true>},
constexpr Handler kHandlers[][8] = {
#include "vm/opcodes.def"
};
#undef OP
#undef HOT

bool is_register(char operand) {
  return operand == 'n' || operand == 'N' || operand == 'v' || operand == 'V';
}

}  // namespace

Handler handler_of(const Instr& instr) {
  const OpRow& row = row_of(instr.op);
  const unsigned a = is_register(row.a) && instr.a < 0 ? 1 : 0;
  const unsigned b = is_register(row.b) && instr.b < 0 ? 2 : 0;
  const unsigned c = is_register(row.c) && instr.c < 0 ? 4 : 0;
  return kHandlers[static_cast<std::size_t>(instr.op)][a + b + c];
}

void run_turn(Turn& turn, const Instr* at, Slot* globals) {
  while (at) at = at->run(at, turn.frame, globals, turn);
}

}  // namespace mirada::vm
