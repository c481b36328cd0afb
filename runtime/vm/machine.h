#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/clock.h"
#include "base/result.h"
#include "vm/catalog.h"
#include "vm/host.h"

namespace mirada::vm {

struct Code;  // the compiled program; vm/code.h

/// A program that passed validation.
struct LoadedProgram {
  std::shared_ptr<const Code> code;
  Faults warnings;              ///< loose stacks with unknown blocks, values out of a block's range, ...
  std::set<std::string> needs;  ///< of all blocks that can run
};

/// Text (the editor's envelope, or a bare workspace) -> read -> validate (all faults, each with its block id
/// as place)
/// -> compile. The catalog must outlive the code.
Result<LoadedProgram> load_program(std::string_view json_text, const BlockCatalog& catalog);

struct Limits {
  std::uint64_t executions_per_tick = 20'000;  ///< DESIGN section 4
  std::uint64_t warp_executions = 500'000;     ///< lockstep stand-in for 500 ms
  std::uint64_t slice_executions = 100'000;    ///< how often the machine looks up: interrupt flag, wall clock
  const Clock* wall = nullptr;                 ///< live: also ends a tick after `tick_time` of it
  Micros tick_time = 5 * kMillisecond;
  std::size_t max_text_bytes = 2u << 20;  ///< of a joined text: reading or comparing one must not take 5 ms
  std::size_t max_total_bytes = 128u << 20;
  std::size_t max_depth = 100'000;
  std::size_t max_threads = 20'000;
};

/// For a robot that runs live: no tick longer than 5 ms, whatever its scripts do.
Limits live_limits(const Clock& wall);

/// What a monitor shows. Values are Scratch's text of the value; `is_number` tells JSON writers to keep
/// numbers.
struct MonitorValue {
  std::string text{};
  bool is_number = false;
  double number = 0;
  bool is_truth = false;
};

struct MonitorRoom {
  std::size_t items = 1'000;    ///< of a list
  std::size_t letters = 1'000;  ///< of a text, in UTF-16 units
};
constexpr MonitorRoom kWholeMonitors{200'000, SIZE_MAX};

struct BlockFault {
  std::string block;
  Fault fault;
};

/// Runs one program's scripts, cooperatively. All calls on one thread, but interrupt() from any.
class Machine {
 public:
  Machine(std::shared_ptr<const Code> code, const BlockCatalog& catalog, Host& host, Limits limits = {});
  ~Machine();
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  /// The green flag: stops all, resets the timer, starts the flag scripts (they run in the next tick).
  void flag();
  /// Kills every script. Variables stay.
  void stop();
  /// From any thread: the running tick returns within one slice, as if its budget were spent.
  void interrupt();
  /// A key went down (browser names: "space", "up arrow", "a"); starts its hats. `down` false: released.
  void key(const std::string& name, bool down);

  /// One tick: wake-ups, edge hats, then scripts until each waits, has done something visible, or the budget
  /// (block executions, or live its wall time) is spent. With `back_to_back` (no world) nothing ends the tick
  /// but the budget.
  void tick(bool back_to_back = false);

  bool any_script_alive() const;
  /// A hat waits that only the outside can fire (key, percept), or a message hat while a script lives.
  bool waits_for_outside() const;
  /// A hat that needs nobody outside may still fire (the timer passes a value).
  bool may_fire_by_itself() const;
  /// A hat waits for something that the robot may perceive.
  bool waits_for_percept() const;
  /// When the next tick has something to do: now() or before = at once; INT64_MAX = nothing until an event.
  Micros next_wake() const;
  /// When a tick of its own is worth it: a sleeping script has slept enough, or the last tick has cut a turn
  /// short. Later than now() always, INT64_MAX = the next beat will do.
  Micros next_timer() const;

  /// Ids of the blocks being executed, the innermost of each live script, with the C-blocks around them.
  /// Never null; the same list as long as nothing changes.
  std::shared_ptr<const std::vector<std::string>> running_blocks() const;
  /// By name; script-local ones are left out. Of each list and text no more than what a monitor has room for,
  /// or all of it.
  std::map<std::string, MonitorValue> variables(MonitorRoom room = {}) const;
  std::map<std::string, std::vector<MonitorValue>> lists(MonitorRoom room = {}) const;
  /// How many items each really has.
  std::map<std::string, std::size_t> list_lengths() const;
  /// Faults since the last call.
  std::vector<BlockFault> take_faults();
  std::uint64_t block_executions() const;

  /// Evaluates one reporter of the program (the child clicked it) in a script of its own. The answer is there
  /// after one of the next ticks: take_answers() gives it once.
  void evaluate(const std::string& block_id, std::uint64_t request);
  struct Answer {
    std::uint64_t request = 0;
    bool ok = false;
    MonitorValue value;
    Fault fault;  ///< when not ok
  };
  std::vector<Answer> take_answers();

  struct Impl;

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace mirada::vm
