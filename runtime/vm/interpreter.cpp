// The hot instructions: each has one copy of its handler for every place (frame or global) that its operands
// can be in, and goes straight on to the next instruction's handler. Those of interpreter_slow.cpp go back to
// the loop in run_turn.
#include "vm/handlers.h"
#include "vm/numbers.h"

namespace mirada::vm {
namespace {

/// Reads 0 for what is no number.
double plain(double x) { return x == x ? x : 0; }

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

// A result that is no number may come from an operand that is none, which counts as 0.
HOT_HANDLER(add) {
  double r = B + C;
  if (r != r) [[unlikely]]
    r = plain(B) + plain(C);
  A = r;
  NEXT(at + 1);
}
HOT_HANDLER(subtract) {
  double r = B - C;
  if (r != r) [[unlikely]]
    r = plain(B) - plain(C);
  A = r;
  NEXT(at + 1);
}
HOT_HANDLER(multiply) {
  double r = B * C;
  if (r != r) [[unlikely]]
    r = plain(B) * plain(C);
  A = r;
  NEXT(at + 1);
}
HOT_HANDLER(divide) {
  double r = B / C;
  if (r != r) [[unlikely]]
    r = plain(B) / plain(C);
  A = r;
  NEXT(at + 1);
}
/// mod where an operand is not a small whole number above 0. A function of its own, so that the usual way
/// needs no stack.
[[gnu::noinline]] const Instr* mod_of_any(const Instr* at, Slot* f, Slot* g, [[maybe_unused]] Turn& t) {
  any_reg(f, g, at->a).n = slow_mod(any_reg(f, g, at->b).n, any_reg(f, g, at->c).n);
  NEXT(at + 1);
}
HOT_HANDLER(mod) {
  const double x = B;
  const double y = C;
  const auto ix = static_cast<std::int32_t>(x);
  const auto iy = static_cast<std::int32_t>(y);
  const bool whole = static_cast<double>(ix) == x && static_cast<double>(iy) == y;
  if (!whole || ix <= 0 || iy <= 0) [[unlikely]]
    return mod_of_any(at, f, g, t);
  A = static_cast<double>(
      static_cast<std::int32_t>(static_cast<std::uint32_t>(ix) % static_cast<std::uint32_t>(iy)));
  NEXT(at + 1);
}
HOT_HANDLER(set) {
  A = B;
  NEXT(at + 1);
}
HOT_HANDLER(no_nan) {
  A = plain(B);
  NEXT(at + 1);
}
HOT_HANDLER(round) {
  A = round_half_up(plain(B));
  NEXT(at + 1);
}
HOT_HANDLER(floor) {
  A = floor_of(plain(B));
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
HOT_HANDLER(jump_less) { JUMP_WHEN(less_numbers(A, B)); }
HOT_HANDLER(jump_not_less) { JUMP_WHEN(!less_numbers(A, B)); }
HOT_HANDLER(jump_equal) { JUMP_WHEN(equal_numbers(A, B)); }
HOT_HANDLER(jump_unequal) { JUMP_WHEN(!equal_numbers(A, B)); }

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
HOT_HANDLER(list_get_n) {
  const List& list = list_at(t, at->b);
  const std::size_t i = place_of(C, list.numbers.size());
  A = i < list.numbers.size() ? list.numbers[i] : 0;
  NEXT(at + 1);
}
HOT_HANDLER(list_peek_n) {
  const List& list = list_at(t, at->b);
  const std::size_t i = place_of(C, list.numbers.size());
  A = i < list.numbers.size() ? list.numbers[i] : std::numeric_limits<double>::quiet_NaN();
  NEXT(at + 1);
}
HOT_HANDLER(list_set_n) {
  List& list = list_at(t, at->a);
  const std::size_t i = place_of(B, list.numbers.size());
  if (i < list.numbers.size()) list.numbers[i] = C;
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
