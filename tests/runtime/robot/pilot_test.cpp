#include "robot/pilot.h"

#include <gtest/gtest.h>

#include "../memory/flat_room.h"
#include "doubles.h"
#include "robot/motion_history.h"

namespace mirada::robot {
namespace {

using memory::FlatRoom;

/// A neck that turns at its joint's speed.
class TurningNeck final : public hal::Neck {
 public:
  void aim(const NeckAngles& target) override { target_ = target; }
  void hold() override { target_ = state_.angles; }
  hal::NeckState state() const override { return state_; }
  void step(Micros dt) {
    const double most = 5 * seconds(dt);
    state_.angles.pan_rad += std::clamp(target_.pan_rad - state_.angles.pan_rad, -most, most);
    state_.settled = state_.angles.pan_rad == target_.pan_rad;
  }
  NeckAngles target_;
  hal::NeckState state_;
};

/// A robot of these parts in a flat room, with perfect wheels and an ideal sonar of 20 pictures a second.
class Driving : public ::testing::Test {
 protected:
  Driving() : motion_(config_.drive, safety_), gaze_(&neck_, config_.neck), watch_(gaze_, config_) {
    motion_.begin_run(safety_.arm(safety_.stop_and_permit(), false));
  }

  void wall(double x1, double y1, double x2, double y2) {
    const double length = std::hypot(x2 - x1, y2 - y1);
    for (double s = 0; s <= length; s += 0.02)
      room_.pillars.push_back({x1 + (x2 - x1) * s / length, y1 + (y2 - y1) * s / length, 0.015});
  }
  void box_room(double x1, double y1, double x2, double y2) {
    wall(x1, y1, x2, y1);
    wall(x2, y1, x2, y2);
    wall(x2, y2, x1, y2);
    wall(x1, y2, x1, y1);
  }
  double clearance_m() const {
    double nearest = 10;
    for (const auto& pillar : room_.pillars) {
      const double off = std::hypot(pillar.x_m - pose().x_m, pillar.y_m - pose().y_m) - pillar.radius_m;
      nearest = std::min(nearest, off);
    }
    return nearest;
  }
  Pose2 pose() const { return drive_.odometry().X_OR; }

  void run(double for_s) {
    const Micros end = clock_.now() + micros(for_s);
    while (clock_.now() < end && !(ticket_ != 0 && motion_.state(ticket_) != MotionState::going)) {
      drive_.step(10 * kMillisecond);
      neck_.step(10 * kMillisecond);
      clock_.set(clock_.now() + 10 * kMillisecond);
      const Micros now = clock_.now();
      history_.record(now, {pose(), neck_.state().angles});
      memory_.moved(now, pose());
      if (now % (50 * kMillisecond) == 0 && history_.steady(now - 40 * kMillisecond)) {
        const MotionHistory::State then = history_.at(now - 40 * kMillisecond);
        memory_.observe(room_.look(then.X_OR, then.X_OR, deg(then.neck.pan_rad), now - 40 * kMillisecond));
      }
      if (now % (20 * kMillisecond) != 0) continue;
      safety_.heartbeat();
      Watch::Sight sight;
      sight.now = now;
      sight.speed_mps = (drive_.odometry().speed.left_mps + drive_.odometry().speed.right_mps) / 2;
      watch_.step(memory_, sight);
      pilot_.step(now, memory_);
      motion_.step(now, drive_.odometry());
      least_m_ = std::min(least_m_, clearance_m());
      const auto square = std::pair(std::lround(pose().x_m * 4), std::lround(pose().y_m * 4));
      squares_.insert(square);
    }
  }

  RobotConfig config_ = memory::sim_robot();
  FlatRoom room_;
  ManualClock clock_;
  LaggingDrive drive_;
  TurningNeck neck_;
  Safety safety_{&drive_, config_.drive, clock_};
  Motion motion_;
  Gaze gaze_;
  Watch watch_;
  Pilot pilot_{motion_, watch_, config_};
  MotionHistory history_;
  memory::VisualMemory memory_{config_};
  MotionTicket ticket_ = 0;
  double least_m_ = 10;
  std::set<std::pair<long, long>> squares_;
};

constexpr double kBody_m = 0.1;

TEST_F(Driving, RoamsARoomWithoutTouchingIt) {
  box_room(-1.2, -1.2, 1.8, 1.2);
  wall(0.6, -0.2, 0.6, 0.2);
  wall(-0.4, 0.6, 0, 0.6);
  pilot_.roam({1, "b"});
  run(40);
  EXPECT_GT(least_m_, kBody_m);
  EXPECT_GT(squares_.size(), 25u);
}

TEST_F(Driving, RoamsOnThroughEveryRoom) {
  box_room(-1.0, -0.8, 3.8, 0.8);
  wall(0.6, -0.8, 0.6, 0.35);
  wall(2.2, -0.35, 2.2, 0.8);
  pilot_.roam({1, "b"});
  run(100);
  EXPECT_GT(least_m_, kBody_m);
  EXPECT_GT(squares_.size(), 46u);
  const auto last =
      std::count_if(squares_.begin(), squares_.end(), [](const auto& at) { return at.first > 9; });
  EXPECT_GT(last, 18);
}

TEST_F(Driving, DrivesToAPlaceBehindAWall) {
  box_room(-1.2, -1.2, 1.8, 1.2);
  wall(0.6, -0.6, 0.6, 0.5);
  ticket_ = pilot_.go_to({1.2, 0}, {1, "b"});
  run(60);
  EXPECT_EQ(motion_.state(ticket_), MotionState::done);
  EXPECT_NEAR(pose().x_m, 1.2, 0.04);
  EXPECT_NEAR(pose().y_m, 0, 0.04);
  EXPECT_GT(least_m_, kBody_m);
}

TEST_F(Driving, DrivesToAPlaceBehindItsBack) {
  box_room(-1.2, -1.2, 1.8, 1.2);
  ticket_ = pilot_.go_to({-0.8, 0.3}, {1, "b"});
  run(40);
  EXPECT_EQ(motion_.state(ticket_), MotionState::done);
  EXPECT_GT(least_m_, kBody_m);
}

TEST_F(Driving, GivesUpWhereNoWayLeads) {
  box_room(-1.2, -1.2, 1.8, 1.2);
  ticket_ = pilot_.go_to({3.0, 0}, {1, "b"});
  run(90);
  EXPECT_EQ(motion_.state(ticket_), MotionState::stalled);
  EXPECT_GT(least_m_, kBody_m);
}

TEST_F(Driving, FollowsTheWallAllRound) {
  box_room(-1.2, -1.2, 1.8, 1.2);
  pilot_.follow_wall({1, "b"});
  run(70);
  EXPECT_GT(least_m_, kBody_m);
  std::set<int> corners;
  for (const auto& [x, y] : squares_) {
    if (x >= 4 && y >= 2) corners.insert(0);
    if (x <= -3 && y >= 2) corners.insert(1);
    if (x <= -3 && y <= -2) corners.insert(2);
    if (x >= 4 && y <= -2) corners.insert(3);
  }
  EXPECT_EQ(corners.size(), 4u);
}

TEST_F(Driving, AnotherMotionTakesTheWheels) {
  box_room(-1.2, -1.2, 1.8, 1.2);
  const MotionTicket roaming = pilot_.roam({1, "b"});
  run(3);
  EXPECT_EQ(motion_.state(roaming), MotionState::going);
  EXPECT_EQ(pilot_.roam({1, "b"}), roaming);
  motion_.halt();
  run(1);
  EXPECT_EQ(motion_.state(roaming), MotionState::overtaken);
  EXPECT_EQ(watch_.keeping(), memory::Watching::nothing);
  EXPECT_EQ(drive_.odometry().speed.left_mps, 0);
}

TEST_F(Driving, APauseCostsNoPatience) {
  box_room(-1.2, -1.2, 1.8, 1.2);
  watch_.look_around();
  run(1.5);
  ticket_ = pilot_.go_to({0.9, 0}, {1, "b"});
  run(0.6);
  motion_.pause(true);
  run(30);
  motion_.pause(false);
  run(20);
  EXPECT_EQ(motion_.state(ticket_), MotionState::done);
}

TEST_F(Driving, APausedNeckGoesOnToWhereItWasGoing) {
  gaze_.pan_to(rad(60));
  run(0.1);
  gaze_.pause(true);
  run(1);
  EXPECT_LT(neck_.state().angles.pan_rad, rad(40));
  gaze_.pause(false);
  run(1);
  EXPECT_NEAR(neck_.state().angles.pan_rad, rad(60), 1e-9);
}

TEST_F(Driving, LevelsACameraThatWasLeftLookingUp) {
  gaze_.tilt_to(-rad(35));
  pilot_.roam({1, "b"});
  EXPECT_EQ(neck_.target_.tilt_rad, 0);
  gaze_.tilt_to(-rad(35));
  watch_.look_around();
  EXPECT_EQ(neck_.target_.tilt_rad, 0);
}

TEST_F(Driving, LooksAroundInLessThanASecond) {
  run(0.3);
  watch_.look_around();
  const Micros start = clock_.now();
  for (int i = 0; i < 300 && watch_.looking_around(); ++i) run(0.02);
  EXPECT_LT(clock_.now() - start, kSecond);
  for (double degree = -80; degree <= 80; ++degree)
    EXPECT_LT(memory_.look_age(rad(degree)), 1'200 * kMillisecond) << degree;
}

}  // namespace
}  // namespace mirada::robot
