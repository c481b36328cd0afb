#include "robot/safety.h"

#include <limits>
#include <thread>

#include <gtest/gtest.h>

#include "doubles.h"

namespace mirada::robot {
namespace {

class SafetyTest : public ::testing::Test {
 protected:
  Safety::Epoch armed(bool uses_camera = false) { return safety.arm(safety.stop_and_permit(), uses_camera); }
  bool moving() const { return drive.target_.left_mps != 0 || drive.target_.right_mps != 0; }

  ManualClock clock;
  LaggingDrive drive;
  Safety safety{&drive, DriveConfig{}, clock};
};

TEST_F(SafetyTest, OpeningStopsTheWheels) {
  EXPECT_EQ(drive.stops_, 1);
  EXPECT_FALSE(safety.armed());
}

TEST_F(SafetyTest, ObeysTheArmedRunOnly) {
  const auto epoch = armed();
  EXPECT_EQ(safety.command(epoch, {0.1, 0.2}), Safety::Verdict::obeyed);
  EXPECT_EQ(drive.target_.right_mps, 0.2);
  EXPECT_EQ(safety.command(epoch + 2, {0.3, 0.3}), Safety::Verdict::over);
  EXPECT_EQ(safety.command(0, {0.3, 0.3}), Safety::Verdict::over);
  EXPECT_EQ(drive.target_.right_mps, 0.2);
}

TEST_F(SafetyTest, StopIsLatchedForTheOldRun) {
  const auto old = armed();
  safety.command(old, {0.2, 0.2});
  safety.stop();
  EXPECT_FALSE(moving());
  EXPECT_EQ(safety.command(old, {0.2, 0.2}), Safety::Verdict::over);
  EXPECT_FALSE(moving());
  const auto next = armed();
  EXPECT_EQ(safety.command(old, {0.2, 0.2}), Safety::Verdict::over);
  EXPECT_EQ(safety.command(next, {0.2, 0.2}), Safety::Verdict::obeyed);
}

TEST_F(SafetyTest, AStopAfterTheFlagWinsOverThePermit) {
  const auto permit = safety.stop_and_permit();
  safety.stop();
  EXPECT_EQ(safety.arm(permit, false), 0u);
  EXPECT_FALSE(safety.armed());
}

TEST_F(SafetyTest, EndingAnOldRunLeavesThePermitOfTheNext) {
  const auto old = armed();
  const auto permit = safety.stop_and_permit();
  safety.end(old);
  EXPECT_NE(safety.arm(permit, false), 0u);
}

TEST_F(SafetyTest, RefusesNumbersThatAreNoSpeedsAndStops) {
  const auto epoch = armed();
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    safety.command(epoch, {0.1, 0.1});
    EXPECT_EQ(safety.command(epoch, {bad, 0.1}), Safety::Verdict::not_finite);
    EXPECT_FALSE(moving());
  }
}

TEST_F(SafetyTest, RefusesMoreThanTheWheelsMayDo) {
  const auto epoch = armed();
  EXPECT_EQ(safety.command(epoch, {0.35, -0.35}), Safety::Verdict::obeyed);
  EXPECT_EQ(safety.command(epoch, {0.36, 0}), Safety::Verdict::too_fast);
  EXPECT_FALSE(moving());
}

TEST_F(SafetyTest, ALateTickStopsAndTheNextGoesOn) {
  const auto epoch = armed();
  safety.command(epoch, {0.2, 0.2});
  clock.advance(200 * kMillisecond);
  EXPECT_EQ(safety.check(), Safety::Trip::none);
  clock.advance(1);
  EXPECT_EQ(safety.check(), Safety::Trip::late);
  EXPECT_FALSE(moving());
  safety.heartbeat();
  EXPECT_EQ(safety.check(), Safety::Trip::none);
  EXPECT_EQ(safety.command(epoch, {0.2, 0.2}), Safety::Verdict::obeyed);
}

TEST_F(SafetyTest, AVeryLateTickEndsTheRun) {
  const auto epoch = armed();
  safety.command(epoch, {0.2, 0.2});
  clock.advance(2 * kSecond + 1);
  EXPECT_EQ(safety.check(), Safety::Trip::stuck);
  EXPECT_EQ(safety.tripped(), Safety::Trip::stuck);
  EXPECT_EQ(safety.command(epoch, {0.2, 0.2}), Safety::Verdict::over);
  EXPECT_FALSE(moving());
}

TEST_F(SafetyTest, ARunThatSeesEndsHalfASecondAfterItsLastPicture) {
  const auto epoch = armed(true);
  safety.command(epoch, {0.2, 0.2});
  const auto beat = [&](int times) {
    for (int i = 0; i < times; ++i) {
      clock.advance(20 * kMillisecond);
      safety.heartbeat();
    }
  };
  beat(20);
  safety.frame_seen(40 * kMillisecond);
  beat(23);
  EXPECT_EQ(safety.check(), Safety::Trip::none);
  beat(1);
  EXPECT_EQ(safety.check(), Safety::Trip::blind);
  EXPECT_FALSE(moving());
  EXPECT_EQ(safety.command(epoch, {0.2, 0.2}), Safety::Verdict::over);
}

TEST_F(SafetyTest, ARunThatDoesNotSeeNeedsNoPictures) {
  armed(false);
  for (int i = 0; i < 100; ++i) {
    clock.advance(20 * kMillisecond);
    safety.heartbeat();
  }
  EXPECT_EQ(safety.check(), Safety::Trip::none);
}

TEST_F(SafetyTest, AHiccupOfTheMachineIsNoBlindness) {
  armed(true);
  clock.advance(900 * kMillisecond);
  safety.heartbeat();
  EXPECT_EQ(safety.check(), Safety::Trip::none);
}

TEST_F(SafetyTest, NoDriveIsNoCrash) {
  Safety wheelless(nullptr, DriveConfig{}, clock);
  EXPECT_FALSE(wheelless.has_drive());
  EXPECT_EQ(wheelless.command(wheelless.arm(wheelless.stop_and_permit(), false), {0.1, 0.1}),
            Safety::Verdict::obeyed);
  wheelless.stop();
}

/// A drive whose set() can be held in the middle, to let a stop overtake it.
class SlowDrive final : public hal::Drive {
 public:
  void set(const WheelSpeeds& speeds) override {
    in_set();
    speeds_ = speeds;
  }
  void stop() override { speeds_ = {}; }
  hal::Odometry odometry() const override { return {}; }
  std::function<void()> in_set = [] {};
  WheelSpeeds speeds_;
};

TEST(SafetyRace, ACommandOvertakenByAStopDoesNotMoveTheRobot) {
  ManualClock clock;
  SlowDrive drive;
  Safety safety(&drive, DriveConfig{}, clock);
  const auto epoch = safety.arm(safety.stop_and_permit(), false);
  drive.in_set = [&] { std::thread([&] { safety.stop(); }).join(); };
  EXPECT_EQ(safety.command(epoch, {0.2, 0.2}), Safety::Verdict::over);
  EXPECT_EQ(drive.speeds_.left_mps, 0);
}

}  // namespace
}  // namespace mirada::robot
