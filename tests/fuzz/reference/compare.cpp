#include "fuzz/reference/compare.h"

#include <variant>

#include "base/clock.h"
#include "base/random.h"
#include "fuzz/reference/evaluate.h"
#include "vm/machine.h"

namespace mirada::vm::reference {
namespace {

class QuietHost final : public Host {
 public:
  Micros now() const override { return clock.now(); }
  Random& random() override { return chance; }
  void say(ThreadId, const std::string&, const std::string&) override {}
  void thread_ended(ThreadId, ThreadEnd) override {}

  ManualClock clock;
  Random chance{1, "program"};
};

std::string kind_and_text(const Value& value) {
  const char* kind = std::holds_alternative<bool>(value)          ? "truth "
                     : std::holds_alternative<std::string>(value) ? "text "
                                                                  : "number ";
  return kind + to_text(value);
}

std::string kind_and_text(const MonitorValue& value) {
  return (value.is_truth ? "truth " : value.is_number ? "number " : "text ") + value.text;
}

/// Ticks until every script has ended; false when that takes too long.
bool finish(Machine& machine, QuietHost& host) {
  machine.flag();
  for (int i = 0; i < 2'000 && machine.any_script_alive(); ++i) {
    machine.tick(true);
    const Micros wake = machine.next_wake();
    if (wake != INT64_MAX && wake > host.clock.now()) host.clock.set(wake);
  }
  return !machine.any_script_alive();
}

std::string difference_in_lists(const Machine& machine, const Outcome& want) {
  const auto lists = machine.lists(kWholeMonitors);
  for (std::size_t i = 0; i < want.lists.size(); ++i) {
    const std::string name = "L" + std::to_string(i);
    const std::vector<MonitorValue>& got = lists.at(name);
    if (got.size() != want.lists[i].size()) {
      return name + " has " + std::to_string(got.size()) + " items, not " +
             std::to_string(want.lists[i].size());
    }
    for (std::size_t k = 0; k < got.size(); ++k) {
      const std::string mine = kind_and_text(got[k]);
      const std::string theirs = kind_and_text(want.lists[i][k]);
      if (mine != theirs) return name + " item " + std::to_string(k + 1) + " is " + mine + ", not " + theirs;
    }
  }
  return {};
}

}  // namespace

std::string difference(const std::uint8_t* data, std::size_t size, const BlockCatalog& catalog) {
  const Tree tree = grow(data, size);
  const std::optional<Outcome> want = evaluate(tree);
  if (!want) return {};
  const std::string text = to_json(tree).dump();
  const Result<LoadedProgram> loaded = load_program(text, catalog);
  if (!loaded) return to_text(loaded.faults(), Lang::en) + text;
  QuietHost host;
  Limits limits;
  // Ticks end within scripts, which must change nothing; but who waits for others counts ticks.
  limits.executions_per_tick = text.find("event_broadcastandwait") == std::string::npos ? 200 : 1ULL << 60;
  Machine machine(loaded->code, catalog, host, limits);
  if (!finish(machine, host)) return "does not end: " + text;
  if (const auto faults = machine.take_faults(); !faults.empty()) {
    return faults[0].fault.text(Lang::en) + text;
  }
  const auto variables = machine.variables(kWholeMonitors);
  for (std::size_t i = 0; i < want->variables.size(); ++i) {
    const std::string name = "v" + std::to_string(i);
    const std::string mine = kind_and_text(variables.at(name));
    const std::string theirs = kind_and_text(want->variables[i]);
    if (mine != theirs) return name + " is " + mine + ", not " + theirs + ": " + text;
  }
  const std::string lists = difference_in_lists(machine, *want);
  return lists.empty() ? lists : lists + ": " + text;
}

}  // namespace mirada::vm::reference
