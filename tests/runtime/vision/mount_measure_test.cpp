#include "vision/mount/mount_measure.h"

#include <array>
#include <cmath>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/random.h"
#include "base/units.h"
#include "vision/mount/floor_sight.h"

namespace mirada::vision {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

RobotConfig robot_of(double height_m, double tilt_deg, double roll_deg = 0) {
  RobotConfig robot;
  robot.camera.distortion = {-0.05, 0.01, 0.0005, -0.0005, 0};
  robot.mount.p_TM_m = {0.05, 0, height_m};
  robot.mount.tilt_rad = rad(tilt_deg);
  robot.mount.roll_rad = rad(roll_deg);
  return robot;
}

struct Seen {
  std::vector<cv::Point2d> px;
  std::vector<Vector2d> m;
};

/// A 9x6 board of 25 mm on the floor, turned and placed before the robot; corners with noise.
Seen board_on_floor(const RobotConfig& robot, const NeckAngles& neck, const Vector3d& x_y_turn,
                    Random& random, double noise_px, double raised_m = 0) {
  Seen seen;
  const Eigen::Isometry3d X_CR = robot.X_RC(neck).inverse();
  const Eigen::Rotation2Dd turn(x_y_turn.z());
  for (int i = 0; i < 54; ++i) {
    const Vector2d p_B(0.025 * (i % 9), -0.025 * (i / 9));
    const Vector2d p_R = turn * (p_B - Vector2d(0.1, -0.0625)) + x_y_turn.head<2>();
    const auto pixel = robot.camera.project(X_CR * Vector3d(p_R.x(), p_R.y(), raised_m));
    if (!pixel) continue;
    seen.px.emplace_back(pixel->x() + noise_px * random.gaussian(),
                         pixel->y() + noise_px * random.gaussian());
    seen.m.push_back(p_B);
  }
  return seen;
}

FloorSight sight_of(const RobotConfig& robot, const NeckAngles& neck, Random& random, double noise_px,
                    double raised_m = 0) {
  const Seen seen = board_on_floor(robot, neck, {0.35, 0.02, 0.4}, random, noise_px, raised_m);
  auto sight = sight_from_points(robot.camera, seen.px, seen.m, raised_m, noise_px);
  EXPECT_TRUE(sight);
  return *sight;
}

TEST(FloorSight, ABoardWithoutNoiseGivesTheMountExactly) {
  Random random(1, "exact");
  for (const auto& [height_m, tilt_deg, roll_deg] :
       {std::array{0.2, 22.0, 0.0}, {0.11, 18.0, 3.0}, {0.4, 50.0, -4.0}}) {
    const RobotConfig robot = robot_of(height_m, tilt_deg, roll_deg);
    const FloorSight sight = sight_of(robot, {}, random, 0);
    EXPECT_NEAR(sight.height_m, height_m, 1e-6);
    EXPECT_NEAR(deg(sight.tilt_rad), tilt_deg, 1e-4);
    EXPECT_NEAR(deg(sight.roll_rad), roll_deg, 1e-4);
    EXPECT_LT(sight.rms_px, 1e-4);
  }
}

TEST(FloorSight, AThickBoardIsTakenIntoAccount) {
  Random random(1, "thick");
  EXPECT_NEAR(sight_of(robot_of(0.2, 22), {}, random, 0, 0.012).height_m, 0.2, 1e-6);
}

TEST(FloorSight, ItsSigmaIsNoSmallerThanItsErrors) {
  const RobotConfig robot = robot_of(0.2, 22);
  Random random(4, "sigma");
  int height_inside = 0;
  int tilt_inside = 0;
  double sum_tilt = 0;
  constexpr int kTrials = 200;
  for (int i = 0; i < kTrials; ++i) {
    const FloorSight sight = sight_of(robot, {}, random, 0.3);
    height_inside += std::abs(sight.height_m - 0.2) <= 2 * sight.sigma_height_m;
    tilt_inside += std::abs(sight.tilt_rad - rad(22)) <= 2 * sight.sigma_tilt_rad;
    sum_tilt += sight.tilt_rad - rad(22);
  }
  EXPECT_GE(height_inside, 0.93 * kTrials);
  EXPECT_GE(tilt_inside, 0.93 * kTrials);
  EXPECT_LT(std::abs(deg(sum_tilt / kTrials)), 0.05);
}

TEST(FloorSight, LinesWhosePlaceIsKnownGiveHeightAndTilt) {
  const RobotConfig truth = robot_of(0.2, 22, 1);
  const RobotConfig told = robot_of(0.17, 26);
  const NeckAngles neck{rad(20), 0};
  const Eigen::Isometry3d X_CR = truth.X_RC(neck).inverse();
  std::vector<KnownLine> lines;
  for (const auto& [a, b] : {std::pair<Vector2d, Vector2d>{{0.5, 0.2}, {0.5, -0.1}},
                             {{0.9, 0.4}, {0.9, 0.0}},
                             {{0.4, 0.15}, {1.2, 0.3}}}) {
    KnownLine line;
    line.points_R_m = {a, b};
    // What is pointed at in the picture are other points of the same line.
    for (int i = 0; i < 2; ++i) {
      const Vector2d p = a + (0.2 + 0.5 * i) * (b - a);
      line.seen_px[static_cast<std::size_t>(i)] = *truth.camera.project(X_CR * Vector3d(p.x(), p.y(), 0));
    }
    lines.push_back(line);
  }
  // The lens's place over the floor is taken from the file: here it is the same.
  const auto sight = sight_from_lines(told, told.camera, neck, lines);
  ASSERT_TRUE(sight);
  EXPECT_NEAR(sight->height_m, 0.2, 1e-4);
  EXPECT_NEAR(deg(sight->tilt_rad), 22, 0.02);
  EXPECT_NEAR(deg(sight->roll_rad), 1, 0.02);
  lines.resize(1);
  EXPECT_FALSE(sight_from_lines(told, told.camera, neck, lines));
}

TEST(FloorSight, TheHorizonGivesTiltAndRoll) {
  const RobotConfig robot = robot_of(0.2, 12, 2);
  const Eigen::Matrix3d R_CR = robot.X_RC({}).linear().transpose();
  const auto left = robot.camera.project(R_CR * Vector3d(1, 0.4, 0));
  const auto right = robot.camera.project(R_CR * Vector3d(1, -0.4, 0));
  ASSERT_TRUE(left && right);
  const auto sight = sight_from_horizon(robot.camera, *left, *right);
  ASSERT_TRUE(sight);
  EXPECT_NEAR(deg(sight->tilt_rad), 12, 1e-6);
  EXPECT_NEAR(deg(sight->roll_rad), 2, 1e-6);
  EXPECT_TRUE(std::isnan(sight->height_m));
}

TEST(MeasuredMount, GoesBackThroughTheNeckItWasSeenWith) {
  RobotConfig truth = robot_of(0.06, 8, 1);
  truth.neck.p_PT_m = {0.01, 0, 0.15};
  truth.neck.tilt = {rad(-20), rad(40), 5};
  truth.mount.yaw_rad = rad(4);
  const NeckAngles neck{rad(10), rad(15)};
  Random random(1, "neck");
  const FloorSight sight = sight_of(truth, neck, random, 0);
  RobotConfig told = truth;
  told.mount.tilt_rad = rad(5);
  told.mount.roll_rad = 0;
  told.mount.p_TM_m.z() = 0.05;
  const MountConfig mount = measured_mount(told, neck, sight);
  EXPECT_NEAR(deg(mount.tilt_rad), 8, 1e-3);
  EXPECT_NEAR(deg(mount.roll_rad), 1, 1e-3);
  EXPECT_NEAR(mount.p_TM_m.z(), 0.06, 1e-5);
}

TEST(Doubt, AnUprightBoardAWrongSizeAndAFarBoardAreRefused) {
  const RobotConfig robot = robot_of(0.2, 22);
  Random random(2, "doubt");
  const FloorSight good = sight_of(robot, {}, random, 0.1);
  EXPECT_THAT(to_text(doubt(good, robot, {}), Lang::en), IsEmpty());

  FloorSight upright = good;
  upright.tilt_rad = rad(-65);
  EXPECT_THAT(to_text(doubt(upright, robot, {}), Lang::en), HasSubstr("Lay the board or tag on the floor"));

  FloorSight wrong_size = good;
  wrong_size.height_m *= 1.3;
  EXPECT_THAT(to_text(doubt(wrong_size, robot, {}), Lang::en), HasSubstr("Check the square or tag size"));

  const Seen far = board_on_floor(robot, {}, {3.5, 0, 0.4}, random, 0.3);
  const auto unsure = sight_from_points(robot.camera, far.px, far.m, 0, 0.3);
  ASSERT_TRUE(unsure);
  EXPECT_THAT(to_text(doubt(*unsure, robot, {}), Lang::en), HasSubstr("Too unsure"));
}

TEST(CheckMount, SaysWhenTheCameraHasBeenKnocked) {
  const RobotConfig told = robot_of(0.2, 22);
  Random random(2, "knock");
  EXPECT_EQ(check_mount(told, {}, sight_of(told, {}, random, 0.2)).verdict, MountCheck::Verdict::fine);

  const MountCheck tilted = check_mount(told, {}, sight_of(robot_of(0.2, 26), {}, random, 0.2));
  EXPECT_EQ(tilted.verdict, MountCheck::Verdict::knocked);
  EXPECT_NEAR(deg(tilted.tilt_off_rad), 4, 0.6);
  EXPECT_THAT(to_text(tilted.words, Lang::en), HasSubstr("it looks 2"));
  EXPECT_FALSE(has_errors(tilted.words));

  const MountCheck lifted = check_mount(told, {}, sight_of(robot_of(0.23, 22), {}, random, 0.2));
  EXPECT_EQ(lifted.verdict, MountCheck::Verdict::knocked);
  EXPECT_THAT(to_text(lifted.words, Lang::es), HasSubstr("cm de altura, no 20"));

  FloorSight vague = sight_of(told, {}, random, 0.2);
  vague.sigma_tilt_rad = rad(3);
  EXPECT_EQ(check_mount(told, {}, vague).verdict, MountCheck::Verdict::cannot_tell);
}

}  // namespace
}  // namespace mirada::vision
