#pragma once
#include <atomic>
#include <deque>
#include <map>
#include <queue>
#include <unordered_map>

#include "vm/compiler.h"
#include "vm/machine.h"
#include "vm/thread.h"

namespace mirada::vm {

/// Why a script's turn is over.
enum class Exit : std::uint8_t { yielded, polled, slept, joined, preempted, ended, faulted };

/// What the instruction handlers need while a script has its turn.
struct Turn {
  std::int64_t fuel =
      0;  ///< block executions left before the scheduler looks up; dear instructions cost extra
  std::int64_t surcharge = 0;  ///< what of the spent fuel were no block executions
  Slot* frame = nullptr;
  std::int32_t warp = 0;
  bool solo = false;  ///< nobody else wants a turn: a yield may go straight on
  Exit exit = Exit::yielded;
  Thread* thread = nullptr;
  Machine::Impl* machine = nullptr;
  List* lists = nullptr;
  const Function* functions = nullptr;
  Slot returned;  ///< what a call gave, as a bare number
  Value returned_value;
};

/// What an edge hat's condition was last; broken: it has faulted and is left alone.
enum class EdgeState : std::uint8_t { low, high, broken };

/// Runs the script of `turn` until its turn is over. vm/interpreter.cpp.
void run_turn(Turn& turn, const Instr* at, Slot* globals);

struct Machine::Impl {
  Impl(std::shared_ptr<const Code> program, const BlockCatalog& blocks, Host& its_host, Limits its_limits);
  ~Impl();
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  // scheduler.cpp
  void tick(bool back_to_back);
  bool held();
  bool out_of_time();
  void end_tick_at(Micros wake);
  bool may_run(const Thread& thread) const;
  bool run_pass();
  void close_pass();
  void clear_ended();
  bool next_pass_is_due();
  void wake_sleepers();
  void look_at_edges();
  EdgeState condition_of(const Script& script, Instance& instance);

  // turns.cpp
  bool is_quick(const Thread& thread) const;
  Thread* quick_turns();
  Exit finish_quick_turn(Thread& thread);
  bool take_turn(Thread& thread);
  bool close_turn(Thread& thread, Exit exit);
  bool keeps_others_out(Thread& thread, Exit exit);
  std::int64_t fuel_for(const Thread& thread) const;
  bool turn_is_over(const Thread& thread);
  Exit run_thread(Thread& thread);
  void settle(std::int64_t fuel, std::int64_t turns);

  // threads.cpp
  Thread* new_thread(const Function& function, Instance* instance);
  bool push_frame(Thread& thread, const Function& function, const Instr* back, std::int32_t depth,
                  std::uint32_t base, std::int32_t warp, BlockIndex caller);
  void unwind(Thread& thread);
  void recycle(Thread& thread);
  Thread* find_running(const Script& script, const Instance* instance, bool ended_too) const;
  Thread* start_thread(const Script& script, Instance* instance, bool restart);
  std::vector<Thread*> start_matching(const std::vector<const Script*>& scripts, bool restart);
  void end_thread(Thread& thread, ThreadEnd why);
  void drop(Thread& thread);
  void release_waiters(Thread& thread);
  void no_longer_active(Thread& thread);
  void disturb();
  void stop_all();
  void stop_all_by_block();
  void stop_others(Thread& keep);
  std::vector<Thread*> broadcast(const std::string& name);
  void join(Thread& thread, const std::vector<Thread*>& started);
  bool look_at_joined(Thread& thread);
  void sleep(Thread& thread, Micros wake, bool next_tick);
  void fault(Thread& thread, BlockIndex block, const Message& message, MessageArgs args = {});

  // instances.cpp
  void make_instances();
  Instance* make_instance(std::int32_t sprite, const Instance* original);
  void clone(Thread& thread, const Value& name);
  void move_by_layers(Instance& instance, double layers);
  void delete_clone(Thread& thread);
  void delete_clones();
  void forget(Instance& gone);

  // monitors.cpp
  void evaluate(const std::string& block_id, std::uint64_t request);
  const Function* question(const std::string& block_id);
  void refuse(std::uint64_t request, Fault why);
  void answer(Thread& thread, const Value& value);
  void give_up(Thread& thread, const Message& why, MessageArgs args = {});
  std::map<std::string, MonitorValue> variables(MonitorRoom room) const;
  std::map<std::string, std::vector<MonitorValue>> all_lists(MonitorRoom room) const;
  std::map<std::string, std::size_t> list_lengths() const;
  std::shared_ptr<const std::vector<std::string>> running_blocks() const;

  // machine.cpp
  const NativeSite& native_site(std::int32_t index) const;
  const Function& function_of(std::int32_t index) const {
    return code->functions[static_cast<std::size_t>(index)];
  }
  void set_globals(const std::vector<GlobalInit>& inits);
  Value initial_value(const GlobalInit& init);
  void set_slot(Slot& slot, const GlobalInit& init);
  Micros next_wake() const;
  Micros next_timer() const;
  Micros next_sleeper() const;
  bool out_of_memory() const { return heap.used + list_bytes > limits.max_total_bytes; }

  std::shared_ptr<const Code> code;
  const BlockCatalog& catalog;
  Host& host;
  Limits limits;
  Heap heap;
  std::size_t list_bytes = 0;
  std::unique_ptr<Slot[]> globals;
  std::vector<Kind> global_kinds;
  std::deque<List> list_store;
  std::vector<List> lists;
  std::vector<std::unique_ptr<Instance>> instances;  ///< originals first, by sprite; then clones
  std::vector<Instance*> order;                      ///< the last starts first
  std::vector<std::int32_t> spare_lists;

  std::deque<Thread> pool;  ///< never shrinks, so that pointers stay good
  std::vector<Thread*> spare;
  std::vector<Thread*> threads;  ///< in the order of their turns
  /// The copies of a script that are in the list, by whose script it is.
  std::map<std::pair<const Script*, const Instance*>, std::vector<Thread*>> running;
  using Sleeper = std::tuple<Micros, std::uint64_t, Thread*>;
  std::priority_queue<Sleeper, std::vector<Sleeper>, std::greater<>> sleepers;
  std::unordered_map<std::string, std::vector<const Script*>> receivers;
  std::vector<const Script*> flag_scripts;
  std::vector<EdgeState> edge_states;  ///< by script
  std::vector<NativeSite> question_natives;
  std::unordered_map<std::string, std::unique_ptr<Function>> questions;
  std::vector<Thread*> ended;

  mutable std::vector<bool> running_seen;  ///< by block: what running_ids holds
  mutable std::shared_ptr<const std::vector<std::string>> running_ids;

  Turn turn;
  std::uint64_t next_serial = 1;
  std::uint64_t tick_number = 0;
  std::uint64_t pass_number = 0;
  std::size_t pass_index = 0;  ///< the thread whose turn it is; kept when a tick ends within a pass
  bool pass_open = false;
  std::size_t doomed = 0;   ///< threads before this place go when the pass is over (Scratch's "stop all")
  bool redraw = false;      ///< a Scratch project has shown something or begun to wait
  bool pass_moved = false;  ///< somebody did more in this pass than look at a condition
  std::size_t pass_turns = 0;
  bool only_one = false;       ///< the last pass had one turn and nobody else became ready
  bool someone_ended = false;  ///< since the list was last cleared of those
  bool disturbed = false;
  std::size_t pass_alone_size = 0;
  Thread* current = nullptr;  ///< whose turn it is
  bool mid_turn = false;      ///< the thread at pass_index was interrupted within its turn
  bool ticking_back_to_back = false;
  std::int64_t budget = 0;
  Micros tick_start = 0;  ///< on the wall clock, when there is one
  Micros tick_end = 0;
  std::int64_t unwatched = 0;  ///< fuel spent since the wall clock was read
  std::uint64_t executions = 0;
  Thread* hold = nullptr;  ///< waits within "all at once": nobody else runs
  Micros hold_until = 0;
  bool started = false;  ///< the flag was pressed and nothing has stopped all since
  Micros timer_zero = 0;
  double counter = 0;  ///< Scratch's hidden counter
  std::atomic<bool> interrupted{false};
  std::vector<BlockFault> faults;
  std::vector<Answer> answers;
};

}  // namespace mirada::vm
