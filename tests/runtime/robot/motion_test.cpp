#include "robot/motion.h"

#include <gtest/gtest.h>

#include "doubles.h"

namespace mirada::robot {
namespace {

class MotionTest : public ::testing::Test {
 protected:
  MotionTest() { motion.begin_run(safety.arm(safety.stop_and_permit(), false)); }

  /// Ticks until the motion has ended; how long that took.
  double run(MotionTicket ticket, double most_s = 60) {
    const Micros start = clock.now();
    while (motion.state(ticket) == MotionState::going && seconds(clock.now() - start) < most_s) tick();
    return seconds(clock.now() - start);
  }
  void tick() {
    for (int i = 0; i < 2; ++i) drive.step(10 * kMillisecond);
    clock.advance(20 * kMillisecond);
    farthest = std::max(farthest, drive.odometry().X_OR.x_m);
    safety.heartbeat();
    motion.step(clock.now(), drive.odometry());
  }

  ManualClock clock;
  LaggingDrive drive;
  DriveConfig config;
  Safety safety{&drive, config, clock};
  Motion motion{config, safety};
  double farthest = 0;
};

TEST_F(MotionTest, DrivesTheDistanceWithoutPassingIt) {
  for (const double goal_m : {0.02, 0.2, 1.0}) {
    const double from_m = drive.odometry().X_OR.x_m;
    farthest = from_m;
    const auto ticket = motion.drive(goal_m, {});
    run(ticket);
    EXPECT_EQ(motion.state(ticket), MotionState::done);
    EXPECT_NEAR(drive.odometry().X_OR.x_m - from_m, goal_m, 0.003);
    EXPECT_LT(farthest - from_m, goal_m + 0.002);
    EXPECT_EQ(drive.odometry().speed.left_mps, 0);
  }
}

TEST_F(MotionTest, DrivesBackward) {
  const auto ticket = motion.drive(-0.3, {});
  run(ticket);
  EXPECT_NEAR(drive.odometry().X_OR.x_m, -0.3, 0.003);
}

TEST_F(MotionTest, TakesAboutTheTimeThatTheCruiseSpeedGives) {
  const double took_s = run(motion.drive(1.0, {}));
  EXPECT_GT(took_s, 1.0 / config.cruise_mps);
  EXPECT_LT(took_s, 1.0 / config.cruise_mps + 1.2);
}

TEST_F(MotionTest, TurnsBothWaysAndMoreThanOnce) {
  double heading_rad = 0;
  for (const double goal_deg : {90.0, -45.0, 5.0, 540.0}) {
    heading_rad = wrap_rad(heading_rad + rad(goal_deg));
    const auto ticket = motion.turn(rad(goal_deg), {});
    run(ticket);
    EXPECT_EQ(motion.state(ticket), MotionState::done);
    EXPECT_NEAR(deg(wrap_rad(drive.odometry().X_OR.heading_rad - heading_rad)), 0, 1.0) << goal_deg;
    heading_rad = drive.odometry().X_OR.heading_rad;
  }
}

TEST_F(MotionTest, HoldsTheLineWithUnequalWheels) {
  drive.left_error_ = 0.05;
  run(motion.drive(1.0, {}));
  EXPECT_NEAR(drive.odometry().X_OR.y_m, 0, 0.03);
  EXPECT_NEAR(deg(drive.odometry().X_OR.heading_rad), 0, 2);
}

TEST_F(MotionTest, NeverAsksForMoreThanTheWheelsCanFollow) {
  motion.set_speeds({0.35, 0.35}, {});
  for (int i = 0; i < 30; ++i) tick();
  motion.set_speeds({-0.35, 0.35}, {});
  for (int i = 0; i < 60; ++i) tick();
  for (std::size_t i = 1; i < drive.told_.size(); ++i) {
    EXPECT_LE(std::abs(drive.told_[i].left_mps - drive.told_[i - 1].left_mps), 0.02 + 1e-9);
  }
  EXPECT_NEAR(drive.target_.left_mps, -0.35, 1e-9);
}

TEST_F(MotionTest, TheNewestWins) {
  const auto drive_ticket = motion.drive(1.0, {});
  for (int i = 0; i < 20; ++i) tick();
  const auto turn_ticket = motion.turn(rad(90), {});
  EXPECT_EQ(motion.state(drive_ticket), MotionState::overtaken);
  EXPECT_EQ(motion.state(turn_ticket), MotionState::going);
  run(turn_ticket);
  EXPECT_EQ(motion.state(drive_ticket), MotionState::overtaken);
  EXPECT_EQ(motion.state(turn_ticket), MotionState::done);
}

TEST_F(MotionTest, EndsWithItsScriptAndNoOther) {
  const auto ticket = motion.drive(1.0, {7, "a"});
  tick();
  motion.script_ended(8);
  EXPECT_EQ(motion.state(ticket), MotionState::going);
  motion.script_ended(7);
  EXPECT_EQ(motion.state(ticket), MotionState::overtaken);
  tick();
  EXPECT_EQ(drive.target_.left_mps, 0);
}

TEST_F(MotionTest, GivesUpWhenItDoesNotGetOn) {
  drive.blocked_ = true;
  const auto ticket = motion.drive(1.0, {});
  const double took_s = run(ticket);
  EXPECT_EQ(motion.state(ticket), MotionState::stalled);
  EXPECT_LT(took_s, 2.0);
  tick();
  EXPECT_EQ(drive.target_.left_mps, 0);
}

TEST_F(MotionTest, APausedDriveGoesOnToItsGoal) {
  const auto ticket = motion.drive(0.5, {});
  for (int i = 0; i < 50; ++i) tick();
  motion.pause(true);
  tick();
  EXPECT_EQ(drive.target_.left_mps, 0);
  for (int i = 0; i < 200; ++i) tick();
  EXPECT_EQ(motion.state(ticket), MotionState::going);
  motion.pause(false);
  run(ticket);
  EXPECT_EQ(motion.state(ticket), MotionState::done);
  EXPECT_NEAR(drive.odometry().X_OR.x_m, 0.5, 0.003);
}

TEST_F(MotionTest, EndSetSpeedsNamesTheBlockOnlyWhenItMoved) {
  motion.set_speeds({0, 0}, {1, "still"});
  EXPECT_FALSE(motion.end_set_speeds().has_value());
  motion.set_speeds({0.1, 0.1}, {1, "moving"});
  EXPECT_EQ(motion.end_set_speeds().value().block, "moving");
  EXPECT_FALSE(motion.end_set_speeds().has_value());
}

TEST_F(MotionTest, ZeroDistanceIsDoneAtOnce) {
  const auto ticket = motion.drive(0, {});
  EXPECT_LT(run(ticket), 0.1);
  EXPECT_EQ(motion.state(ticket), MotionState::done);
}

}  // namespace
}  // namespace mirada::robot
