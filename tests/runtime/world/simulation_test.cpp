#include "world/simulation.h"

#include <cmath>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "rooms_for_tests.h"
#include "world/devices.h"

namespace mirada::world {
namespace {

constexpr Micros kStep = 10 * kMillisecond;

RobotConfig robot() { return robot_by_name("mirada-sim").value(); }

void run(Simulation& simulation, double t_s) {
  for (Micros t = 0; t < micros(t_s); t += kStep) simulation.step(kStep);
}

TEST(Simulation, OpeningStopsTheWheels) {
  Simulation simulation(quiet_room(), robot(), 1);
  run(simulation, 1);
  EXPECT_EQ(simulation.truth().path_m, 0);
  EXPECT_EQ(simulation.drive().odometry().speed.left_mps, 0);
}

TEST(Simulation, DrivesAsFarAsSpeedTimesTime) {
  Simulation simulation(quiet_room(), robot(), 1);
  simulation.drive().set({0.2, 0.2});
  run(simulation, 5);
  // 0.2 s of acceleration at 1 m/s2 lose 0.02 m.
  EXPECT_NEAR(simulation.truth().X_WR.x_m, 0.98, 1e-9);
  EXPECT_NEAR(simulation.drive().odometry().X_OR.x_m, 0.98, 1e-9);
  EXPECT_NEAR(simulation.truth().path_m, 0.98, 1e-9);
}

TEST(Simulation, TurnsLeftWhenTheRightWheelIsFaster) {
  Simulation simulation(quiet_room(), robot(), 1);
  simulation.drive().set({-0.1, 0.1});
  run(simulation, 1);
  EXPECT_NEAR(simulation.truth().X_WR.heading_rad, (0.1 - 0.005) * 2 / robot().drive.track_m, 1e-6);
}

TEST(Simulation, NeverAcceleratesMoreThanTheRobotCan) {
  const RobotConfig r = robot();
  Simulation simulation(quiet_room(), r, 1);
  simulation.drive().set({10, -10});
  double before = 0;
  for (int i = 0; i < 100; ++i) {
    simulation.step(kStep);
    const double now = simulation.drive().odometry().speed.left_mps;
    EXPECT_LE(std::abs(now - before), r.drive.max_accel_mps2 * seconds(kStep) + 1e-9);
    EXPECT_LE(std::abs(now), r.drive.max_wheel_mps + 1e-9);
    before = now;
  }
}

TEST(Simulation, OdometryDriftsFromTheTruthAsTheRoomSays) {
  WorldConfig world = quiet_room();
  world.noise.wheel_scale = 0.01;
  world.noise.wheel_slip = 0.005;
  Simulation simulation(world, robot(), 3);
  simulation.drive().set({0.2, 0.2});
  run(simulation, 8);
  const Pose2 truth = simulation.truth().X_WR;
  const Pose2 odometry = simulation.drive().odometry().X_OR;
  const double drift = std::hypot(truth.x_m - odometry.x_m, truth.y_m - odometry.y_m);
  EXPECT_GT(drift, 0.001);
  EXPECT_LT(drift, 0.3);
}

TEST(Simulation, CannotPassAWallAndCountsOneContact) {
  Simulation simulation(quiet_room(), robot(), 1);
  simulation.drive().set({0.3, 0.3});
  run(simulation, 20);
  EXPECT_LE(simulation.truth().X_WR.x_m, 3 - 0.0999);
  EXPECT_TRUE(simulation.truth().touching);
  EXPECT_EQ(simulation.truth().contacts, 1);
}

TEST(Simulation, CountsAContactAgainOnlyAfterASecondFree) {
  Simulation simulation(quiet_room(), robot(), 1);
  simulation.drive().set({0.3, 0.3});
  run(simulation, 12);
  simulation.drive().set({-0.1, -0.1});
  run(simulation, 0.6);
  simulation.drive().set({0.3, 0.3});
  run(simulation, 2);
  EXPECT_EQ(simulation.truth().contacts, 1) << "free for less than a second";
  simulation.drive().set({-0.1, -0.1});
  run(simulation, 2);
  simulation.drive().set({0.3, 0.3});
  run(simulation, 3);
  EXPECT_EQ(simulation.truth().contacts, 2);
}

TEST(Simulation, BoxesCylindersAndPeopleStopTheRobot) {
  for (int kind = 0; kind < 3; ++kind) {
    WorldConfig world = quiet_room();
    if (kind == 0) world.boxes.push_back({{1, 0, 0.3}, 0.3, 0.3, 0.3});
    if (kind == 1) world.cylinders.push_back({{1, 0.03}, 0.1, 0.4});
    if (kind == 2) world.people.emplace_back().X_WP = {1, -0.02, 0};
    Simulation simulation(world, robot(), 1);
    simulation.drive().set({0.2, 0.2});
    run(simulation, 4.4);
    EXPECT_EQ(simulation.truth().contacts, 1) << kind;
    EXPECT_LT(simulation.truth().X_WR.x_m, 0.85) << kind;
  }
}

TEST(Simulation, CountsALineCrossedByMoreThanThirtyMillimetres) {
  WorldConfig world = quiet_room();
  world.lines.push_back({{{0.5, -1}, {0.5, 1}}, 0.05, {255, 255, 255}});
  Simulation simulation(world, robot(), 1);
  simulation.drive().set({0.2, 0.2});
  while (simulation.truth().X_WR.x_m + 0.1 < 0.5 + 0.025 + 0.028) simulation.step(kStep);
  EXPECT_EQ(simulation.truth().line_crossings, 0);
  run(simulation, 0.2);
  EXPECT_EQ(simulation.truth().line_crossings, 1);
  run(simulation, 4);
  EXPECT_EQ(simulation.truth().line_crossings, 1);
}

TEST(Simulation, GivesTheSameBitsForTheSameSeed) {
  const WorldConfig world = world_by_name("workshop").value();
  Simulation a(world, robot(), 9), b(world, robot(), 9), c(world, robot(), 10);
  for (Simulation* s : {&a, &b, &c}) {
    s->camera().enable(true);
    s->drive().set({0.12, 0.1});
  }
  for (int i = 0; i < 300; ++i) {
    for (Simulation* s : {&a, &b, &c}) s->step(kStep);
    const auto one = a.camera().poll();
    const auto two = b.camera().poll();
    ASSERT_EQ(one.has_value(), two.has_value());
    if (one) {
      ASSERT_EQ(cv::norm(one->bgr, two->bgr, cv::NORM_INF), 0);
    }
  }
  EXPECT_EQ(a.truth().X_WR.x_m, b.truth().X_WR.x_m);
  EXPECT_EQ(a.truth().X_WR.heading_rad, b.truth().X_WR.heading_rad);
  EXPECT_NE(a.truth().X_WR.x_m, c.truth().X_WR.x_m);
}

TEST(Simulation, MovesTheSameWithAndWithoutItsCamera) {
  const WorldConfig world = world_by_name("sala-1").value();
  Simulation a(world, robot(), 9), b(world, robot(), 9);
  a.camera().enable(true);
  a.drive().set({0.12, 0.1});
  b.drive().set({0.12, 0.1});
  run(a, 3);
  run(b, 3);
  EXPECT_EQ(a.truth().X_WR.y_m, b.truth().X_WR.y_m);
}

TEST(Simulation, PutsTheRobotBackAndRepeatsItself) {
  Simulation simulation(world_by_name("sala-1").value(), robot(), 4);
  const Pose2 start = simulation.truth().X_WR;
  simulation.drive().set({0.1, 0.12});
  run(simulation, 2);
  const Pose2 first = simulation.truth().X_WR;
  const Micros before = simulation.now();
  simulation.put_back();
  EXPECT_EQ(simulation.truth().X_WR.x_m, start.x_m);
  EXPECT_EQ(simulation.truth().path_m, 0);
  EXPECT_EQ(simulation.now(), before) << "the robot's clock never goes back";
  run(simulation, 1);
  EXPECT_EQ(simulation.truth().X_WR.x_m, start.x_m) << "the wheels stand still";
  simulation.drive().set({0.1, 0.12});
  run(simulation, 2);
  EXPECT_EQ(simulation.truth().X_WR.x_m, first.x_m);
}

TEST(Simulation, TheNeckTakesItsTime) {
  const RobotConfig r = robot();
  Simulation simulation(quiet_room(), r, 1);
  simulation.neck().aim({rad(60), 0});
  EXPECT_FALSE(simulation.neck().state().settled);
  simulation.step(100 * kMillisecond);
  EXPECT_NEAR(simulation.neck().state().angles.pan_rad, 0.1 * r.neck.pan.max_radps, 1e-9);
  simulation.step(kSecond);
  EXPECT_TRUE(simulation.neck().state().settled);
  simulation.neck().aim({rad(170), 0});
  simulation.step(kSecond);
  EXPECT_DOUBLE_EQ(simulation.neck().state().angles.pan_rad, r.neck.pan.max_rad);
}

TEST(Simulation, PeopleWalkTheirPathAndWaitForTheRobot) {
  WorldConfig world = quiet_room();
  PersonConfig person;
  person.X_WP = {-1, 0, 0};
  person.path_m = {{2, 0}, {-2, 0}};
  world.people.push_back(person);
  Simulation simulation(world, robot(), 1);
  run(simulation, 10);
  const auto scene = nlohmann::json::parse(simulation.scene_json());
  const double x = scene["people"][0]["x_m"];
  EXPECT_GT(x, -0.9);
  EXPECT_LT(x, -0.3) << "waits before the robot";
  EXPECT_EQ(simulation.truth().contacts, 0);
}

TEST(Simulation, SceneHoldsWhatTheProtocolSays) {
  Simulation simulation(world_by_name("sala-1").value(), robot(), 1);
  const auto scene = nlohmann::json::parse(simulation.scene_json());
  for (const char* field : {"bounds", "floor_colour", "lines", "walls", "boxes", "cylinders", "people",
                            "robot", "contacts", "path_m"}) {
    EXPECT_TRUE(scene.contains(field)) << field;
  }
  for (const char* field : {"x_m", "y_m", "heading_deg", "footprint", "pan_deg", "hfov_deg", "contact"}) {
    EXPECT_TRUE(scene["robot"].contains(field)) << field;
  }
  EXPECT_NEAR(scene["robot"]["hfov_deg"], 62.2, 0.1);
}

TEST(SimDrive, AnOlderSetNeverOvertakesAStop) {
  SimDrive drive(1);
  std::atomic<bool> go{true};
  std::thread setter([&] {
    while (go) drive.set({0.3, 0.3});
  });
  for (int i = 0; i < 1000; ++i) drive.stop();
  go = false;
  setter.join();
  drive.stop();
  EXPECT_EQ(drive.command().left_mps, 0);
  drive.set({0.3, -0.2});
  EXPECT_NEAR(drive.command().left_mps, 0.3, 1e-6);
  EXPECT_NEAR(drive.command().right_mps, -0.2, 1e-6);
}

TEST(SimDrive, TakesNoNonsense) {
  SimDrive drive(0.3);
  drive.set({std::nan(""), 99});
  EXPECT_EQ(drive.command().left_mps, 0);
  EXPECT_NEAR(drive.command().right_mps, 0.3, 1e-6);
}

}  // namespace
}  // namespace mirada::world
