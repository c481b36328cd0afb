#pragma once
#include <atomic>
#include <deque>
#include <memory>
#include <mutex>
#include <string>

#include "robot/robot.h"
#include "session/evaluations.h"
#include "session/program_host.h"
#include "session/station.h"
#include "session/telemetry.h"
#include "vm/machine.h"

namespace mirada::session {

struct SessionOptions {
  std::uint64_t seed = 1;
  vm::Limits limits;
  /// No world: nothing but the budget ends a tick.
  bool back_to_back = false;
  /// Somebody may press keys: a program with a key hat waits for them. In lockstep nobody is there.
  bool attended = true;
  std::uint64_t runs_before = 0;  ///< what run() counts on from
};

/// One program on one robot. Everything on the control thread, but what says otherwise.
///
/// A program that needs to see starts when the first answer has come (its clock stands still until then); it
/// is stopped in words when no picture comes. It runs until stop() while a script is alive or something
/// outside can start one.
class Session {
 public:
  Session(robot::Robot& robot, const vm::BlockCatalog& catalog, SessionOptions options);
  ~Session();

  /// Ends what runs and presses the flag. `permit` is Safety's, taken when the flag was pressed: a stop since
  /// then wins.
  void start(const vm::LoadedProgram& program, const std::string& program_json, robot::Safety::Permit permit);
  /// Ends the run that goes on, if one does. Never touches a permit given meanwhile.
  void stop(StopReason why);
  void pause(bool on);
  void key(const std::string& name, bool down);
  /// `answer` is called once, in one of the next ticks.
  void evaluate(const vm::LoadedProgram& program, const std::string& program_json, const std::string& block,
                AnswerFn answer);
  /// Panels that somebody looks at.
  void want(const Wanted& wanted);

  /// One VM tick: wake-ups, scripts, commands. Every 20 ms; live also when next_timer() is due.
  void tick();

  /// From any thread, before Safety::stop(): what it is for.
  void expect_stop(StopReason why) { expected_stop_.store(why); }
  /// From any thread: the tick that runs now ends soon.
  void interrupt();

  RunState state() const;
  StopReason stop_reason() const { return stop_reason_; }
  bool running() const { return phase_ != Phase::idle; }
  /// When, on the robot's clock, a waiting script wants a tick of its own; INT64_MAX = none does.
  Micros next_timer() const;
  bool evaluating() const { return evaluations_.any(); }
  std::uint64_t run() const { return run_; }
  const std::deque<vm::BlockFault>& faults() const { return faults_; }
  bool faulted() const { return faulted_; }
  ProgramHost& host() { return host_; }
  /// Null before the first program.
  const vm::Machine* machine() const { return machine_.get(); }
  /// All of Telemetry but the scene.
  /// Percepts too old to say anything about now are left out.
  Telemetry snapshot() const;

 private:
  std::shared_ptr<const Percepts> fresh_percepts() const;
  enum class Phase { idle, warming, running };

  void swap_machine(std::unique_ptr<vm::Machine> next);
  void update_needs();
  void begin_when_warm();
  bool still_allowed();
  void run_scripts();
  void collect();
  void add_fault(vm::BlockFault fault);
  void end_if_over();
  bool can_go_on() const;

  robot::Robot* robot_;
  const vm::BlockCatalog* catalog_;
  SessionOptions options_;
  ProgramHost host_;
  Evaluations evaluations_;
  std::mutex machine_mutex_;  // the pointer, between the control thread and interrupt()
  std::unique_ptr<vm::Machine> machine_;
  std::string program_json_;
  Wanted wanted_;
  robot::Needs program_needs_;
  robot::Needs own_needs_;
  Phase phase_ = Phase::idle;
  bool paused_ = false;
  bool faulted_ = false;
  std::uint64_t run_ = 0;
  StopReason stop_reason_ = StopReason::none;
  std::atomic<StopReason> expected_stop_{StopReason::stop_button};
  Micros last_tick_ = 0;
  Micros warm_since_ = 0;
  bool first_tick_ = true;
  robot::Safety::Permit permit_ = 0;
  std::deque<vm::BlockFault> faults_;
};

}  // namespace mirada::session
