#include "session/evaluations.h"

#include <algorithm>

#include "session/messages.h"
#include "session/needs.h"

namespace mirada::session {
namespace {
constexpr Micros kPatience = 2 * kSecond;
}

/// A voice that nobody hears, and no motion.
class Evaluations::QuietHost final : public vm::Host {
 public:
  QuietHost(const robot::Robot& robot, std::uint64_t seed)
      : robot_(&robot), start_(robot.now()), random_(seed, "evaluate") {}
  Micros now() const override { return robot_->now() - start_; }
  Random& random() override { return random_; }
  void say(vm::ThreadId, const std::string&, const std::string&) override {}
  void thread_ended(vm::ThreadId, vm::ThreadEnd) override {}

 private:
  const robot::Robot* robot_;
  Micros start_;
  Random random_;
};

struct Evaluations::Open {
  std::uint64_t request = 0;
  std::string block;
  AnswerFn answer;
  Micros deadline = 0;
  robot::Needs needs;
  std::unique_ptr<QuietHost> host;
  std::unique_ptr<vm::Machine> machine;  // null: somebody else's
  bool asked = false;
};

Evaluations::Evaluations(robot::Robot& robot, const vm::BlockCatalog& catalog, std::uint64_t seed,
                         const vm::Limits& limits)
    : robot_(&robot), catalog_(&catalog), seed_(seed), limits_(limits) {}

Evaluations::~Evaluations() { give_up(messages::robot_changed); }

void Evaluations::ask(const vm::LoadedProgram& program, const std::string& block, const robot::Needs& needs,
                      AnswerFn answer) {
  auto open = std::make_unique<Open>();
  open->request = next_request_++;
  open->block = block;
  open->answer = std::move(answer);
  open->deadline = robot_->now() + kPatience;
  open->needs = needs;
  open->host = std::make_unique<QuietHost>(*robot_, seed_);
  open->machine = std::make_unique<vm::Machine>(program.code, *catalog_, *open->host, limits_);
  open_.push_back(std::move(open));
}

void Evaluations::ask(vm::Machine& running, const std::string& block, AnswerFn answer) {
  auto open = std::make_unique<Open>();
  open->request = next_request_++;
  open->answer = std::move(answer);
  open->deadline = robot_->now() + kPatience;
  running.evaluate(block, open->request);
  open_.push_back(std::move(open));
}

void Evaluations::close(std::vector<std::unique_ptr<Open>>::iterator open, Result<vm::MonitorValue> with) {
  const AnswerFn answer = std::move((*open)->answer);
  open_.erase(open);
  if (answer) answer(std::move(with));
}

void Evaluations::answered(const std::vector<vm::Machine::Answer>& answers) {
  for (const vm::Machine::Answer& answer : answers) {
    const auto open = std::find_if(open_.begin(), open_.end(),
                                   [&](const auto& one) { return one->request == answer.request; });
    if (open == open_.end()) continue;
    close(open, answer.ok ? Result<vm::MonitorValue>(answer.value) : Result<vm::MonitorValue>(answer.fault));
  }
}

void Evaluations::tick() {
  std::vector<vm::Machine::Answer> answers;
  for (const auto& open : open_) {
    if (!open->machine) continue;
    if (!open->asked && seen_enough(*robot_, open->needs)) {
      open->machine->evaluate(open->block, open->request);
      open->asked = true;
    }
    if (!open->asked) continue;
    open->machine->tick();
    for (vm::Machine::Answer& answer : open->machine->take_answers()) answers.push_back(std::move(answer));
  }
  answered(answers);
  for (auto open = open_.begin(); open != open_.end();) {
    if ((*open)->deadline > robot_->now()) {
      ++open;
      continue;
    }
    const auto index = open - open_.begin();
    close(open, make_fault((*open)->block, messages::no_answer_in_time));
    open = open_.begin() + index;
  }
}

void Evaluations::give_up(const Message& why) {
  while (!open_.empty()) close(open_.begin(), make_fault("", why));
}

robot::Needs Evaluations::needs() const {
  robot::Needs all;
  for (const auto& open : open_) all = all | open->needs;
  return all;
}

}  // namespace mirada::session
