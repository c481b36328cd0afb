#pragma once
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/clock.h"
#include "base/random.h"
#include "vm/machine.h"

namespace mirada::vm::test {

/// Notes what a program says and which scripts end, on a clock that the test moves.
class NotingHost final : public Host {
 public:
  Micros now() const override { return clock.now(); }
  Random& random() override { return chance; }
  void say(ThreadId, const std::string&, const std::string& text) override { said.push_back(text); }
  void thread_ended(ThreadId, ThreadEnd why) override { ended.push_back(why); }

  ManualClock clock;
  Random chance{1, "program"};
  std::vector<std::string> said;
  std::vector<ThreadEnd> ended;
};

/// The packs whose blocks are all the compiler's own.
const BlockCatalog& core_catalog();

// Blocks in the editor's JSON, made short. Ids are given by `numbered`.
using Json = nlohmann::json;
Json block(const std::string& type, Json inputs = Json::object(), Json fields = Json::object());
Json text(const std::string& value);   ///< a text shadow as an input
Json number(double value);             ///< a number shadow as an input
Json in(Json inner);                   ///< a block in a socket or mouth
Json var(const std::string& name);     ///< the reporter of a variable
Json named(const std::string& name);   ///< the field of a variable, list or message
Json stack(std::vector<Json> blocks);  ///< a chain
Json hat(std::vector<Json> blocks);    ///< when flag pressed
Json program(std::vector<Json> tops, const std::vector<std::string>& variables,
             const std::vector<std::string>& lists = {}, const std::vector<std::string>& messages = {});

/// A program that is running.
struct Running {
  explicit Running(const Json& json, Limits limits = {}, const BlockCatalog& catalog = core_catalog())
      : Running(std::string_view(json.dump()), limits, catalog) {}
  explicit Running(std::string_view text, Limits limits = {}, const BlockCatalog& catalog = core_catalog());
  /// Ticks until nothing lives any more or `seconds` of program time are over. Back to back a program that
  /// never waits takes no time: false when it still runs after kMostTicks.
  bool finish(double seconds = 60, bool back_to_back = true);
  static constexpr int kMostTicks = 20'000;
  double value(const std::string& variable) const { return machine->variables().at(variable).number; }
  std::string list(const std::string& name) const;  ///< joined by spaces

  NotingHost host;
  LoadedProgram loaded;
  std::unique_ptr<Machine> machine;
};

}  // namespace mirada::vm::test
