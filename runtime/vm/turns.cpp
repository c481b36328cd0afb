// One script's turn after another. Most begin ready and end with a plain yield: they take a short way, on
// which nothing is kept but where the script goes on.
#include <algorithm>

#include "vm/machine_impl.h"

namespace mirada::vm {
namespace {

constexpr Micros kWarpTime = 500 * kMillisecond;
constexpr std::int64_t kTurnFuel = 50;  // what a turn takes beside its instructions, in block executions

}  // namespace

/// Whether a turn of this script may take the short way: it is in no "all at once", and nobody is alone, held
/// up or about to go.
bool Machine::Impl::is_quick(const Thread& thread) const {
  return thread.warp == 0 && thread.state == ThreadState::ready && !mid_turn && !only_one && !hold &&
         doomed == 0;
}

/// Turns from pass_index on; the books are kept for all of them together. Ends before the first script that
/// is not quick, when budget, slice or list are at their end, or with a turn that is more than a plain yield:
/// its script is given, for finish_quick_turn.
Thread* Machine::Impl::quick_turns() {
  const std::int64_t fuel = std::min(budget, static_cast<std::int64_t>(limits.slice_executions));
  const std::int64_t most_turns = static_cast<std::int64_t>(limits.slice_executions) / kTurnFuel + 1;
  const bool free = ticking_back_to_back || code->program.from_scratch;
  Slot* const global = globals.get();
  Thread* pending = nullptr;
  std::int64_t turns = 0;
  turn.fuel = fuel;
  turn.surcharge = 0;
  turn.warp = 0;
  turn.solo = false;
  do {
    Thread& thread = *threads[pass_index];
    if (thread.state != ThreadState::ready || thread.warp != 0 ||
        (!free && thread.visible_tick == tick_number)) {
      break;
    }
    ++turns;
    thread.turn_executions = static_cast<std::uint64_t>(turn.fuel + turn.surcharge);
    turn.thread = current = &thread;
    turn.frame = thread.frame();
    const Instr* at = thread.at;
    while (at) at = at->run(at, turn.frame, global, turn);
    if (turn.exit != Exit::yielded || thread.state != ThreadState::ready || !pass_open) pending = &thread;
  } while (!pending && ++pass_index < threads.size() && turn.fuel > 0 && turns < most_turns &&
           !interrupted.load(std::memory_order_relaxed));
  if (pending) {
    pending->turn_executions -= static_cast<std::uint64_t>(turn.fuel + turn.surcharge);
  } else {
    current = nullptr;
  }
  pass_moved = pass_moved || turns > (pending ? 1 : 0);
  pass_turns += static_cast<std::size_t>(turns);
  settle(fuel, turns);
  return pending;
}

/// Keeps the books of what was done on `fuel`, in so many turns.
void Machine::Impl::settle(std::int64_t fuel, std::int64_t turns) {
  const std::int64_t spent = fuel - turn.fuel - turn.surcharge;
  budget -= spent;
  executions += static_cast<std::uint64_t>(spent);
  unwatched += fuel - turn.fuel + kTurnFuel * turns;
  if (unwatched >= static_cast<std::int64_t>(limits.slice_executions)) out_of_time();
}

/// What is left of a turn that began on the short way.
Exit Machine::Impl::finish_quick_turn(Thread& thread) {
  thread.warp_since = host.now();
  thread.warp = turn.warp;
  return turn_is_over(thread) ? turn.exit : run_thread(thread);
}

/// One script's turn, or what is left of it. False when the tick ends within the turn.
bool Machine::Impl::take_turn(Thread& thread) {
  if (!mid_turn) {
    thread.warp_since = host.now();
    thread.turn_executions = 0;
    ++pass_turns;
  }
  mid_turn = false;
  if (thread.state == ThreadState::polling) thread.state = ThreadState::ready;
  turn.solo = only_one && threads.size() == pass_alone_size && !thread.is_question;
  current = &thread;
  return close_turn(thread, run_thread(thread));
}

/// What the end of a turn means for the script and for the others. False when the tick ends within the turn.
bool Machine::Impl::close_turn(Thread& thread, Exit exit) {
  current = nullptr;
  if (exit != Exit::polled) pass_moved = true;
  if (exit == Exit::ended || exit == Exit::faulted) {
    end_thread(thread, exit == Exit::ended ? ThreadEnd::finished : ThreadEnd::faulted);
  }
  const bool listed = pass_open && pass_index < threads.size() && threads[pass_index] == &thread;
  if (!listed) {
    drop(thread);  // stopped or started again by itself
    return true;
  }
  if (thread.state == ThreadState::done) return true;
  if (exit == Exit::preempted) {
    mid_turn = true;
    return false;
  }
  return !keeps_others_out(thread, exit);
}

/// A script that waits within "all at once" holds the others up, but no longer than all at once may take.
bool Machine::Impl::keeps_others_out(Thread& thread, Exit exit) {
  const bool waits = exit == Exit::polled || exit == Exit::slept || exit == Exit::joined;
  if (!waits || thread.warp == 0) {
    hold = nullptr;
    return false;
  }
  if (hold != &thread) hold_until = host.now() + kWarpTime;
  hold = host.now() < hold_until ? &thread : nullptr;
  return hold != nullptr;
}

std::int64_t Machine::Impl::fuel_for(const Thread& thread) const {
  std::int64_t fuel = std::min(budget, static_cast<std::int64_t>(limits.slice_executions));
  if (turn.warp > 0) {
    const std::uint64_t used = std::min(thread.turn_executions, limits.warp_executions);
    fuel = std::min(fuel, static_cast<std::int64_t>(limits.warp_executions - used));
  }
  return std::max<std::int64_t>(fuel, 0);
}

/// After a slice: whether the turn ends here, and (turn.exit) how.
bool Machine::Impl::turn_is_over(const Thread& thread) {
  if (turn.exit != Exit::preempted || thread.state == ThreadState::done) return true;
  if (turn.warp > 0 &&
      (thread.turn_executions >= limits.warp_executions || host.now() - thread.warp_since >= kWarpTime)) {
    turn.exit = Exit::yielded;
    return true;
  }
  return budget <= 0 || interrupted.load(std::memory_order_relaxed);
}

/// Runs until the turn is over; looks up after each slice.
Exit Machine::Impl::run_thread(Thread& thread) {
  turn.thread = &thread;
  turn.warp = thread.warp;
  do {
    const std::int64_t fuel = fuel_for(thread);
    turn.fuel = fuel;
    turn.surcharge = 0;
    turn.frame = thread.frame();
    turn.exit = Exit::yielded;
    run_turn(turn, thread.at, globals.get());
    thread.turn_executions += static_cast<std::uint64_t>(fuel - turn.fuel - turn.surcharge);
    thread.warp = turn.warp;
    settle(fuel, 1);
  } while (!turn_is_over(thread));
  return turn.exit;
}

}  // namespace mirada::vm
