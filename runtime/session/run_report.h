#pragma once
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "base/message.h"
#include "session/telemetry.h"

namespace mirada::session {

enum class RunStatus { finished, time_up, stopped, faulted, invalid };
const char* to_string(RunStatus status);

/// What the robot really did; absent without a world.
struct RobotResult {
  double x_m = 0;
  double y_m = 0;
  double heading_deg = 0;
  double path_m = 0;
  int contacts = 0;
  int line_crossings = 0;
};

/// The result of one run (docs/schema/run-report.schema.json).
struct RunReport {
  RunStatus status = RunStatus::finished;
  std::vector<vm::BlockFault> faults;
  std::map<std::string, vm::MonitorValue> variables;
  std::map<std::string, std::vector<vm::MonitorValue>> lists;
  std::vector<SaidText> say;
  double simulated_s = 0;
  double wall_s = 0;
  std::uint64_t block_executions = 0;
  std::optional<RobotResult> robot;
  std::string hash;
};

/// The report of a program that could not start.
RunReport invalid_report(const Faults& faults);

nlohmann::json to_json(const RunReport& report, Lang lang);
/// A monitor's value as JSON: a number where JSON can hold it, else text ("NaN", "Infinity").
nlohmann::json to_json(const vm::MonitorValue& value);

}  // namespace mirada::session
