#include "session/run_report.h"

#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "session/messages.h"

namespace mirada::session {
namespace {

vm::MonitorValue number(double value) { return {number_text(value), true, value, false}; }

TEST(RunReport, NumbersThatJsonCannotHoldAreWords) {
  EXPECT_EQ(to_json(number(std::numeric_limits<double>::quiet_NaN())), "NaN");
  EXPECT_EQ(to_json(number(std::numeric_limits<double>::infinity())), "Infinity");
  EXPECT_EQ(to_json(number(-std::numeric_limits<double>::infinity())), "-Infinity");
}

TEST(RunReport, WholeNumbersAreWholeAndOthersAreNot) {
  EXPECT_EQ(to_json(number(3)).dump(), "3");
  EXPECT_EQ(to_json(number(0.1)).dump(), "0.1");
  EXPECT_EQ(to_json(number(1e21)).get<double>(), 1e21);
}

TEST(RunReport, TextStaysTextAndTruthIsTruth) {
  EXPECT_EQ(to_json(vm::MonitorValue{"5", false, 0, false}), "5");
  EXPECT_EQ(to_json(vm::MonitorValue{"true", false, 0, true}), true);
}

TEST(RunReport, HasEveryFieldOfTheFormat) {
  RunReport report;
  report.status = RunStatus::time_up;
  report.robot = RobotResult{1, 2, 90, 3.5, 1, 2};
  report.variables["n"] = number(2);
  report.lists["l"] = {number(1), {"a", false, 0, false}};
  report.say = {{1'500'000, "hi"}};
  report.faults = {{"b1", make_fault("b1", messages::program_ended_moving, {}, Severity::warning)}};
  const nlohmann::json json = to_json(report, Lang::en);
  for (const char* field : {"version", "status", "faults", "variables", "lists", "say", "simulated_s",
                            "wall_s", "block_executions", "robot", "hash"}) {
    EXPECT_TRUE(json.contains(field)) << field;
  }
  EXPECT_EQ(json.size(), 11u);
  EXPECT_EQ(json["status"], "time_up");
  EXPECT_EQ(json["say"][0]["t_s"], 1.5);
  EXPECT_EQ(json["lists"]["l"], nlohmann::json::parse(R"([1, "a"])"));
  EXPECT_EQ(json["robot"]["contacts"], 1);
  EXPECT_EQ(json["faults"][0]["block"], "b1");
  EXPECT_EQ(json["faults"][0]["code"], "program_ended_moving");
  EXPECT_EQ(json["faults"][0]["severity"], "warning");
}

TEST(RunReport, AnInvalidOneListsEveryFault) {
  const RunReport report =
      invalid_report({make_fault("a", messages::no_picture), make_fault("b", messages::robot_stuck)});
  const nlohmann::json json = to_json(report, Lang::es);
  EXPECT_EQ(json["status"], "invalid");
  EXPECT_EQ(json["faults"].size(), 2u);
  EXPECT_EQ(json["faults"][1]["message"], std::string(messages::robot_stuck.es));
}

}  // namespace
}  // namespace mirada::session
