#include "robot/follower.h"

#include <functional>
#include <set>

#include <gtest/gtest.h>

#include "../memory/flat_room.h"
#include "doubles.h"

namespace mirada::robot {
namespace {

using Eigen::Vector2d;

class TurningNeck final : public hal::Neck {
 public:
  void aim(const NeckAngles& target) override { target_ = target; }
  void hold() override { target_ = state_.angles; }
  hal::NeckState state() const override { return state_; }
  void step(Micros dt) {
    const auto toward = [&](double from, double to, double radps) {
      return from + std::clamp(to - from, -radps * seconds(dt), radps * seconds(dt));
    };
    NeckAngles& now = state_.angles;
    now = {toward(now.pan_rad, target_.pan_rad, 5), toward(now.tilt_rad, target_.tilt_rad, 3.5)};
    state_.settled = now.pan_rad == target_.pan_rad && now.tilt_rad == target_.tilt_rad;
  }
  NeckAngles target_;
  hal::NeckState state_;
};

/// A robot with perfect wheels that is asked to keep a metre off somebody. Looking up it sees their face,
/// looking level or down the floor.
class Following : public ::testing::Test {
 protected:
  static constexpr double kLens_m = 0.2, kFace_m = 1.0;

  Following() : motion_(config_.drive, safety_), gaze_(&neck_, config_.neck), watch_(gaze_, config_) {
    motion_.begin_run(safety_.arm(safety_.stop_and_permit(), false));
  }

  Pose2 pose() const { return drive_.odometry().X_OR; }
  double away_m() const { return (person_ - Vector2d(pose().x_m, pose().y_m)).norm(); }
  double looks_rad() const { return wrap_rad(pose().heading_rad + neck_.state().angles.pan_rad); }

  void see_face(Micros now) {
    faces_ = {};
    faces_.frame = static_cast<std::uint64_t>(now);
    faces_.t_exposure = now;
    const Vector2d to = person_ - Vector2d(pose().x_m, pose().y_m);
    const double bearing = wrap_rad(std::atan2(to.y(), to.x()) - pose().heading_rad);
    const NeckAngles neck = neck_.state().angles;
    if (!shown_ || std::abs(wrap_rad(bearing - neck.pan_rad)) > rad(28) || neck.tilt_rad > -rad(15)) return;
    FacePercept face;
    face.id = 1;
    face.bearing_rad = bearing;
    face.distance_m = to.norm();
    face.elevation_rad = std::atan2(kFace_m - kLens_m, to.norm());
    face.p_O_m = person_;
    face.v_O_mps = walk_mps_;
    faces_.faces.push_back(face);
  }
  void see_floor(Micros now) {
    const NeckAngles neck = neck_.state().angles;
    if (neck.tilt_rad < -rad(15) || !neck_.state().settled) return;
    SonarPercept sonar = room_.look(pose(), deg(neck.pan_rad), now);
    sonar.neck = neck;
    memory_.observe(sonar);
  }
  void run(
      double for_s, const std::function<void()>& each_tick = [] {}) {
    const Micros end = clock_.now() + micros(for_s);
    while (clock_.now() < end) {
      drive_.step(10 * kMillisecond);
      person_ += walk_mps_ * 0.01;
      neck_.step(10 * kMillisecond);
      clock_.set(clock_.now() + 10 * kMillisecond);
      const Micros now = clock_.now();
      memory_.moved(now, pose());
      if (now % (50 * kMillisecond) == 0) {
        see_face(now);
        see_floor(now);
      }
      if (now % (20 * kMillisecond) != 0) continue;
      safety_.heartbeat();
      follower_.step({now, pose(), faces_.frame != 0 ? &faces_ : nullptr}, memory_);
      motion_.step(now, drive_.odometry());
      each_tick();
    }
  }

  RobotConfig config_ = memory::sim_robot();
  memory::FlatRoom room_;
  ManualClock clock_;
  LaggingDrive drive_;
  TurningNeck neck_;
  Safety safety_{&drive_, config_.drive, clock_};
  Motion motion_;
  Gaze gaze_;
  Watch watch_;
  Follower follower_{motion_, gaze_, watch_, config_};
  memory::VisualMemory memory_{config_};
  FacesPercept faces_;
  Vector2d person_{1.0, 0}, walk_mps_{0, 0};
  bool shown_ = true;
};

TEST_F(Following, LooksBehindAndThenBacksOffWhereItHadNotSeenAnyFloor) {
  person_ = {0.55, 0};
  follower_.person(1, {1, "b"});
  run(9);
  EXPECT_GT(away_m(), 0.9);
}

TEST_F(Following, DoesNotBackOffIntoAWallThatItHadNotSeen) {
  for (double y = -1.5; y <= 1.5; y += 0.02) room_.pillars.push_back({-0.4, y, 0.015});
  person_ = {0.5, 0};
  follower_.person(1, {1, "b"});
  double nearest_m = 1;
  run(20, [&] { nearest_m = std::min(nearest_m, pose().x_m + 0.385); });
  EXPECT_GT(nearest_m, 0.1) << nearest_m;
}

TEST_F(Following, LooksLowAtWhatBlocksTheWayCloseByAndDrivesOnWhenItHasGone) {
  memory_.moved(10 * kMillisecond, pose());
  room_.pillars = {{0.25, 0, 0.02}};
  SonarPercept once = room_.look(pose(), 0, 10 * kMillisecond);
  once.neck.tilt_rad = rad(20);
  memory_.observe(once);
  room_.pillars.clear();
  person_ = {1.8, 0};
  follower_.person(1, {1, "b"});
  run(8);
  EXPECT_LT(away_m(), 1.2);
}

TEST_F(Following, KeepsFartherBehindWhoGoesAndNearerBeforeWhoComesForTheyMayTurnRound) {
  follower_.person(1, {1, "b"});
  run(2);
  walk_mps_ = {0.25, 0};
  run(6);
  EXPECT_NEAR(away_m(), 1.04, 0.025);
  walk_mps_ = {0, 0};
  run(4);
  EXPECT_NEAR(away_m(), 1, 0.04);
  walk_mps_ = {-0.25, 0};
  run(3);
  EXPECT_NEAR(away_m(), 0.92, 0.05);
}

TEST_F(Following, SearchesAllRoundWithLooksThatAreHeldStill) {
  follower_.person(1, {1, "b"});
  run(2);
  shown_ = false;
  std::set<long> sixths;
  double last_rad = 0;
  Micros since = 0;
  run(12, [&] {
    if (std::abs(wrap_rad(looks_rad() - last_rad)) > rad(2.5)) {
      last_rad = looks_rad();
      since = clock_.now();
    }
    if (follower_.state() == FollowState::searching && clock_.now() - since > 200 * kMillisecond)
      sixths.insert((std::lround(deg(last_rad) / 60) + 6) % 6);
  });
  EXPECT_EQ(sixths.size(), 6u);
}

}  // namespace
}  // namespace mirada::robot
