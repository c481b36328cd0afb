#pragma once
#include <deque>
#include <functional>
#include <string>

#include "robot/motion.h"
#include "session/telemetry.h"
#include "vm/host.h"

namespace mirada::session {

/// What the running program gets from its session: its clock, its chance, its voice; and the end of a script
/// ends the motion that the script started. Control thread.
class ProgramHost final : public vm::Host {
 public:
  ProgramHost(robot::Motion& motion, std::uint64_t seed);

  /// A new run: clock at zero, the same chance again, silence.
  void begin_run();
  void advance(Micros dt) { now_ += dt; }
  void clear_bubble() { bubble_.clear(); }
  /// Called for each thing said that is not empty.
  void on_say(std::function<void(const SaidText&)> listener) { listener_ = std::move(listener); }

  const std::string& bubble() const { return bubble_; }
  const std::deque<SaidText>& said() const { return said_; }

  Micros now() const override { return now_; }
  Random& random() override { return random_; }
  void say(vm::ThreadId thread, const std::string& block, const std::string& text) override;
  void thread_ended(vm::ThreadId thread, vm::ThreadEnd why) override;

 private:
  robot::Motion* motion_;
  std::uint64_t seed_;
  Random random_;
  Micros now_ = 0;
  std::string bubble_;
  vm::ThreadId speaker_;
  std::deque<SaidText> said_;
  std::function<void(const SaidText&)> listener_;
};

}  // namespace mirada::session
