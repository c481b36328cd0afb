#include "vm/machine.h"

#include <algorithm>
#include <limits>

#include "vm/machine_impl.h"
#include "vm/message_name.h"

namespace mirada::vm {
namespace {

constexpr Micros kLookAgain =
    20 * kMillisecond;  // how often conditions are looked at when nothing else happens

}  // namespace

Machine::Impl::Impl(std::shared_ptr<const Code> program, const BlockCatalog& blocks, Host& its_host,
                    Limits its_limits)
    : code(std::move(program)), catalog(blocks), host(its_host), limits(its_limits) {
  set_globals(code->globals);
  for (const ListInfo& info : code->lists) {
    List& list = lists.emplace_back();
    list.bare = info.numbers;
    list.digits = info.digits;
    list.mixed = info.mixed;
    for (const GlobalInit& item : info.initial) {
      list.add(initial_value(item));
    }
  }
  lists.emplace_back();  // for blocks that name no list
  turn.machine = this;
  turn.lists = lists.data();
  turn.functions = code->functions.data();
  edge_states.assign(code->scripts.size(), EdgeState::low);
  for (const Script& script : code->scripts) {
    if (script.kind == HatKind::message) receivers[script.name].push_back(&script);
    if (script.kind == HatKind::flag) flag_scripts.push_back(&script);
  }
  make_instances();
}

Machine::Impl::~Impl() {
  for (Thread& thread : pool) unwind(thread);
  for (const std::unique_ptr<Instance>& instance : instances) forget(*instance);
  for (std::size_t i = 0; i < global_kinds.size(); ++i) {
    if (global_kinds[i] == Kind::value) globals[i].v = Value();
  }
}

/// Adds global registers behind those that are there.
void Machine::Impl::set_globals(const std::vector<GlobalInit>& inits) {
  const std::size_t before = global_kinds.size();
  auto larger = std::make_unique<Slot[]>(before + inits.size());
  if (before > 0) {
    std::memcpy(static_cast<void*>(larger.get()), static_cast<const void*>(globals.get()),
                before * sizeof(Slot));
  }
  globals = std::move(larger);
  for (const GlobalInit& init : inits) {
    global_kinds.push_back(init.kind);
    set_slot(globals[global_kinds.size() - 1], init);
  }
}

Value Machine::Impl::initial_value(const GlobalInit& init) {
  if (init.is_text) return make_text(heap, std::string_view(init.text));
  return init.is_truth ? Value(init.number != 0) : Value(init.number);
}

void Machine::Impl::set_slot(Slot& slot, const GlobalInit& init) {
  if (init.kind == Kind::number) {
    slot.n = init.number;
  } else {
    slot.v = initial_value(init);
  }
}

const NativeSite& Machine::Impl::native_site(std::int32_t index) const {
  const auto i = static_cast<std::size_t>(index);
  return i < code->natives.size() ? code->natives[i] : question_natives[i - code->natives.size()];
}

Micros Machine::Impl::next_wake() const {
  constexpr Micros kNever = std::numeric_limits<Micros>::max();
  const Micros now = host.now();
  if (hold && hold->state != ThreadState::done) {
    if (hold->state == ThreadState::polling) return std::min(hold_until, now + kLookAgain);
    if (hold->state == ThreadState::ready) return now;
    return std::min(hold_until, hold->state == ThreadState::sleeping ? hold->wake : kNever);
  }
  Micros wake = kNever;
  for (const Thread* thread : threads) {
    if (thread->state == ThreadState::ready || thread->state == ThreadState::done) return now;
    if (thread->state == ThreadState::polling) wake = now + kLookAgain;
    if (thread->state == ThreadState::sleeping) wake = std::min(wake, thread->wake);
  }
  const bool edges =
      started && std::any_of(code->scripts.begin(), code->scripts.end(),
                             [](const Script& script) { return script.kind == HatKind::edge; });
  return edges ? std::min(wake, now + kLookAgain) : wake;
}

Micros Machine::Impl::next_timer() const { return mid_turn ? host.now() + 1 : next_sleeper(); }

/// When a script that waits has slept enough, later than now; INT64_MAX: none.
Micros Machine::Impl::next_sleeper() const {
  constexpr Micros kNever = std::numeric_limits<Micros>::max();
  const Micros now = host.now();
  if (sleepers.empty()) return kNever;
  if (std::get<0>(sleepers.top()) > now) return std::get<0>(sleepers.top());
  // On top are those that only wait for the next tick.
  Micros wake = kNever;
  for (const Thread* thread : threads) {
    if (thread->state == ThreadState::sleeping && thread->wake > now) wake = std::min(wake, thread->wake);
  }
  return wake;
}

Limits live_limits(const Clock& wall) {
  Limits out;
  out.wall = &wall;
  out.executions_per_tick = out.warp_executions = 1ULL << 60;
  out.slice_executions = 5'000;
  return out;
}

Machine::Machine(std::shared_ptr<const Code> code, const BlockCatalog& catalog, Host& host, Limits limits)
    : impl_(std::make_unique<Impl>(std::move(code), catalog, host, limits)) {}

Machine::~Machine() = default;

void Machine::flag() {
  impl_->stop_all();
  impl_->started = true;
  impl_->timer_zero = impl_->host.now();
  std::fill(impl_->edge_states.begin(), impl_->edge_states.end(), EdgeState::low);
  impl_->start_matching(impl_->flag_scripts, true);
}

void Machine::stop() { impl_->stop_all(); }

void Machine::interrupt() { impl_->interrupted.store(true); }

void Machine::key(const std::string& name, bool down) {
  if (!down || !impl_->started) return;
  std::vector<const Script*> wanted;
  for (const Script& script : impl_->code->scripts) {
    if (script.kind == HatKind::key && (script.name == name || script.name == "any"))
      wanted.push_back(&script);
  }
  impl_->start_matching(wanted, false);
}

void Machine::tick(bool back_to_back) { impl_->tick(back_to_back); }

bool Machine::any_script_alive() const {
  return std::any_of(impl_->threads.begin(), impl_->threads.end(), [](const Thread* thread) {
    return thread->script != nullptr && thread->state != ThreadState::done;
  });
}

bool Machine::waits_for_outside() const {
  if (!impl_->started) return false;
  const bool alive = any_script_alive();
  return std::any_of(impl_->code->scripts.begin(), impl_->code->scripts.end(), [&](const Script& script) {
    return script.kind == HatKind::key || script.kind == HatKind::edge ||
           (script.kind == HatKind::message && alive);
  });
}

bool Machine::may_fire_by_itself() const {
  if (!impl_->started) return false;
  return std::any_of(impl_->code->scripts.begin(), impl_->code->scripts.end(), [](const Script& script) {
    return script.kind == HatKind::edge && !script.from_outside;
  });
}

bool Machine::waits_for_percept() const {
  if (!impl_->started) return false;
  return std::ranges::any_of(impl_->code->scripts, [](const Script& script) {
    return script.kind == HatKind::edge && script.from_outside;
  });
}

Micros Machine::next_wake() const { return impl_->next_wake(); }
Micros Machine::next_timer() const { return impl_->next_timer(); }
std::shared_ptr<const std::vector<std::string>> Machine::running_blocks() const {
  return impl_->running_blocks();
}
std::map<std::string, MonitorValue> Machine::variables(MonitorRoom room) const {
  return impl_->variables(room);
}
std::map<std::string, std::vector<MonitorValue>> Machine::lists(MonitorRoom room) const {
  return impl_->all_lists(room);
}

std::map<std::string, std::size_t> Machine::list_lengths() const { return impl_->list_lengths(); }
std::vector<BlockFault> Machine::take_faults() { return std::exchange(impl_->faults, {}); }
std::uint64_t Machine::block_executions() const { return impl_->executions; }
void Machine::evaluate(const std::string& block_id, std::uint64_t request) {
  impl_->evaluate(block_id, request);
}
std::vector<Machine::Answer> Machine::take_answers() { return std::exchange(impl_->answers, {}); }

}  // namespace mirada::vm
