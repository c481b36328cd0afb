#include "robot/seeing.h"

#include <cmath>

#include <gtest/gtest.h>

namespace mirada::robot {
namespace {

/// Readings of every degree from -31 to 31, clear to 2 m, but for what a test changes.
SonarPercept open_floor() {
  SonarPercept sonar;
  sonar.frame = 1;
  sonar.floor_model_trusted = true;
  for (int degree = -31; degree <= 31; ++degree)
    sonar.readings.push_back({rad(degree), Answer::clear, 2.0, 0.05});
  return sonar;
}

SonarReading& at(SonarPercept& sonar, int degree) {
  return sonar.readings[static_cast<std::size_t>(degree + 31)];
}

SonarView view(const SonarPercept& sonar, const Pose2& X_OR = {}, Micros now = 0) {
  return {sonar, X_OR, now};
}

TEST(SonarView, GivesTheReadingOfTheDirection) {
  SonarPercept sonar = open_floor();
  at(sonar, 10) = {rad(10), Answer::blocked, 0.5, 0.01};
  EXPECT_EQ(view(sonar).at(rad(10)).answer, Answer::blocked);
  EXPECT_NEAR(view(sonar).at(rad(10)).distance_m, 0.5, 1e-9);
  EXPECT_EQ(view(sonar).at(rad(12)).answer, Answer::clear);
}

TEST(SonarView, OutsideThePictureIsNotSeen) {
  const SonarPercept sonar = open_floor();
  EXPECT_EQ(view(sonar).at(rad(40)).answer, Answer::not_seen);
  EXPECT_TRUE(std::isnan(view(sonar).at(rad(40)).distance_m));
}

TEST(SonarView, OldIsNotSeen) {
  const SonarPercept sonar = open_floor();
  EXPECT_TRUE(view(sonar, {}, kPerceptLife).fresh());
  EXPECT_EQ(view(sonar, {}, kPerceptLife + 1).at(0).answer, Answer::not_seen);
  EXPECT_FALSE(view(sonar, {}, kPerceptLife + 1).way_clear(0.18, 0.4));
  EXPECT_FALSE(view(sonar, {}, kPerceptLife + 1).nearest_obstacle().has_value());
}

TEST(SonarView, NothingSeenYetIsNotSeen) {
  const SonarPercept none;
  EXPECT_EQ(view(none).at(0).answer, Answer::not_seen);
  EXPECT_FALSE(view(none).way_clear(0.18, 0.4));
}

TEST(SonarView, FollowsTheRobotsTurnSinceTheExposure) {
  SonarPercept sonar = open_floor();
  at(sonar, 0) = {0, Answer::blocked, 0.5, 0.01};
  const SonarView turned = view(sonar, {0, 0, rad(10)});
  EXPECT_EQ(turned.at(rad(-10)).answer, Answer::blocked);
  EXPECT_EQ(turned.at(0).answer, Answer::clear);
}

TEST(SonarView, FollowsTheRobotsWaySinceTheExposure) {
  SonarPercept sonar = open_floor();
  at(sonar, 0) = {0, Answer::blocked, 0.5, 0.01};
  EXPECT_NEAR(view(sonar, {0.1, 0, 0}).at(0).distance_m, 0.4, 1e-9);
}

TEST(WayClear, OpenFloorIsClearAsFarAsItWasSeen) {
  const SonarPercept sonar = open_floor();
  EXPECT_TRUE(view(sonar).way_clear(0.18, 0.4));
  EXPECT_TRUE(view(sonar).way_clear(0.18, 1.9));
  EXPECT_FALSE(view(sonar).way_clear(0.18, 2.5));
}

TEST(WayClear, AnObstacleInTheStripBlocksAndBesideItDoesNot) {
  SonarPercept sonar = open_floor();
  at(sonar, 15) = {rad(15), Answer::blocked, 0.30, 0.01};  // 7.8 cm to the left: in the strip
  EXPECT_FALSE(view(sonar).way_clear(0.18, 0.4));
  at(sonar, 15).distance_m = 0.60;  // 15.5 cm to the left: beside it
  EXPECT_TRUE(view(sonar).way_clear(0.18, 0.4));
}

TEST(WayClear, AnObstacleBeyondTheDistanceIsNoMatter) {
  SonarPercept sonar = open_floor();
  at(sonar, 0) = {0, Answer::blocked, 0.45, 0.01};
  EXPECT_TRUE(view(sonar).way_clear(0.18, 0.4));
  EXPECT_FALSE(view(sonar).way_clear(0.18, 0.5));
}

TEST(WayClear, WhatIsNotSeenIsNotClear) {
  SonarPercept sonar = open_floor();
  at(sonar, 2) = {rad(2), Answer::not_seen, std::nan(""), std::nan("")};
  EXPECT_FALSE(view(sonar).way_clear(0.18, 0.4));
}

TEST(WayClear, LookingElsewhereIsNotClear) {
  SonarPercept sonar = open_floor();
  for (SonarReading& reading : sonar.readings) reading.bearing_rad += rad(45);
  EXPECT_FALSE(view(sonar).way_clear(0.18, 0.4));
}

TEST(NearestObstacle, IsTheNearestBoundaryAndNotTheNearestEdgeOfTheFloorSeen) {
  SonarPercept sonar = open_floor();
  EXPECT_FALSE(view(sonar).nearest_obstacle().has_value());
  at(sonar, -20) = {rad(-20), Answer::blocked, 0.8, 0.02};
  at(sonar, 5) = {rad(5), Answer::blocked, 0.6, 0.02};
  at(sonar, 6) = {rad(6), Answer::clear, 0.3, 0.02};
  EXPECT_NEAR(deg(view(sonar).nearest_obstacle()->bearing_rad), 5, 1e-9);
}

}  // namespace
}  // namespace mirada::robot
