#include "session/run_report.h"

#include <cmath>

#include <nlohmann/json.hpp>

namespace mirada::session {
namespace {

using nlohmann::json;

constexpr double kExactInteger = 9007199254740992.0;

json number_json(double value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value > 0 ? "Infinity" : "-Infinity";
  const bool negative_zero = value == 0 && std::signbit(value);
  const bool whole = std::trunc(value) == value && std::abs(value) <= kExactInteger && !negative_zero;
  return whole ? json(static_cast<std::int64_t>(value)) : json(value);
}

json fault_json(const vm::BlockFault& fault, Lang lang) {
  return {{"block", fault.block},
          {"code", fault.fault.code()},
          {"severity", fault.fault.severity == Severity::error ? "error" : "warning"},
          {"message", fault.fault.text(lang)}};
}

json robot_json(const RobotResult& robot) {
  return {{"x_m", number_json(robot.x_m)},
          {"y_m", number_json(robot.y_m)},
          {"heading_deg", number_json(robot.heading_deg)},
          {"path_m", number_json(robot.path_m)},
          {"contacts", robot.contacts},
          {"line_crossings", robot.line_crossings}};
}

json values_json(const std::vector<vm::MonitorValue>& values) {
  json out = json::array();
  for (const vm::MonitorValue& value : values) out.push_back(to_json(value));
  return out;
}

}  // namespace

const char* to_string(RunStatus status) {
  switch (status) {
    case RunStatus::finished:
      return "finished";
    case RunStatus::time_up:
      return "time_up";
    case RunStatus::stopped:
      return "stopped";
    case RunStatus::faulted:
      return "faulted";
    case RunStatus::invalid:
      return "invalid";
  }
  return "";
}

RunReport invalid_report(const Faults& faults) {
  RunReport report;
  report.status = RunStatus::invalid;
  for (const Fault& fault : faults) report.faults.push_back({fault.place, fault});
  return report;
}

json to_json(const vm::MonitorValue& value) {
  if (value.is_truth) return value.text == "true";
  return value.is_number ? number_json(value.number) : json(value.text);
}

json to_json(const RunReport& report, Lang lang) {
  json out = {{"version", 1},
              {"status", to_string(report.status)},
              {"faults", json::array()},
              {"variables", json::object()},
              {"lists", json::object()},
              {"say", json::array()},
              {"simulated_s", report.simulated_s},
              {"wall_s", report.wall_s},
              {"block_executions", report.block_executions},
              {"robot", report.robot ? robot_json(*report.robot) : json()},
              {"hash", report.hash}};
  for (const vm::BlockFault& fault : report.faults) out["faults"].push_back(fault_json(fault, lang));
  for (const auto& [name, value] : report.variables) out["variables"][name] = to_json(value);
  for (const auto& [name, values] : report.lists) out["lists"][name] = values_json(values);
  for (const SaidText& line : report.say) {
    out["say"].push_back({{"t_s", number_json(seconds(line.t))}, {"text", line.text}});
  }
  return out;
}

}  // namespace mirada::session
