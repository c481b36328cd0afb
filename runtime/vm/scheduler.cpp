// Whose turn it is. A tick is made of passes; in a pass every script that can run has one turn, in the order
// of the list. The turns themselves: turns.cpp.
#include <algorithm>
#include <limits>
#include <utility>

#include "vm/machine_impl.h"

namespace mirada::vm {
void Machine::Impl::tick(bool back_to_back) {
  ++tick_number;
  ticking_back_to_back = back_to_back;
  budget = static_cast<std::int64_t>(std::min<std::uint64_t>(limits.executions_per_tick, 1ULL << 60));
  wake_sleepers();
  if (limits.wall) {
    tick_start = limits.wall->now();
    tick_end = tick_start + limits.tick_time;
    end_tick_at(next_sleeper());
  }
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
/// wait ends the tick for all; back to back the next one follows at once.
bool Machine::Impl::next_pass_is_due() {
  const bool shown = std::exchange(redraw, false);
  if (shown && ticking_back_to_back) ++tick_number;
  return pass_moved && (!shown || ticking_back_to_back);
}

/// Live: whether the tick has had its wall time. Its budget is spent then.
bool Machine::Impl::out_of_time() {
  unwatched = 0;
  if (!limits.wall || limits.wall->now() < tick_end) return false;
  budget = 0;
  return true;
}

/// Live: no tick goes on when a script has slept enough, so that it need not wait for those that never do.
void Machine::Impl::end_tick_at(Micros wake) {
  const Micros left = wake - host.now();
  if (left > 0 && left < limits.tick_time) tick_end = std::min(tick_end, tick_start + left);
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
    if (is_quick(thread)) {
      Thread* last = quick_turns();
      if (last && !close_turn(*last, finish_quick_turn(*last))) return false;
      if (last) ++pass_index;
    } else {
      if (!take_turn(thread)) return false;
      ++pass_index;
    }
    if (!pass_open) return true;  // all was stopped
    if (budget <= 0 || interrupted.load(std::memory_order_relaxed)) return false;
  }
  close_pass();
  return true;
}

void Machine::Impl::close_pass() {
  pass_open = false;
  for (std::size_t i = 0; i < doomed; ++i) end_thread(*threads[i], ThreadEnd::killed);
  if (doomed > 0) hold = nullptr;
  doomed = 0;
  if (someone_ended) clear_ended();
  only_one = pass_turns == 1 && !disturbed;
  pass_alone_size = threads.size();
}

/// Scripts that have ended leave the list; who waited for them may go on in the next pass.
void Machine::Impl::clear_ended() {
  someone_ended = false;
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
