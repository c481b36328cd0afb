#include <cmath>

#include <gtest/gtest.h>

#include "base/random.h"
#include "model/geometry.h"
#include "model/robot_config.h"

namespace mirada {
namespace {

RobotConfig robot_20cm_high() {
  RobotConfig robot;
  robot.mount.p_TM_m = {0.05, 0, 0.20};
  robot.mount.tilt_rad = rad(22);
  return robot;
}

/// Where the optical axis meets the floor, in the robot's frame.
Eigen::Vector2d axis_on_floor(const RobotConfig& robot, const NeckAngles& neck) {
  const Eigen::Isometry3d X_RC = robot.X_RC(neck);
  const Eigen::Vector3d eye = X_RC.translation();
  const Eigen::Vector3d axis = X_RC.linear().col(2);
  return (eye - axis * (eye.z() / axis.z())).head<2>();
}

TEST(PoseChain, TheAxisOfATiltedCameraMeetsTheFloorWhereTrigonometrySays) {
  const RobotConfig robot = robot_20cm_high();
  const Eigen::Vector2d p = axis_on_floor(robot, {});
  EXPECT_NEAR(p.x(), 0.05 + 0.20 / std::tan(rad(22)), 1e-12);
  EXPECT_NEAR(p.y(), 0, 1e-12);
}

TEST(PoseChain, PanTurnsTheLensAboutTheAxisToTheLeft) {
  const RobotConfig robot = robot_20cm_high();
  const Eigen::Vector3d eye = robot.X_RC({rad(90), 0}).translation();
  EXPECT_NEAR((eye - Eigen::Vector3d(0, 0.05, 0.20)).norm(), 0, 1e-12);
  const Eigen::Vector2d p = axis_on_floor(robot, {rad(90), 0});
  EXPECT_NEAR(p.x(), 0, 1e-12);
  EXPECT_GT(p.y(), 0.5);
}

TEST(PoseChain, ImageAxesPointRightAndDown) {
  RobotConfig robot = robot_20cm_high();
  robot.mount.tilt_rad = 0;
  const Eigen::Matrix3d R_RC = robot.X_RC({}).linear();
  EXPECT_NEAR((R_RC.col(0) - Eigen::Vector3d(0, -1, 0)).norm(), 0, 1e-12);
  EXPECT_NEAR((R_RC.col(1) - Eigen::Vector3d(0, 0, -1)).norm(), 0, 1e-12);
  EXPECT_NEAR((R_RC.col(2) - Eigen::Vector3d(1, 0, 0)).norm(), 0, 1e-12);
}

TEST(PoseChain, EachFixedAngleHasItsSign) {
  RobotConfig robot;
  robot.mount.yaw_rad = rad(10);
  EXPECT_GT(robot.X_RC({}).linear()(1, 2), 0);  // looks to the left
  robot.mount.yaw_rad = 0;
  robot.mount.roll_rad = rad(10);
  EXPECT_LT(robot.X_RC({}).linear()(2, 0), 0);  // clockwise seen from behind: its right side goes down
  robot.mount.roll_rad = 0;
  EXPECT_LT(robot.X_RC({0, rad(10)}).linear()(2, 2), 0);  // the neck's tilt is positive down
}

TEST(PoseChain, NeckTiltAndMountTiltAddWhenTheirAxesAreParallel) {
  RobotConfig robot = robot_20cm_high();
  const Eigen::Matrix3d both = robot.X_RC({0.3, rad(8)}).linear();
  robot.mount.tilt_rad = rad(30);
  EXPECT_TRUE(both.isApprox(robot.X_RC({0.3, 0}).linear(), 1e-12));
}

TEST(PoseChain, AlwaysARotation) {
  Random random(3, "chain");
  for (int i = 0; i < 500; ++i) {
    RobotConfig robot;
    robot.neck.p_RN_m = Eigen::Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform());
    robot.mount.yaw_rad = random.uniform(-3, 3);
    robot.mount.tilt_rad = random.uniform(-1.5, 1.5);
    robot.mount.roll_rad = random.uniform(-3, 3);
    const Eigen::Matrix3d R = robot.X_RC({random.uniform(-3, 3), random.uniform(-1, 1)}).linear();
    EXPECT_TRUE((R * R.transpose()).isApprox(Eigen::Matrix3d::Identity(), 1e-12));
    EXPECT_NEAR(R.determinant(), 1, 1e-12);
  }
}

TEST(Pose2, InverseUndoesAndComposeIsAssociative) {
  Random random(4, "pose");
  const auto draw = [&] {
    return Pose2{random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-3, 3)};
  };
  const auto expect_same = [](const Pose2& a, const Pose2& b) {
    EXPECT_NEAR(a.x_m, b.x_m, 1e-12);
    EXPECT_NEAR(a.y_m, b.y_m, 1e-12);
    EXPECT_NEAR(wrap_rad(a.heading_rad - b.heading_rad), 0, 1e-12);
  };
  for (int i = 0; i < 200; ++i) {
    const Pose2 A = draw(), B = draw(), C = draw();
    expect_same(compose(A, inverse(A)), {});
    expect_same(compose(compose(A, B), C), compose(A, compose(B, C)));
  }
  const Pose2 turned = compose({1, 2, rad(90)}, {1, 0, 0});
  EXPECT_NEAR(turned.x_m, 1, 1e-12);
  EXPECT_NEAR(turned.y_m, 3, 1e-12);
}

}  // namespace
}  // namespace mirada
