#pragma once
#include "vm/machine_impl.h"

// Going on to the next instruction: a tail call where the compiler makes one, else back to the loop in
// run_turn.
#if defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && \
    !defined(MIRADA_NO_TAIL_CALLS)
#define NEXT(to)                       \
  do {                                 \
    const Instr* next_ = (to);         \
    return next_->run(next_, f, g, t); \
  } while (false)
#else
#define NEXT(to) return (to)
#endif

namespace mirada::vm {

// Handlers that are no hot ones, by the names of opcodes.def. interpreter_slow.cpp, interpreter_flow.cpp.
#define OP(name, a, b, c, meaning) const Instr* slow_##name(const Instr* at, Slot* f, Slot* g, Turn& t);
#define HOT(name, a, b, c, meaning)
#include "vm/opcodes.def"
#undef OP
#undef HOT

/// Ends the turn because the fuel is spent; the script will go on at `to`.
const Instr* out_of_fuel(const Instr* to, Turn& turn);
/// Ends the script with a fault on the block of the instruction.
const Instr* fail(const Instr* at, Turn& turn, const Message& message, MessageArgs args = {});
const Instr* fail_memory(const Instr* at, Turn& turn);
/// What dear instructions cost beside the block execution that they are.
const Instr* charge(const Instr* next, Turn& turn, std::size_t work);
/// Whether somebody wants the tick to end (Stop): long instructions ask now and then, give up, and are begun
/// again when the script goes on.
inline bool hurried(const Turn& turn) { return turn.machine->interrupted.load(std::memory_order_relaxed); }
double slow_mod(double a, double b);
const Instr* slow_add_number(const Instr* at, List& list, double number, Turn& turn);

inline List& list_at(Turn& turn, std::int32_t index) {
  if (index >= 0) return turn.lists[index];
  return turn.lists[turn.thread->instance->lists[static_cast<std::size_t>(~index)]];
}

inline Slot& any_reg(Slot* frame, Slot* globals, std::int32_t operand) {
  return operand < 0 ? globals[~operand] : frame[operand];
}

}  // namespace mirada::vm
