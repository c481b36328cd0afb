#include "robot/motion_history.h"

#include <gtest/gtest.h>

namespace mirada::robot {
namespace {

TEST(MotionHistory, IsZeroWhileEmpty) { EXPECT_EQ(MotionHistory().at(5).X_OR.x_m, 0); }

TEST(MotionHistory, InterpolatesBetweenTwoRecords) {
  MotionHistory history;
  history.record(0, {{1, 2, 0.2}, {0.4, 0}});
  history.record(10'000, {{2, 4, 0.4}, {0.8, 0}});
  const auto middle = history.at(2'500);
  EXPECT_DOUBLE_EQ(middle.X_OR.x_m, 1.25);
  EXPECT_DOUBLE_EQ(middle.X_OR.y_m, 2.5);
  EXPECT_DOUBLE_EQ(middle.X_OR.heading_rad, 0.25);
  EXPECT_DOUBLE_EQ(middle.neck.pan_rad, 0.5);
}

TEST(MotionHistory, TurnsTheShortWayAcrossTheBack) {
  MotionHistory history;
  history.record(0, {{0, 0, rad(170)}, {}});
  history.record(10'000, {{0, 0, rad(-170)}, {}});
  EXPECT_NEAR(std::abs(deg(history.at(5'000).X_OR.heading_rad)), 180, 1e-9);
}

TEST(MotionHistory, GivesTheNearestEndOutside) {
  MotionHistory history;
  history.record(1'000, {{1, 0, 0}, {}});
  history.record(2'000, {{2, 0, 0}, {}});
  EXPECT_EQ(history.at(0).X_OR.x_m, 1);
  EXPECT_EQ(history.at(9'000).X_OR.x_m, 2);
}

TEST(MotionHistory, ForgetsWhatIsOld) {
  MotionHistory history;
  for (Micros t = 0; t <= 10 * kSecond; t += 10'000) history.record(t, {{seconds(t), 0, 0}, {}});
  EXPECT_GT(history.at(0).X_OR.x_m, 7.9);
  EXPECT_NEAR(history.at(9 * kSecond).X_OR.x_m, 9, 1e-9);
}

}  // namespace
}  // namespace mirada::robot
