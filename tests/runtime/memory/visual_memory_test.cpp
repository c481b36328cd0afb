#include "memory/visual_memory.h"

#include <gtest/gtest.h>

#include "flat_room.h"
#include "memory/ways.h"

namespace mirada::memory {
namespace {

constexpr Micros kFrame = 50 * kMillisecond;

class Memory : public ::testing::Test {
 protected:
  /// `count` pictures, one a frame's time.
  void look(const FlatRoom& room, double pan_deg, int count = 1) {
    for (int i = 0; i < count; ++i) {
      now_ += kFrame;
      memory_.moved(now_, pose_);
      memory_.observe(room.look(pose_, pan_deg, now_));
    }
  }
  void sweep(const FlatRoom& room) {
    for (const double pan : {-80.0, -40.0, 0.0, 40.0, 80.0}) look(room, pan, 2);
  }
  void drive_to(const Pose2& to, double for_s) {
    now_ += micros(for_s);
    roll(memory_, to, now_);
    pose_ = to;
  }
  const Direction& at(double bearing_deg) const { return memory_.around().at(rad(bearing_deg)); }

  VisualMemory memory_{sim_robot()};
  Pose2 pose_;
  Micros now_ = 0;
};

TEST_F(Memory, NothingLookedAtIsNotSeenAllRound) {
  memory_.moved(kSecond, {});
  for (const Direction& direction : memory_.around().all()) EXPECT_EQ(direction.answer, Answer::not_seen);
  EXPECT_FALSE(memory_.way_clear(0, 0.18, 0.4));
}

TEST_F(Memory, WhatLeftTheViewIsStillKnownAndWhereNothingWasLookedAtIsNot) {
  const FlatRoom room{{{1.0, 0, 0.1}}};
  look(room, 0);
  drive_to({0, 0, rad(120)}, 1);
  EXPECT_EQ(at(-120).answer, Answer::blocked);
  EXPECT_NEAR(at(-120).distance_m, 0.9, 0.02);
  EXPECT_EQ(at(-100).answer, Answer::clear);
  EXPECT_NEAR(at(-100).distance_m, 3.0, 0.1);
  EXPECT_EQ(at(0).answer, Answer::not_seen);
  EXPECT_EQ(at(120).answer, Answer::not_seen);
}

TEST_F(Memory, FloorNearerThanWhatACameraLookingUpShowsStaysUnseen) {
  const FlatRoom room{{{1.6, 0, 0.1}}};
  now_ += kFrame;
  memory_.moved(now_, pose_);
  SonarPercept up = room.look(pose_, 0, now_);
  up.neck.tilt_rad = -rad(35);
  memory_.observe(up);
  EXPECT_FALSE(memory_.way_clear(0, 0.18, 0.4));
  EXPECT_LT(memory_.floor().seen_at(0.5, 0), 0);
  EXPECT_TRUE(memory_.floor().likely_at(0.5, 0));
  EXPECT_GE(memory_.floor().seen_at(1.4, 0), 0);
  look(room, 0);
  EXPECT_GE(memory_.floor().seen_at(0.5, 0), 0);
  memory_.observe(up);
  EXPECT_GE(memory_.floor().seen_at(0.5, 0), 0) << "what was seen is not unseen by looking up";
}

TEST_F(Memory, AWayThatIsShorterThanTheRobotIsWideIsNotClearUnseen) {
  memory_.moved(kSecond, {});
  EXPECT_FALSE(memory_.way_clear(0, 0.6, 0.3));
}

TEST_F(Memory, APictureAboveTheHorizonIsNoLook) {
  SonarPercept up = FlatRoom{}.look(pose_, 0, kFrame);
  for (SonarReading& reading : up.readings) reading.answer = Answer::above_horizon;
  memory_.moved(kFrame, pose_);
  memory_.observe(up);
  EXPECT_EQ(memory_.look_age(0), VisualMemory::kNeverLooked);
}

TEST_F(Memory, AThingIsForgottenInTimeThoughNothingElseIsSeen) {
  memory_.observe(ThingSeen{}, pose_, 0);
  memory_.moved(601 * kSecond, pose_);
  EXPECT_EQ(memory_.things().find(ThingSeen{}.kind, ThingSeen{}.id), nullptr);
}

TEST_F(Memory, FloorIsStillSeenAfterAMonth) {
  now_ = 30LL * 24 * 3600 * kSecond;
  look(FlatRoom{}, 0);
  EXPECT_GE(memory_.floor().seen_at(0.5, 0), 0);
}

TEST_F(Memory, WithoutRememberingOnlyTheNewestPictureCounts) {
  const FlatRoom room{{{1.0, 0, 0.1}}};
  memory_.remember(false);
  look(room, 0);
  EXPECT_EQ(at(0).answer, Answer::blocked);
  look(room, 80);
  EXPECT_EQ(at(0).answer, Answer::not_seen);
  EXPECT_EQ(at(80).answer, Answer::clear);
}

TEST_F(Memory, ItsAnswersComeFromWhereTheRobotIsNow) {
  const FlatRoom room{{{1.0, 0.6, 0.1}}};
  sweep(room);
  drive_to({1.0, 0, 0}, 4);
  EXPECT_EQ(at(90).answer, Answer::blocked);
  EXPECT_NEAR(at(90).distance_m, 0.5, 0.04);
}

TEST_F(Memory, ARemovedObstacleIsGoneWithinTwoLooksAndANewOneIsThereAfterOne) {
  look({{{1.0, 0, 0.1}}}, 0, 3);
  ASSERT_EQ(at(0).answer, Answer::blocked);
  const FlatRoom changed{{{0.8, 0.3, 0.1}}};
  look(changed, 0, 1);
  EXPECT_NEAR(at(deg(std::atan2(0.3, 0.8))).distance_m, std::hypot(0.8, 0.3) - 0.1, 0.03);
  look(changed, 0, 1);
  EXPECT_EQ(at(0).answer, Answer::clear);
  EXPECT_GT(at(0).distance_m, 2.5);
}

TEST_F(Memory, AtTheRimOfTheViewAPlaceIsClearedAsAnywhere) {
  for (const double rim : {-31.0, 31.0}) {
    look({{{std::cos(rad(rim)), std::sin(rad(rim)), 0.02}}}, 0);
    ASSERT_EQ(memory_.points().all().size(), 1u) << rim;
    look({}, 0, 2);
    EXPECT_TRUE(memory_.points().all().empty()) << rim;
  }
}

TEST_F(Memory, EachDirectionAnswersForItself) {
  for (int degree = 0; degree < 360; degree += 9) {
    memory_.forget();
    pose_ = {0.3, -0.2, rad(77)};
    const double angle = pose_.heading_rad + rad(degree);
    look({{{pose_.x_m + std::cos(angle), pose_.y_m + std::sin(angle), 0.02}}}, degree);
    EXPECT_EQ(at(degree).answer, Answer::blocked) << degree;
    EXPECT_EQ(at(degree + 5).answer, Answer::clear) << degree;
    EXPECT_EQ(at(degree - 5).answer, Answer::clear) << degree;
  }
}

TEST_F(Memory, OneBehindAPillarStays) {
  const FlatRoom alone{{{1.6, 0, 0.08}}};
  look(alone, 0, 3);
  const FlatRoom hidden{{{1.6, 0, 0.08}, {0.7, 0, 0.12}}};
  look(hidden, 0, 20);
  EXPECT_NEAR(at(0).distance_m, 0.58, 0.03);
  // From the side both are there.
  drive_to({0.9, -0.6, rad(90)}, 2);
  EXPECT_EQ(at(deg(std::atan2(0.6, 0.7)) - 90).answer, Answer::blocked);
}

TEST_F(Memory, ARemovedObstacleOutOfViewStays) {
  look({{{1.0, 0, 0.1}}}, 0, 3);
  look({}, 80, 20);
  EXPECT_EQ(at(0).answer, Answer::blocked);
}

TEST_F(Memory, WhatIsNearerThanThePictureShowsIsNotCleared) {
  const FlatRoom room{{{0.5, 0, 0.1}}};
  look(room, 0, 3);
  drive_to({0.25, 0, 0}, 1);  // its front is now 15 cm away: below the picture
  look({}, 0, 10);
  EXPECT_EQ(at(0).answer, Answer::blocked);
  EXPECT_NEAR(at(0).distance_m, 0.15, 0.03);
}

TEST_F(Memory, WhatACameraThatLooksUpCutsOffBelowHasNoPlace) {
  SonarPercept up = FlatRoom{}.look(pose_, 0, kFrame);
  up.neck.tilt_rad = rad(-35);
  for (SonarReading& reading : up.readings) reading = {reading.bearing_rad, Answer::blocked, 0.85, 0.1};
  memory_.moved(kFrame, pose_);
  memory_.observe(up);
  EXPECT_TRUE(memory_.points().all().empty());
  EXPECT_NE(at(0).answer, Answer::clear);
}

TEST_F(Memory, GetsLessSureByDrivingAndTurningAndNotByWaiting) {
  look({{{1.0, 0.3, 0.1}}}, 0, 2);
  const auto spread = [this] {
    return std::sqrt(memory_.points().all().front().covariance(memory_.drift()).trace());
  };
  const double fresh_m = spread();
  drive_to(pose_, 20);
  EXPECT_NEAR(spread(), fresh_m, 1e-9);
  drive_to({0, 0, rad(90)}, 2);
  const double turned_m = spread();
  EXPECT_GT(turned_m, fresh_m);
  drive_to({0, 1, rad(90)}, 6);
  EXPECT_GT(spread(), turned_m + 0.005);
}

TEST_F(Memory, ThingsAge) {
  look({{{1.0, 0, 0.1}}}, 0);
  const Micros seen = now_;
  drive_to(pose_, 30);
  EXPECT_EQ(at(0).seen_at, seen);
  drive_to(pose_, 400);
  memory_.observe(FlatRoom{}.look(pose_, 80, now_));
  EXPECT_EQ(at(0).answer, Answer::not_seen);
}

TEST_F(Memory, ForgetsEverything) {
  look({{{1.0, 0, 0.1}}}, 0);
  memory_.forget();
  EXPECT_EQ(at(0).answer, Answer::not_seen);
  EXPECT_TRUE(memory_.points().all().empty());
}

TEST_F(Memory, StaysWithinItsBoundsInAnHourOfALivelyRoom) {
  Random chance(5, "lively room");
  for (int i = 0; i < 1500; ++i) {
    FlatRoom room;
    for (int k = 0; k < 12; ++k)
      room.pillars.push_back({pose_.x_m + chance.uniform(-3, 3), pose_.y_m + chance.uniform(-3, 3), 0.1});
    now_ += 2400 * kMillisecond;
    pose_ = {pose_.x_m + 0.02, pose_.y_m, wrap_rad(pose_.heading_rad + 0.05)};
    memory_.moved(now_, pose_);
    memory_.observe(room.look(pose_, chance.uniform(-80, 80), now_));
    ASSERT_LE(memory_.points().all().size(), ObstaclePoints::kMost);
  }
}

TEST_F(Memory, TheWayIsClearOnlyWhereAllOfItWasSeenFree) {
  const FlatRoom room{{{0.5, 0.45, 0.1}, {0.5, -0.45, 0.1}}};
  look(room, 0, 2);
  EXPECT_TRUE(memory_.way_clear(0, 0.18, 0.4));
  EXPECT_FALSE(memory_.way_clear(rad(42), 0.18, 0.6));
  EXPECT_FALSE(memory_.way_clear(rad(90), 0.18, 0.4));
}

TEST_F(Memory, TheWidestWayLeadsThroughTheWidestGap) {
  FlatRoom room;
  for (int degree = -180; degree < 180; degree += 4) {
    const bool gap = degree > 40 && degree < 80;
    const bool slit = degree > -50 && degree < -30;
    if (!gap && !slit) room.pillars.push_back({std::cos(rad(degree)), std::sin(rad(degree)), 0.05});
  }
  sweep(room);
  const auto way = widest_way(memory_, 0.18, 1.5);
  ASSERT_TRUE(way.has_value());
  EXPECT_NEAR(deg(*way), 60, 4);
  memory_.forget();
  EXPECT_FALSE(widest_way(memory_, 0.18, 1.5).has_value());
}

}  // namespace
}  // namespace mirada::memory
