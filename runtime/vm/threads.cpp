// How scripts start and end: threads, frames, messages, stop.
#include <algorithm>
#include <cassert>
#include <limits>

#include "vm/machine_impl.h"
#include "vm/message_name.h"
#include "vm/messages.h"

namespace mirada::vm {
namespace {

/// What a call that is refused was given: no frame will give it back.
void drop_arguments(Thread& thread, const Function& function, std::uint32_t base) {
  if (thread.frames.empty()) return;
  for (const std::uint16_t slot : function.value_slots) {
    if (slot < function.params) thread.stack[base + slot].v.~Value();
  }
}

}  // namespace

Thread* Machine::Impl::new_thread(const Function& function, Instance* instance) {
  if (spare.empty()) spare.push_back(&pool.emplace_back());
  Thread& thread = *spare.back();
  spare.pop_back();
  thread.serial = next_serial++;
  thread.state = ThreadState::ready;
  thread.end = ThreadEnd::finished;
  thread.instance = instance;
  thread.visible_tick = 0;
  thread.earliest_tick = 0;
  thread.warp = 0;
  thread.pending = 0;
  thread.active = 0;
  thread.dozes = false;
  thread.at = function.code.data();
  thread.shown = thread.at;
  if (!push_frame(thread, function, nullptr, 0, 0, 0, function.block_of.front())) {
    thread.state = ThreadState::done;
    someone_ended = true;
  }
  return &thread;
}

/// Room for a frame, and its registers set to nothing. False (with a fault) when depth or memory are spent.
bool Machine::Impl::push_frame(Thread& thread, const Function& function, const Instr* back,
                               std::int32_t depth, std::uint32_t base, std::int32_t warp, BlockIndex caller) {
  if (thread.frames.size() >= limits.max_depth) {
    drop_arguments(thread, function, base);
    fault(thread, caller, messages::too_deep, {{"limit", std::to_string(limits.max_depth)}});
    return false;
  }
  if (base + function.reserve > thread.capacity) {
    const std::uint32_t wanted = base + function.reserve;
    const std::uint32_t capacity = base == 0 ? wanted : wanted * 2;
    list_bytes += (capacity - thread.capacity) * sizeof(Slot);
    if (out_of_memory()) {
      list_bytes -= (capacity - thread.capacity) * sizeof(Slot);
      drop_arguments(thread, function, base);
      fault(thread, caller, messages::out_of_memory,
            {{"limit_mib", std::to_string(limits.max_total_bytes >> 20)}});
      return false;
    }
    auto larger = std::make_unique<Slot[]>(capacity);
    if (thread.capacity > 0) {
      std::memcpy(static_cast<void*>(larger.get()), static_cast<const void*>(thread.stack.get()),
                  thread.capacity * sizeof(Slot));
    }
    thread.stack = std::move(larger);
    thread.capacity = capacity;
  }
  for (const std::uint16_t slot : function.value_slots) {
    if (slot >= function.params) new (&thread.stack[base + slot]) Slot();
  }
  const std::uint32_t up = thread.frames.empty() ? 0 : base - thread.frames.back().base;
  thread.frames.push_back({&function, back, base, depth, warp, static_cast<std::int32_t>(up)});
  return true;
}

BlockIndex Thread::block_at(const Instr* instr) const {
  if (frames.empty()) return kNone;
  const Function& function = *frames.back().function;
  const auto here = static_cast<std::size_t>(instr - function.code.data());
  return here < function.block_of.size() ? function.block_of[here] : kNone;
}

/// Gives back every register of every frame.
void Machine::Impl::unwind(Thread& thread) {
  while (!thread.frames.empty()) {
    const Frame& frame = thread.frames.back();
    for (const std::uint16_t slot : frame.function->value_slots) thread.stack[frame.base + slot].v.~Value();
    thread.frames.pop_back();
  }
  thread.native_state.reset();
}

void Machine::Impl::recycle(Thread& thread) {
  unwind(thread);
  if (thread.capacity > 4096) {
    list_bytes -= thread.capacity * sizeof(Slot);
    thread.stack.reset();
    thread.capacity = 0;
  }
  thread.serial = 0;
  thread.script = nullptr;
  thread.is_question = false;
  thread.waiters.clear();
  spare.push_back(&thread);
}

/// The copy of a script that is in the list. One that has ended keeps its place until the pass is over: a
/// restart takes that place, a hat that does not restart looks past it.
Thread* Machine::Impl::find_running(const Script& script, const Instance* instance, bool ended_too) const {
  const auto it = running.find({&script, instance});
  if (it == running.end()) return nullptr;
  for (Thread* thread : it->second) {
    if (ended_too || thread->state != ThreadState::done) return thread;
  }
  return nullptr;
}

/// Starts a script; one that runs already starts again in its place in the list, or (restart false) is left
/// alone.
Thread* Machine::Impl::start_thread(const Script& script, Instance* instance, bool restart) {
  Thread* old = find_running(script, instance, restart);
  if (old && !restart) return nullptr;
  if (!old && threads.size() >= limits.max_threads) {
    if (faults.size() < 1000) {
      const std::string& id = code->program.at(script.hat).id;
      faults.push_back(
          {id, make_fault(id, messages::too_many_scripts, {{"limit", std::to_string(limits.max_threads)}})});
    }
    return nullptr;
  }
  Thread* fresh = new_thread(function_of(script.function), instance);
  fresh->script = &script;
  running[{&script, instance}].push_back(fresh);
  disturb();
  if (old) {
    fresh->place = old->place;
    threads[old->place] = fresh;
    end_thread(*old, ThreadEnd::killed);
    release_waiters(*old);
    if (old != current) drop(*old);
  } else {
    fresh->place = threads.size();
    threads.push_back(fresh);
  }
  return fresh;
}

/// The script does no more. Its place in the list goes at the end of the pass.
void Machine::Impl::end_thread(Thread& thread, ThreadEnd why) {
  if (thread.state == ThreadState::done) return;
  thread.state = ThreadState::done;
  thread.end = why;
  someone_ended = true;
  if (!thread.dozes) no_longer_active(thread);
}

/// Tells the host and gives the thread's memory back. The thread is in no list any more.
void Machine::Impl::drop(Thread& thread) {
  if (thread.is_question) give_up(thread, messages::answer_gave_up);
  release_waiters(thread);
  if (const auto it = running.find({thread.script, thread.instance}); it != running.end()) {
    std::erase(it->second, &thread);
    if (it->second.empty()) running.erase(it);
  }
  if (thread.script) host.thread_ended(ThreadId{thread.serial}, thread.end);
  recycle(thread);
}

/// The thread is in no list any more.
void Machine::Impl::release_waiters(Thread& thread) {
  for (const auto& [waiter, serial] : thread.waiters) {
    if (waiter->serial != serial) continue;
    assert(waiter->pending > 0);
    --waiter->pending;
  }
  thread.waiters.clear();
}

/// Who waits for nobody that still does something looks up at its next turn.
void Machine::Impl::no_longer_active(Thread& thread) {
  for (const auto& [waiter, serial] : thread.waiters) {
    if (waiter->serial != serial) continue;
    assert(waiter->active > 0);
    if (--waiter->active > 0 || waiter->state != ThreadState::joining) continue;
    waiter->state = ThreadState::ready;
    disturb();
  }
}

/// Somebody has become ready: a yield is a yield again.
void Machine::Impl::disturb() {
  only_one = false;
  disturbed = true;
  turn.solo = false;
}

void Machine::Impl::stop_all() {
  std::vector<Thread*> gone;
  gone.swap(threads);
  for (Thread* thread : gone) end_thread(*thread, ThreadEnd::killed);
  for (Thread* thread : gone) {
    thread->waiters.clear();
    if (thread != current) drop(*thread);
  }
  delete_clones();
  running.clear();
  sleepers = {};
  pass_open = false;
  pass_index = 0;
  doomed = 0;
  mid_turn = false;
  hold = nullptr;
  started = false;
}

/// In a Scratch project the scripts whose turn in this pass is still to come have it, and what they start
/// then lives on; clones end at once.
void Machine::Impl::stop_all_by_block() {
  if (!code->program.from_scratch) return stop_all();
  if (doomed == 0) doomed = threads.size();
  const std::vector<Thread*> fresh(threads.begin() + static_cast<std::ptrdiff_t>(doomed), threads.end());
  threads.resize(doomed);
  for (Thread* thread : fresh) end_thread(*thread, ThreadEnd::killed);
  for (Thread* thread : fresh) drop(*thread);
  for (std::size_t i = 0; i < doomed; ++i) {
    Thread& thread = *threads[i];
    thread.waiters.clear();
    thread.pending = thread.active = 0;
    if (thread.state == ThreadState::done) continue;  // a clone's instance may have gone with it
    if (i <= pass_index || thread.instance->is_clone) {
      end_thread(thread, ThreadEnd::killed);
    } else if (thread.state == ThreadState::joining) {
      thread.state = ThreadState::ready;  // whom it waits for is in no list any more
    }
  }
  running.clear();
  delete_clones();
  hold = nullptr;
  disturb();
}

void Machine::Impl::stop_others(Thread& keep) {
  for (std::size_t i = doomed; i < threads.size(); ++i) {
    Thread& thread = *threads[i];
    if (&thread != &keep && thread.instance == keep.instance) end_thread(thread, ThreadEnd::killed);
  }
}

std::vector<Thread*> Machine::Impl::start_matching(const std::vector<const Script*>& scripts, bool restart) {
  std::vector<Thread*> out;
  for (std::size_t i = order.size(); i-- > 0;) {
    Instance* instance = order[i];
    for (const Script* script : scripts) {
      if (script->sprite != instance->sprite) continue;
      if (Thread* thread = start_thread(*script, instance, restart)) out.push_back(thread);
    }
  }
  return out;
}

std::vector<Thread*> Machine::Impl::broadcast(const std::string& name) {
  const auto it = receivers.find(message_key(name));
  if (it == receivers.end()) return {};
  return start_matching(it->second, true);
}

void Machine::Impl::join(Thread& thread, const std::vector<Thread*>& receivers_started) {
  if (thread.state == ThreadState::done) return;  // it has started itself again
  thread.state = ThreadState::joining;
  thread.pending = thread.active = receivers_started.size();
  for (Thread* other : receivers_started) {
    other->waiters.emplace_back(&thread, thread.serial);
    if (other->state == ThreadState::done) --thread.active;
  }
  if (thread.active == 0) thread.state = ThreadState::ready;  // none could start: nobody will wake it
}

/// The look of a script that waits for others. Whether it goes on; if not, it looks again in the next pass,
/// or, when all of the others have ended in this one or look no sooner themselves, in the next tick.
bool Machine::Impl::look_at_joined(Thread& thread) {
  if (thread.dozes) {
    thread.dozes = false;
    for (const auto& [waiter, serial] : thread.waiters) {
      if (waiter->serial == serial) ++waiter->active;
    }
  }
  if (thread.pending == 0) return true;
  if (thread.active > 0) {
    thread.state = ThreadState::joining;
    return false;
  }
  thread.dozes = true;
  no_longer_active(thread);
  sleep(thread, host.now(), true);
  return false;
}

void Machine::Impl::sleep(Thread& thread, Micros wake, bool next_tick) {
  if (thread.state == ThreadState::done) return;
  thread.state = ThreadState::sleeping;
  thread.wake = std::max(wake, host.now());
  thread.earliest_tick = next_tick || !ticking_back_to_back ? tick_number + 1 : tick_number;
  if (!thread.is_condition) sleepers.emplace(thread.wake, thread.serial, &thread);
  if (limits.wall) end_tick_at(thread.wake);
}

void Machine::Impl::fault(Thread& thread, BlockIndex block, const Message& message, MessageArgs args) {
  const std::string& id = block == kNone ? std::string() : code->program.at(block).id;
  if (thread.is_question) {
    give_up(thread, message, std::move(args));
  } else if (faults.size() < 1000) {
    faults.push_back({id, make_fault(id, message, std::move(args))});
  }
}

}  // namespace mirada::vm
