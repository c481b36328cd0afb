#include "vision/ground_projection.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/random.h"

namespace mirada::vision {
namespace {

RobotConfig robot_with(double distortion_k1) {
  RobotConfig robot;
  robot.camera.distortion[0] = distortion_k1;
  robot.neck.p_RN_m = {0.02, -0.01, 0};
  robot.mount.p_TM_m = {0.05, 0.01, 0.20};
  robot.mount.tilt_rad = rad(22);
  robot.mount.yaw_rad = rad(2);
  robot.mount.roll_rad = rad(-1.5);
  return robot;
}

TEST(GroundProjection, PixelIsTheExactInverseOfFloorPoint) {
  Random random(5, "ground");
  for (int i = 0; i < 1000; ++i) {
    const RobotConfig robot = robot_with(random.uniform(-0.2, 0.2));
    const GroundProjection ground(robot, robot.camera, {random.uniform(-1.4, 1.4), 0});
    const Eigen::Vector2d pixel(random.uniform(0, 319), random.uniform(60, 239));
    const auto p = ground.floor_point(pixel);
    ASSERT_TRUE(p);
    const auto back = ground.pixel(*p);
    ASSERT_TRUE(back);
    EXPECT_NEAR((*back - pixel).norm(), 0, 1e-6);
  }
}

TEST(GroundProjection, PanTurnsTheFloorAboutThePanAxis) {
  RobotConfig robot = robot_with(0);
  const GroundProjection ahead(robot, robot.camera, {0, 0});
  const GroundProjection left(robot, robot.camera, {rad(40), 0});
  const Eigen::Vector2d axis = robot.neck.p_RN_m.head<2>();
  const Eigen::Rotation2Dd turn(rad(40));
  for (const double v : {80.0, 150.0, 239.0}) {
    const Eigen::Vector2d turned = axis + turn * (*ahead.floor_point({70, v}) - axis);
    EXPECT_NEAR((turned - *left.floor_point({70, v})).norm(), 0, 1e-9);
  }
}

TEST(GroundProjection, APictureTurnedByHalfATurnSeesTheSameFloorWithARolledCamera) {
  RobotConfig robot = robot_with(0);
  RobotConfig rolled = robot;
  rolled.mount.roll_rad += rad(180);
  rolled.camera.cx_px = 319 - robot.camera.cx_px;
  rolled.camera.cy_px = 239 - robot.camera.cy_px;
  const GroundProjection upright(robot, robot.camera, {});
  const GroundProjection turned(rolled, rolled.camera, {});
  const auto a = upright.floor_point({40, 200});
  const auto b = turned.floor_point({319 - 40, 239 - 200});
  ASSERT_TRUE(a && b);
  EXPECT_NEAR((*a - *b).norm(), 0, 1e-9);
}

TEST(GroundProjection, NothingAtOrAboveTheHorizon) {
  RobotConfig robot;
  robot.mount.p_TM_m.z() = 0.2;
  const GroundProjection level(robot, robot.camera, {});
  EXPECT_FALSE(level.floor_point({100, robot.camera.cy_px}));
  EXPECT_FALSE(level.floor_point({100, 50}));
  EXPECT_TRUE(level.floor_point({100, robot.camera.cy_px + 1}));
}

TEST(GroundSigma, FollowsTheFormulasAtOneMetre) {
  MountConfig mount;
  mount.sigma_tilt_rad = 0;
  mount.sigma_height_m = 0;
  // A camera 11 cm high, level: a pixel is 29 mm at 1 m, a degree 162 mm or more (vision facts, section 1.4).
  EXPECT_NEAR(ground_sigma_m(1, 0.11, 0, 317, 1, mount), 0.029, 0.001);
  mount.sigma_tilt_rad = rad(1);
  EXPECT_NEAR(ground_sigma_m(1, 0.11, 0, 317, 0, mount), 0.161, 0.002);
  mount.sigma_tilt_rad = 0;
  mount.sigma_height_m = 0.011;
  EXPECT_NEAR(ground_sigma_m(1, 0.11, 0, 317, 0, mount), 0.1, 1e-9);
}

}  // namespace
}  // namespace mirada::vision
