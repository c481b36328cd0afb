#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include <gtest/gtest.h>

#include "base/files.h"
#include "rig/lockstep.h"

namespace mirada::scenarios {
namespace {

// A program that roams and says every half second where it believes to be.
constexpr const char* kRoamAndTell =
    R"({"format": "mirada-program", "version": 1, "name": "where", "packs": ["events", "control", "motion", "operators", "say"],
 "workspace": {"blocks": {"blocks": [
  {"type": "event_whenflagclicked", "id": "a", "next": {"block": {"type": "motion_drive_and_avoid", "id": "b"}}},
  {"type": "event_whenflagclicked", "id": "c", "next": {"block": {"type": "control_forever", "id": "d", "inputs": {"SUBSTACK": {"block":
   {"type": "looks_say", "id": "e", "inputs": {"MESSAGE": {"block": {"type": "operator_join", "id": "f", "inputs": {
     "STRING1": {"block": {"type": "motion_my_place", "id": "g", "fields": {"WHAT": "x"}}},
     "STRING2": {"block": {"type": "operator_join", "id": "h", "inputs": {
       "STRING1": {"shadow": {"type": "text", "id": "t1", "fields": {"TEXT": " "}}},
       "STRING2": {"block": {"type": "operator_join", "id": "i", "inputs": {
         "STRING1": {"block": {"type": "motion_my_place", "id": "j", "fields": {"WHAT": "y"}}},
         "STRING2": {"block": {"type": "operator_join", "id": "k", "inputs": {
           "STRING1": {"shadow": {"type": "text", "id": "t2", "fields": {"TEXT": " "}}},
           "STRING2": {"block": {"type": "motion_know_place", "id": "l"}}}}}}}}}}}}}}},
    "next": {"block": {"type": "control_wait", "id": "m", "inputs": {"DURATION": {"shadow": {"type": "math_positive_number", "id": "t3", "fields": {"NUM": 0.5}}}}}}}}}}}}
 ]}}})";

struct Told {
  Micros t;
  double x_m, y_m;
  bool known;
};

std::vector<Told> told(const session::RunReport& report) {
  std::vector<Told> out;
  for (const auto& line : report.say) {
    double x = 0, y = 0;
    char word[16] = {};
    if (std::sscanf(line.text.c_str(), "%lf %lf %15s", &x, &y, word) == 3)
      out.push_back({line.t, x / 100, y / 100, std::string(word) == "true"});
  }
  return out;
}

class WhereAmI : public ::testing::Test {
 protected:
  void SetUp() override {
    auto room = world::world_by_name("green-field");
    auto robot = robot_by_name("mirada-sim");
    auto place = place_by_name("green-field");
    ASSERT_TRUE(room.ok() && robot.ok() && place.ok());
    options_.world = std::move(*room);
    options_.robot = std::move(*robot);
    options_.robot.place = std::move(*place);
    options_.world->noise.wheel_scale = 0.01;  // bad wheels: without tags it would go astray
    options_.seed = 3;
    options_.watch = [this](Micros t, const world::Truth& truth) {
      truth_[t / (100 * kMillisecond)] = truth.X_WR;
    };
  }
  double off_m(const Told& told) const {
    const Pose2& at = truth_.at(told.t / (100 * kMillisecond));
    return std::hypot(told.x_m - at.x_m, told.y_m - at.y_m);
  }

  rig::LockstepOptions options_;
  std::map<Micros, Pose2> truth_;
};

TEST_F(WhereAmI, TagsKeepARovingRobotWithinADecimetreOrTwo) {
  options_.seconds = 30;
  const auto lines = told(rig::run_lockstep(kRoamAndTell, options_));
  ASSERT_GT(lines.size(), 40u);
  int known = 0;
  for (const Told& line : lines) {
    if (!line.known) continue;
    ++known;
    EXPECT_LT(off_m(line), 0.35) << "at " << seconds(line.t) << " s";
  }
  EXPECT_GT(known, 0.9 * static_cast<double>(lines.size()));
}

TEST_F(WhereAmI, ARobotThatIsCarriedAwaySaysSoAndFindsItselfAgain) {
  options_.seconds = 40;
  options_.carry = [](Micros now) -> std::optional<Pose2> {
    if (now == 10 * kSecond) return Pose2{1.6, 0.2, rad(180)};
    return std::nullopt;
  };
  const auto lines = told(rig::run_lockstep(kRoamAndTell, options_));
  ASSERT_GT(lines.size(), 60u);
  const auto lost = std::find_if(lines.begin(), lines.end(),
                                 [](const Told& line) { return line.t > 10 * kSecond && !line.known; });
  ASSERT_NE(lost, lines.end());
  EXPECT_LT(lost->t, 20 * kSecond);
  ASSERT_TRUE(lines.back().known);
  EXPECT_LT(off_m(lines.back()), 0.35);
}

}  // namespace
}  // namespace mirada::scenarios
