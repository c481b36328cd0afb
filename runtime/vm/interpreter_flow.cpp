// Instructions that decide which way the program goes: jumps, yields, calls, messages, native blocks.
#include <algorithm>
#include <limits>

#include "vm/digits.h"
#include "vm/handlers.h"
#include "vm/messages.h"
#include "vm/native_call.h"

namespace mirada::vm {

#define HANDLER(name) \
  const Instr* slow_##name(const Instr* at, [[maybe_unused]] Slot* f, [[maybe_unused]] Slot* g, Turn& t)
#define A (any_reg(f, g, at->a))
#define B (any_reg(f, g, at->b))

namespace {

constexpr std::size_t kStartWork = 20;  // what starting a script costs, in block executions

const Instr* end_turn(Turn& t, const Instr* resume, const Instr* shown, Exit exit) {
  t.thread->at = resume;
  t.thread->shown = shown;
  t.exit = exit;
  return nullptr;
}

BlockIndex block_at(const Turn& t, const Instr* at) { return t.thread->block_at(at); }

/// Scratch's test: whether one of the six stack entries below the call (C-blocks and calls) is a call of the
/// same block.
bool calls_itself(const Thread& thread, const Function& function, std::int32_t depth) {
  int left = 6 - depth;
  for (std::size_t i = thread.frames.size(); i-- > 1 && left > 0;) {
    if (thread.frames[i].function == &function) return true;
    left -= 1 + thread.frames[i].depth;
  }
  return false;
}

}  // namespace

const Instr* out_of_fuel(const Instr* to, Turn& turn) { return end_turn(turn, to, to, Exit::preempted); }

const Instr* charge(const Instr* next, Turn& turn, std::size_t work) {
  if (work == 0) return next;
  turn.fuel -= static_cast<std::int64_t>(work);
  turn.surcharge += static_cast<std::int64_t>(work);
  return turn.fuel < 0 ? out_of_fuel(next, turn) : next;
}

const Instr* fail(const Instr* at, Turn& turn, const Message& message, MessageArgs args) {
  turn.machine->fault(*turn.thread, block_at(turn, at), message, std::move(args));
  return end_turn(turn, at, at, Exit::faulted);
}

const Instr* fail_memory(const Instr* at, Turn& turn) {
  const std::size_t limit = turn.machine->limits.max_total_bytes >> 20;
  return fail(at, turn, messages::out_of_memory, {{"limit_mib", std::to_string(limit)}});
}

HANDLER(end) {
  t.fuel -= at->executions;
  return end_turn(t, at, at, Exit::ended);
}

HANDLER(jump) {
  const Instr* to = at + at->c;
  if ((t.fuel -= at->executions) < 0) [[unlikely]]
    return out_of_fuel(to, t);
  NEXT(to);
}

HANDLER(count) {
  t.fuel -= at->executions;
  NEXT(at + 1);
}

HANDLER(loop) {
  const Instr* to = at + at->c;
  t.fuel -= at->executions;
  if (t.warp > 0) {
    if (t.fuel < 0) [[unlikely]]
      return out_of_fuel(to, t);
    NEXT(to);
  }
  if (t.solo && t.fuel >= 0) NEXT(to);
  return end_turn(t, to, at, Exit::yielded);
}

HANDLER(poll) {
  t.fuel -= at->executions;
  t.thread->state = ThreadState::polling;
  return end_turn(t, at + at->c, at, Exit::polled);
}

HANDLER(warp_on) {
  ++t.warp;
  return at + 1;
}

HANDLER(warp_off) {
  t.fuel -= at->executions;
  --t.warp;
  return at + 1;
}

namespace {

/// A call that needs more than a frame: values among its registers, memory, a yield.
[[gnu::noinline]] const Instr* call_slowly(const Instr* at, Slot* f, [[maybe_unused]] Slot* g, Turn& t) {
  Thread& thread = *t.thread;
  const Function& function = t.functions[at->a];
  const std::uint32_t base = thread.frames.back().base + static_cast<std::uint32_t>(at->c);
  t.fuel -= at->executions;
  const bool recursion = t.warp == 0 && !function.warp && calls_itself(thread, function, at->b);
  if (!t.machine->push_frame(thread, function, at + 1, at->b, base, t.warp, block_at(t, at))) {
    return end_turn(t, at, at, Exit::faulted);
  }
  t.frame = f = thread.frame();
  t.warp += function.warp ? 1 : 0;
  const Instr* to = function.code.data();
  if (recursion) return end_turn(t, to, to, Exit::yielded);
  if (t.fuel < 0) return out_of_fuel(to, t);
  NEXT(to);
}

/// Gives the frame back; the instruction after the call, or null at the end of a hat's condition.
const Instr* leave(Slot* f, Turn& t) {
  Thread& thread = *t.thread;
  const Frame top = thread.frames.back();
  for (const std::uint16_t slot : top.function->value_slots) f[slot].v.~Value();
  thread.frames.pop_back();
  t.warp = top.warp_before;
  if (thread.frames.empty()) {
    t.exit = Exit::ended;
    return nullptr;
  }
  t.frame = f - top.up;
  return top.back;
}

[[gnu::noinline]] const Instr* leave_slowly(const Instr*, Slot* f, [[maybe_unused]] Slot* g, Turn& t) {
  const Instr* to = leave(f, t);
  if (!to) return nullptr;
  f = t.frame;
  NEXT(to);
}

}  // namespace

// Calls and returns without values take a short way: no more than a frame is written or read. What is longer
// is left to a function of its own, so that this one needs no stack.
HANDLER(call) {
  Thread& thread = *t.thread;
  const Function& function = t.functions[at->a];
  const std::uint32_t base = thread.frames.back().base + static_cast<std::uint32_t>(at->c);
  const bool may_yield = t.warp == 0 && !function.warp;
  if (may_yield || !function.value_slots.empty() || base + function.reserve > thread.capacity ||
      thread.frames.full()) [[unlikely]] {
    return call_slowly(at, f, g, t);
  }
  t.fuel -= at->executions;
  thread.frames.push({&function, at + 1, base, at->b, t.warp, at->c});
  t.frame = f += at->c;
  t.warp += function.warp ? 1 : 0;
  const Instr* to = function.code.data();
  if (t.fuel < 0) [[unlikely]]
    return out_of_fuel(to, t);
  NEXT(to);
}

#define RETURN()                                              \
  const Frame& top = t.thread->frames.back();                 \
  const Instr* to = top.back;                                 \
  if (!to || !top.function->value_slots.empty()) [[unlikely]] \
    return leave_slowly(at, f, g, t);                         \
  t.warp = top.warp_before;                                   \
  t.frame = f -= top.up;                                      \
  t.thread->frames.pop_back();                                \
  NEXT(to)

HANDLER(ret) {
  t.fuel -= at->executions;
  t.returned.n = 0;
  RETURN();
}
HANDLER(ret_n) {
  t.fuel -= at->executions;
  t.returned.n = A.n;
  RETURN();
}
HANDLER(ret_v) {
  t.fuel -= at->executions;
  t.returned_value = A.v;
  return leave(f, t);
}
HANDLER(take_n) {
  A.n = t.returned.n;
  NEXT(at + 1);
}
HANDLER(take_v) {
  A.v = std::move(t.returned_value);
  return at + 1;
}

HANDLER(stop_all) {
  t.fuel -= at->executions;
  t.machine->stop_all_by_block();
  return end_turn(t, at, at, Exit::ended);
}

HANDLER(stop_others) {
  t.machine->stop_others(*t.thread);
  return at + 1;
}

HANDLER(wait) {
  t.fuel -= at->executions;
  t.machine->redraw = t.machine->code->program.from_scratch;
  const double seconds = std::max(plain(A.n), 0.0);
  const Micros now = t.machine->host.now();
  t.machine->sleep(*t.thread, seconds < 1e9 ? now + micros(seconds) : std::numeric_limits<Micros>::max() / 2,
                   false);
  return end_turn(t, at + 1, at, Exit::slept);
}

HANDLER(broadcast) {
  t.fuel -= at->executions;
  const std::size_t started = t.machine->broadcast(to_string(A.v)).size();
  if (t.fuel < 0) return out_of_fuel(at + 1, t);
  return charge(at + 1, t, started * kStartWork);
}

HANDLER(broadcast_wait) {
  t.fuel -= at->executions;
  const std::vector<Thread*> started = t.machine->broadcast(to_string(A.v));
  if (started.empty()) return t.fuel < 0 ? out_of_fuel(at + 1, t) : at + 1;
  t.machine->join(*t.thread, started);
  return end_turn(t, at + 1, at, Exit::joined);
}

HANDLER(await) {
  if (t.machine->look_at_joined(*t.thread)) return at + 1;
  return end_turn(t, at, at, t.thread->dozes ? Exit::yielded : Exit::joined);
}

HANDLER(native) {
  const NativeSite& site = t.machine->native_site(at->a);
  Thread& thread = *t.thread;
  NativeCallOf call(site, thread, t.machine->host, t.machine->code->program.at(site.block).id, f, g);
  // Who asks for a value does nothing with it, whatever stands in a my-block on the way.
  const bool acts = site.def->shape == Shape::command || site.def->shape == Shape::cap;
  NativeResult result = thread.is_question && acts ? NativeResult::finished() : site.def->native(call);
  if (site.def->visible) {
    thread.visible_tick = t.machine->tick_number;
    t.solo = false;
  }
  if (result.kind == NativeResult::Kind::again) {
    t.machine->sleep(thread, result.not_before, true);
    return end_turn(t, at, at, Exit::slept);
  }
  thread.native_state.reset();
  t.fuel -= at->executions;
  if (result.kind == NativeResult::Kind::fault) {
    t.machine->fault(thread, site.block, *result.message, std::move(result.args));
    return end_turn(t, at, at, Exit::faulted);
  }
  Value& out = B.v;
  switch (result.kind) {
    case NativeResult::Kind::number:
      out = Value(result.number);
      break;
    case NativeResult::Kind::text:
      out = make_text(t.machine->heap, std::string_view(result.text));
      break;
    case NativeResult::Kind::truth:
      out = Value(result.truth);
      break;
    default:
      out = Value();
      break;
  }
  if (t.machine->out_of_memory()) return fail_memory(at, t);
  return t.fuel < 0 ? out_of_fuel(at + 1, t) : at + 1;
}

HANDLER(answer) {
  t.machine->answer(*t.thread, A.v);
  return at + 1;
}

HANDLER(timer) {
  A.n = seconds(t.machine->host.now() - t.machine->timer_zero);
  return at + 1;
}

HANDLER(reset_timer) {
  t.machine->timer_zero = t.machine->host.now();
  return at + 1;
}

HANDLER(counter) {
  A.n = t.machine->counter;
  return at + 1;
}

HANDLER(count_up) {
  t.machine->counter += 1;
  return at + 1;
}

HANDLER(clear_counter) {
  t.machine->counter = 0;
  return at + 1;
}

HANDLER(say) {
  t.machine->host.say(ThreadId{t.thread->serial}, t.machine->code->program.at(block_at(t, at)).id,
                      to_string(A.v));
  t.machine->redraw = t.machine->code->program.from_scratch;
  t.thread->visible_tick = t.machine->tick_number;
  t.solo = false;
  return at + 1;
}

HANDLER(clone) {
  t.machine->clone(*t.thread, A.v);
  t.solo = false;
  return at + 1;
}

HANDLER(layer) {
  t.machine->move_by_layers(*t.thread->instance, A.n);
  return at + 1;
}

HANDLER(delete_clone) {
  t.fuel -= at->executions;
  if (!t.thread->instance->is_clone) return at + 1;
  t.machine->delete_clone(*t.thread);
  return end_turn(t, at, at, Exit::ended);
}

HANDLER(load_n) {
  A.n = t.thread->instance->slots[static_cast<std::size_t>(at->b)].n;
  return at + 1;
}
HANDLER(load_v) {
  A.v = t.thread->instance->slots[static_cast<std::size_t>(at->b)].v;
  return at + 1;
}
HANDLER(load_of_n) {
  A.n = t.machine->instances[static_cast<std::size_t>(at->c)]->slots[static_cast<std::size_t>(at->b)].n;
  return at + 1;
}
HANDLER(load_of_v) {
  A.v = t.machine->instances[static_cast<std::size_t>(at->c)]->slots[static_cast<std::size_t>(at->b)].v;
  return at + 1;
}
HANDLER(store_n) {
  t.thread->instance->slots[static_cast<std::size_t>(at->b)].n = A.n;
  return at + 1;
}
HANDLER(store_v) {
  t.thread->instance->slots[static_cast<std::size_t>(at->b)].v = A.v;
  return at + 1;
}

}  // namespace mirada::vm
