#include "vision/floor_lights.h"

#include <gtest/gtest.h>

#include "scene.h"
#include "vision/visual_sonar.h"

namespace mirada::vision {
namespace {

const Look kLit{170, 126, 122};
const Look kShaded{122, 126, 122};

TEST(FloorLights, ALightBesideAKnownOneIsKnown) {
  FloorLights lights;
  lights.start(kShaded);
  EXPECT_FALSE(lights.of(kLit));
  lights.see(kLit);
  ASSERT_TRUE(lights.of(kLit));
  EXPECT_EQ(lights.of(kLit)->light, kLit.light);
  EXPECT_EQ(lights.brightest(), kLit.light);
  EXPECT_TRUE(lights.is_change(kShaded, kLit));
  EXPECT_TRUE(lights.is_change(kLit, kShaded));
  EXPECT_FALSE(lights.is_change(kLit, kLit));
  lights.forget();
  EXPECT_FALSE(lights.of(kShaded));
}

TEST(FloorLights, AnotherColourOrMoreThanAThirdOfTheLightIsNoLightOfTheFloor) {
  FloorLights lights;
  lights.start(kShaded);
  lights.see({170, 134, 114});
  EXPECT_FALSE(lights.of({170, 134, 114}));
  lights.see({kShaded.light + 90, 126, 122});
  EXPECT_FALSE(lights.of({kShaded.light + 90, 126, 122}));
}

TEST(FloorLights, AGlossThatWhitensAClearColourIsTheSameFloor) {
  const Look wood{156, 150, 103};
  FloorLights lights;
  lights.start(wood);
  lights.see({178, 144, 110});
  EXPECT_TRUE(lights.of({178, 144, 110}));
  lights.see({178, 110, 140});
  EXPECT_FALSE(lights.of({178, 110, 140}));
}

/// A wall in hardly another colour than the floor's, in much noise: no cell tells it, the mean of many does.
TEST(FloorTones, AWallInNearlyTheFloorsColourEndsTheFloor) {
  RobotConfig robot;
  robot.mount.p_TM_m = {0.05, 0, 0.20};
  robot.mount.tilt_rad = rad(22);
  testing::Scene scene;
  scene.floor_colour = {0.037, 0.0446, 0.0547};
  scene.wall_colour = {0.0446, 0.0478, 0.043};
  scene.room_x_m = scene.room_y_m = 1;
  scene.noise = 3;
  VisualSonar sonar(robot);
  int wrong = 0;
  for (std::uint64_t number = 1; number <= 3; ++number) {
    scene.seed = number;
    const Pose2 X_WR{0.1 * static_cast<double>(number), 0, 0};
    const Frame frame{testing::render(scene, robot, X_WR, {}), static_cast<Micros>(number), number};
    for (const SonarReading& reading : sonar.look(frame, {}, X_WR).readings) {
      if (std::abs(reading.bearing_rad) > rad(25)) continue;
      const double truth_m = testing::true_distance_m(scene, X_WR, reading.bearing_rad);
      wrong += reading.answer != Answer::blocked || reading.distance_m > 1.1 * truth_m;
    }
  }
  EXPECT_LE(wrong, 3);
}

}  // namespace
}  // namespace mirada::vision
