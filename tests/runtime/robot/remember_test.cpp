#include <gtest/gtest.h>

#include "../memory/flat_room.h"
#include "doubles.h"
#include "robot/robot.h"

namespace mirada::robot {
namespace {

/// A robot that stands in an open room; its sonar answers at once.
class Remembering : public ::testing::Test {
 protected:
  Detectors detectors() {
    Detectors out;
    out.sonar = [this](const Frame& frame, const NeckAngles&, const Pose2& X_OR) {
      SonarPercept seen = room.look(X_OR, 0, frame.t_exposure);
      seen.frame = frame.number;
      seen.floor_model_trusted = trusted;
      return seen;
    };
    return out;
  }
  /// A picture a twentieth of a second, for so long.
  void run(Micros for_us, bool pictures = true) {
    for (const Micros end = clock.now() + for_us; clock.now() < end;) {
      clock.set(clock.now() + 50 * kMillisecond);
      if (pictures) camera.offer(++number, clock.now());
      robot.observe();
    }
  }

  memory::FlatRoom room;
  bool trusted = true;
  std::uint64_t number = 0;
  ManualClock clock;
  ListCamera camera;
  LaggingDrive drive;
  PlainNeck neck;
  Robot robot{memory::sim_robot(), {&camera, &drive, &neck}, detectors(), Timing::simulated, clock, clock};
};

TEST_F(Remembering, APictureThatCannotBeJudgedIsNoLook) {
  robot.need({true, true, false, true});
  run(kSecond);
  EXPECT_LT(robot.memory().look_age(0), 200 * kMillisecond);
  const Micros last = robot.memory().last_look();
  trusted = false;
  run(2 * kSecond);
  EXPECT_GT(robot.memory().look_age(0), 1'800 * kMillisecond);
  EXPECT_LE(robot.memory().last_look(), last + 50 * kMillisecond);
}

TEST_F(Remembering, WhatWasSeenLongBeforeIsNotRememberedAsNew) {
  robot.need({true, true, false, false});
  run(kSecond);
  robot.need({});
  run(10 * kSecond, false);
  robot.need({true, true, false, true});
  run(100 * kMillisecond, false);
  EXPECT_EQ(robot.memory().last_look(), 0);
  EXPECT_LT(robot.memory().floor().seen_at(0.5, 0), 0);
}

}  // namespace
}  // namespace mirada::robot
