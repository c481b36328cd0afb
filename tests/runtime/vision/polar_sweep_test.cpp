#include "vision/polar_sweep.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/units.h"

namespace mirada::vision {
namespace {

/// Columns of a lens at the origin, left to right over +-30 degrees, all ending as `end` says.
template <class F>
std::vector<ColumnEnd> fan(F&& end) {
  std::vector<ColumnEnd> columns;
  for (double bearing_deg = 30; bearing_deg >= -30; bearing_deg -= 0.75) {
    const Eigen::Vector2d way(std::cos(rad(bearing_deg)), std::sin(rad(bearing_deg)));
    ColumnEnd column = end(bearing_deg, way);
    column.foot_R_m = 0.2 * way;
    columns.push_back(column);
  }
  return columns;
}

std::vector<SonarReading> swept(const std::vector<ColumnEnd>& columns, double heading_deg = 0) {
  std::vector<SonarReading> out;
  sweep(columns, rad(heading_deg), rad(30), 0.0, out);
  return out;
}

TEST(PolarSweep, AWallAcrossIsReadAtItsTrueDistanceInEveryDegree) {
  const auto readings = swept(fan([](double, const Eigen::Vector2d& way) {
    return ColumnEnd{Answer::blocked, {}, way / way.x(), 0.01};
  }));
  ASSERT_EQ(readings.size(), 61u);
  for (std::size_t i = 0; i < readings.size(); ++i) {
    EXPECT_NEAR(deg(readings[i].bearing_rad), -30.0 + static_cast<double>(i), 1e-9);
    ASSERT_EQ(readings[i].answer, Answer::blocked);
    EXPECT_NEAR(readings[i].distance_m, 1 / std::cos(readings[i].bearing_rad), 1e-3);
  }
}

TEST(PolarSweep, BearingsAreWholeDegreesOfTheRobotWhereverTheNeckPoints) {
  const auto readings = swept({}, 12.4);
  ASSERT_EQ(readings.size(), 60u);
  EXPECT_NEAR(deg(readings.front().bearing_rad), -17, 1e-9);
  EXPECT_NEAR(deg(readings.back().bearing_rad), 42, 1e-9);
  for (const SonarReading& reading : readings) {
    EXPECT_EQ(reading.answer, Answer::not_seen);
    EXPECT_TRUE(std::isnan(reading.distance_m));
  }
}

TEST(PolarSweep, AtAnEdgeTheNearerThingCountsUpToItsSide) {
  auto columns = fan([](double bearing_deg, const Eigen::Vector2d& way) {
    return ColumnEnd{Answer::blocked, {}, (bearing_deg > 4.8 ? 0.5 : 2.0) * way, 0.01};
  });
  const std::size_t last = 33;  // of the nearer thing's columns, at 5.25 degrees; the next is at 4.5
  auto readings = swept(columns);
  EXPECT_NEAR(readings[30 + 6].distance_m, 0.5, 0.01);
  EXPECT_NEAR(readings[30 + 5].distance_m, 0.5, 0.01);  // the middle between the two columns is at 4.87
  EXPECT_NEAR(readings[30 + 4].distance_m, 2.0, 0.01);
  columns[last].edge = 0.1;
  readings = swept(columns);
  EXPECT_NEAR(readings[30 + 6].distance_m, 0.5, 0.01);
  EXPECT_NEAR(readings[30 + 5].distance_m, 2.0, 0.01);
}

TEST(PolarSweep, BesideANearThingTheRobotSeesPastWhatHidesTheFloorFromItsLens) {
  // The lens is 0.3 m ahead of the robot's origin. A thing stands 0.2 m ahead of the lens, to its left.
  std::vector<ColumnEnd> columns;
  for (double bearing_deg = 30; bearing_deg >= -30; bearing_deg -= 0.75) {
    const Eigen::Vector2d way(std::cos(rad(bearing_deg)), std::sin(rad(bearing_deg)));
    const Eigen::Vector2d lens(0.3, 0);
    const bool thing = bearing_deg < 20;
    columns.push_back({Answer::blocked, lens + 0.05 * way, lens + (thing ? 0.2 : 2.0) * way, 0.01});
  }
  const auto readings = swept(columns);
  // The thing's side is at atan(0.2 sin 20 / (0.3 + 0.2 cos 20)) = 8 degrees, the far wall begins at 17.6.
  EXPECT_LT(readings[30 + 7].distance_m, 0.6);
  EXPECT_NEAR(readings[30 + 12].distance_m, 2.3, 0.1);
}

TEST(PolarSweep, ClearIsClearAndAnObstacleInFrontOfItWins) {
  const auto readings = swept(fan([](double bearing_deg, const Eigen::Vector2d& way) {
    const bool post = std::abs(bearing_deg) < 2;
    return ColumnEnd{post ? Answer::blocked : Answer::clear, {}, (post ? 0.8 : 3.0) * way, 0.01};
  }));
  EXPECT_EQ(readings[30].answer, Answer::blocked);
  EXPECT_NEAR(readings[30].distance_m, 0.8, 0.01);
  EXPECT_EQ(readings[30 + 10].answer, Answer::clear);
  EXPECT_NEAR(readings[30 + 10].distance_m, 3.0, 0.01);
}

TEST(PolarSweep, WhatCouldNotBeJudgedIsNotClear) {
  const auto readings = swept(fan([](double bearing_deg, const Eigen::Vector2d& way) {
    const bool dim = bearing_deg < -10;
    return ColumnEnd{dim ? Answer::not_seen : Answer::clear, {}, 3.0 * way, 0.01};
  }));
  EXPECT_EQ(readings[30 - 20].answer, Answer::not_seen);
  EXPECT_EQ(readings[30].answer, Answer::clear);
}

TEST(PolarSweep, ABearingThatOnlyComesIntoViewFarAwayIsNotClear) {
  // The lens looks straight ahead from 0.4 m ahead of the origin: bearings to the side come into view only
  // far away.
  std::vector<ColumnEnd> columns;
  for (double y : {0.2, 0.1, 0.0, -0.1, -0.2}) {
    ColumnEnd column{Answer::clear, {0.6, y * 0.5}, {2.6, 8 * y}, 0.02};
    columns.push_back(column);
  }
  const auto readings = swept(columns);
  EXPECT_EQ(readings[30].answer, Answer::clear);
  EXPECT_EQ(readings[30 + 25].answer, Answer::not_seen);
}

}  // namespace
}  // namespace mirada::vision
