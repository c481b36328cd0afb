// Whose turn it is. A tick is made of passes; in a pass every script that can run has one turn, in the order
// of the list.
#include <algorithm>
#include <limits>
#include <utility>

#include "vm/machine_impl.h"

namespace mirada::vm {
namespace {

constexpr Micros kWarpTime = 500 * kMillisecond;
constexpr std::int64_t kTurnFuel = 50;  // what a turn takes beside its instructions, in block executions

}  // namespace

void Machine::Impl::tick(bool back_to_back) {
  ++tick_number;
  ticking_back_to_back = back_to_back;
  budget = static_cast<std::int64_t>(std::min<std::uint64_t>(limits.executions_per_tick, 1ULL << 60));
  if (limits.wall) tick_end = limits.wall->now() + limits.tick_time;
  wake_sleepers();
  if (started) look_at_edges();
  if (held()) {
    interrupted.store(false);
    return;
  }
  while (budget > 0 && !interrupted.load(std::memory_order_relaxed)) {
    if (!run_pass() || !next_pass_is_due()) break;
  }
  interrupted.store(false);
}

/// Whether the tick goes on after a whole pass. In a Scratch project one that shows something or begins to
/// wait ends the tick for all.
bool Machine::Impl::next_pass_is_due() {
  const bool shown = std::exchange(redraw, false) && !ticking_back_to_back;
  return pass_moved && !shown;
}

/// Live: whether the tick has had its wall time. Its budget is spent then.
bool Machine::Impl::out_of_time() {
  unwatched = 0;
  if (!limits.wall || limits.wall->now() < tick_end) return false;
  budget = 0;
  return true;
}

/// Whether a script that waits within "all at once" keeps the others out of this tick.
bool Machine::Impl::held() {
  if (!hold) return false;
  const bool due = hold->state == ThreadState::ready || hold->state == ThreadState::polling;
  if (!due && hold->state != ThreadState::done && host.now() < hold_until) return true;
  if (!due || host.now() >= hold_until) hold = nullptr;
  return false;
}

bool Machine::Impl::may_run(const Thread& thread) const {
  if (thread.state != ThreadState::ready && thread.state != ThreadState::polling) return false;
  return ticking_back_to_back || code->program.from_scratch || thread.visible_tick != tick_number;
}

/// One pass, or what was left of it when the last tick ended. False when the tick is over.
bool Machine::Impl::run_pass() {
  if (!pass_open) {
    pass_open = true;
    pass_index = 0;
    pass_turns = 0;
    pass_moved = false;
    disturbed = false;
    if (ticking_back_to_back) wake_sleepers();
  }
  while (pass_index < (doomed > 0 ? doomed : threads.size())) {
    Thread& thread = *threads[pass_index];
    if (!mid_turn && !may_run(thread)) {
      ++pass_index;
      continue;
    }
    if (!take_turn(thread)) return false;
    if (!pass_open) return true;  // all was stopped
    ++pass_index;
    if (budget <= 0 || interrupted.load(std::memory_order_relaxed)) return false;
  }
  close_pass();
  return true;
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
  const Exit exit = run_thread(thread);
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

/// Runs until the turn is over; looks up after each slice.
Exit Machine::Impl::run_thread(Thread& thread) {
  turn.thread = &thread;
  turn.warp = thread.warp;
  for (;;) {
    const std::int64_t fuel = fuel_for(thread);
    turn.fuel = fuel;
    turn.surcharge = 0;
    turn.frame = thread.frame();
    turn.exit = Exit::yielded;
    run_turn(turn, thread.at, globals.get());
    const std::int64_t spent = fuel - turn.fuel - turn.surcharge;
    budget -= spent;
    executions += static_cast<std::uint64_t>(spent);
    thread.turn_executions += static_cast<std::uint64_t>(spent);
    thread.warp = turn.warp;
    unwatched += fuel - turn.fuel + kTurnFuel;
    if (unwatched >= static_cast<std::int64_t>(limits.slice_executions)) out_of_time();
    if (turn.exit != Exit::preempted || thread.state == ThreadState::done) return turn.exit;
    if (turn.warp > 0 &&
        (thread.turn_executions >= limits.warp_executions || host.now() - thread.warp_since >= kWarpTime)) {
      return Exit::yielded;
    }
    if (budget <= 0 || interrupted.load(std::memory_order_relaxed)) return Exit::preempted;
  }
}

/// Scripts that have ended leave the list; who waited for them may go on in the next pass.
void Machine::Impl::close_pass() {
  pass_open = false;
  for (std::size_t i = 0; i < doomed; ++i) end_thread(*threads[i], ThreadEnd::killed);
  if (doomed > 0) hold = nullptr;
  doomed = 0;
  std::size_t kept = 0;
  for (Thread* thread : threads) {
    if (thread->state != ThreadState::done) {
      thread->place = kept;
      threads[kept++] = thread;
    } else {
      ended.push_back(thread);
    }
  }
  threads.resize(kept);
  for (Thread* thread : ended) {
    pass_moved = true;
    drop(*thread);
  }
  ended.clear();
  only_one = pass_turns == 1 && !disturbed;
  pass_alone_size = threads.size();
}

void Machine::Impl::wake_sleepers() {
  const Micros now = host.now();
  std::vector<Sleeper> later;
  while (!sleepers.empty() && std::get<0>(sleepers.top()) <= now) {
    const auto [wake, serial, thread] = sleepers.top();
    sleepers.pop();
    if (thread->serial != serial || thread->state != ThreadState::sleeping || thread->wake != wake) continue;
    if (thread->earliest_tick > tick_number) {
      later.emplace_back(wake, serial, thread);
      continue;
    }
    thread->state = ThreadState::ready;
    disturb();
  }
  for (Sleeper& sleeper : later) sleepers.push(sleeper);
}

void Machine::Impl::look_at_edges() {
  for (std::size_t i = 0; i < code->scripts.size(); ++i) {
    const Script& script = code->scripts[i];
    if (script.kind != HatKind::edge || edge_states[i] == EdgeState::broken) continue;
    for (Instance* instance : order) {
      if (instance->sprite != script.sprite || instance->is_clone) continue;
      const EdgeState before = edge_states[i];
      edge_states[i] = condition_of(script, *instance);
      if (before == EdgeState::low && edge_states[i] == EdgeState::high)
        start_thread(script, instance, false);
      break;
    }
  }
}

/// A hat's condition, worked out at once on a thread of its own; one that would have to wait does not hold,
/// one that faults is not looked at again.
EdgeState Machine::Impl::condition_of(const Script& script, Instance& instance) {
  Thread& thread = *new_thread(function_of(script.condition), &instance);
  thread.is_condition = true;
  const std::int64_t tick_budget = budget;
  const std::uint64_t before = executions;
  turn.solo = false;
  const Exit exit = thread.state == ThreadState::done ? Exit::faulted : run_thread(thread);
  budget = tick_budget;
  executions = before;
  thread.is_condition = false;
  recycle(thread);
  if (exit == Exit::faulted) return EdgeState::broken;
  return exit == Exit::ended && turn.returned.n != 0 ? EdgeState::high : EdgeState::low;
}

}  // namespace mirada::vm
