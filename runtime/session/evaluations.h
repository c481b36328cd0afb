#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "robot/robot.h"
#include "vm/machine.h"

namespace mirada::session {

using AnswerFn = std::function<void(Result<vm::MonitorValue>)>;

/// Reporters that somebody clicked, each answered exactly once: by the running machine when it runs the same
/// program, else by a machine of its own, silent and without permission to drive. Control thread.
class Evaluations {
 public:
  Evaluations(robot::Robot& robot, const vm::BlockCatalog& catalog, std::uint64_t seed,
              const vm::Limits& limits);
  ~Evaluations();

  /// In a machine of its own, once what the block needs has been seen.
  void ask(const vm::LoadedProgram& program, const std::string& block, const robot::Needs& needs,
           AnswerFn answer);
  /// In a machine that somebody else ticks; its answers come by answered().
  void ask(vm::Machine& running, const std::string& block, AnswerFn answer);
  void answered(const std::vector<vm::Machine::Answer>& answers);

  /// One turn of all that is open.
  void tick();
  /// Answers all that is open with a fault.
  void give_up(const Message& why);
  bool any() const { return !open_.empty(); }
  /// What the open ones need to see.
  robot::Needs needs() const;

 private:
  class QuietHost;
  struct Open;

  void close(std::vector<std::unique_ptr<Open>>::iterator open, Result<vm::MonitorValue> with);

  robot::Robot* robot_;
  const vm::BlockCatalog* catalog_;
  std::uint64_t seed_;
  vm::Limits limits_;
  std::uint64_t next_request_ = 1;
  std::vector<std::unique_ptr<Open>> open_;
};

}  // namespace mirada::session
