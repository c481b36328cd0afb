#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "model/angles.h"
#include "model/robot_config.h"

namespace mirada {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

constexpr const char* kMinimal = R"({
  "camera": {"hfov_deg": 62.2},
  "mount": {"forward_m": 0.05, "height_m": 0.20, "tilt_deg": 22}
})";

std::vector<std::string> places(const Faults& faults) {
  std::vector<std::string> out;
  std::transform(faults.begin(), faults.end(), std::back_inserter(out),
                 [](const Fault& f) { return f.place; });
  return out;
}

TEST(RobotReader, AHandfulOfLinesIsEnough) {
  Faults warnings;
  const auto robot = read_robot(kMinimal, "mine.json", &warnings);
  ASSERT_TRUE(robot) << to_text(robot.faults(), Lang::en);
  EXPECT_TRUE(warnings.empty());
  EXPECT_EQ(robot->id, "mine");
  EXPECT_EQ(robot->camera.width_px, 320);
  EXPECT_NEAR(robot->camera.fx_px, 265.2, 0.1);
  EXPECT_NEAR(robot->camera.cx_px, 159.5, 1e-12);
  const Eigen::Vector3d eye = robot->X_RC({rad(90), 0}).translation();
  EXPECT_NEAR((eye - Eigen::Vector3d(0, 0.05, 0.20)).norm(), 0, 1e-12);
  EXPECT_NEAR(deg(robot->mount.tilt_rad), 22, 1e-12);
}

TEST(RobotReader, EveryFaultComesAtOnceWithItsPlaceValueAndRange) {
  const auto robot = read_robot(R"({
      "version": 3, "footprint_m": [[0,0],[1,0],[0.5,0.1],[1,1],[0,1]],
      "drive": {"track_m": -1, "cruise_mps": 0.9},
      "camera": {"fx_px": -265, "width_px": 3, "cx_px": "middle", "lens": "round", "distortion": [1,2,3,4,5,6]},
      "neck": {"pan": {"min_deg": 80, "max_deg": -80}, "tilt": {"min_deg": -30}},
      "mount": {"height_m": -0.2}
    })",
                                "r.json");
  ASSERT_FALSE(robot);
  const auto found = places(robot.faults());
  for (const char* place :
       {"r.json/version", "r.json/footprint_m", "r.json/drive/track_m", "r.json/drive/cruise_mps",
        "r.json/camera/fx_px", "r.json/camera/width_px", "r.json/camera/cx_px", "r.json/camera/lens",
        "r.json/camera/distortion", "r.json/neck/pan/max_deg", "r.json/neck/tilt/height_m",
        "r.json/mount/height_m", "r.json/mount/tilt_deg"}) {
    EXPECT_THAT(found, Contains(place));
  }
  const std::string text = to_text(robot.faults(), Lang::en);
  EXPECT_THAT(text, HasSubstr("/camera/fx_px must be a number from 10 to 20000, not -265"));
}

TEST(RobotReader, LinesAreObstaclesOnlyWhenTheFileSaysSo) {
  const std::string rest = R"("camera": {"width_px": 320, "height_px": 240, "hfov_deg": 62.2},
                              "mount": {"height_m": 0.2, "tilt_deg": 22}})";
  EXPECT_FALSE(read_robot("{" + rest, "robot.json", nullptr).value().lines_are_obstacles);
  EXPECT_TRUE(read_robot(R"({"lines_are_obstacles": true, )" + rest, "robot.json", nullptr)
                  .value()
                  .lines_are_obstacles);
}

TEST(RobotReader, AFocalLengthAndAViewThatDisagreeAreRefused) {
  const auto robot = read_robot(R"({"camera": {"fx_px": 314, "hfov_deg": 62.2},
                                      "mount": {"height_m": 0.11, "tilt_deg": 3}})",
                                "r.json");
  ASSERT_FALSE(robot);
  EXPECT_EQ(robot.faults().front().code(), "camera_view_twice");
  EXPECT_THAT(robot.faults().front().text(Lang::en), HasSubstr("54"));
}

TEST(RobotReader, NeedsAViewAHeightAndATilt) {
  const auto robot = read_robot("{}", "r.json");
  ASSERT_FALSE(robot);
  EXPECT_THAT(
      places(robot.faults()),
      ::testing::ElementsAre("r.json/camera/hfov_deg", "r.json/mount/height_m", "r.json/mount/tilt_deg"));
}

TEST(RobotReader, ATypingErrorIsAWarning) {
  Faults warnings;
  const auto robot = read_robot(R"({"camera": {"hfov_deg": 60, "witdh_px": 640},
                                      "mount": {"height_m": 0.2, "tilt_deg": 22}})",
                                "r.json", &warnings);
  ASSERT_TRUE(robot);
  EXPECT_THAT(places(warnings), ::testing::ElementsAre("r.json/camera/witdh_px"));
}

TEST(RobotReader, ALensThatFoldsInsideThePictureIsRefused) {
  const auto robot = read_robot(R"({"camera": {"fx_px": 265, "distortion": [-0.9]},
                                      "mount": {"height_m": 0.2, "tilt_deg": 22}})",
                                "r.json");
  ASSERT_FALSE(robot);
  EXPECT_EQ(robot.faults().front().code(), "camera_distortion_folds");
}

TEST(RobotReader, HeightsAreAboveTheFloorWhateverTheChain) {
  const auto robot = read_robot(R"({"camera": {"hfov_deg": 60},
      "neck": {"forward_m": 0.03, "tilt": {"min_deg": -20, "max_deg": 40, "height_m": 0.15, "forward_m": 0.01}},
      "mount": {"forward_m": 0.02, "height_m": 0.18, "tilt_deg": 10}})",
                                "r.json");
  ASSERT_TRUE(robot) << to_text(robot.faults(), Lang::en);
  const Eigen::Vector3d eye = robot->X_RC({}).translation();
  EXPECT_NEAR((eye - Eigen::Vector3d(0.06, 0, 0.18)).norm(), 0, 1e-12);
}

TEST(RobotReader, ACameraThatTheNeckPutsUnderTheFloorIsRefused) {
  const auto robot = read_robot(R"({"camera": {"hfov_deg": 60},
      "neck": {"tilt": {"min_deg": 0, "max_deg": 90, "height_m": 0.1}},
      "mount": {"forward_m": 0.3, "height_m": 0.18, "tilt_deg": 10}})",
                                "r.json");
  ASSERT_FALSE(robot);
  EXPECT_EQ(robot.faults().front().code(), "camera_underground");
}

TEST(RobotReader, AClockwiseFootprintIsTurnedOver) {
  const auto robot = read_robot(R"({"footprint_m": [[0.1,0.1],[0.1,-0.1],[-0.1,-0.1],[-0.1,0.1]],
      "camera": {"hfov_deg": 60}, "mount": {"height_m": 0.2, "tilt_deg": 22}})",
                                "r.json");
  ASSERT_TRUE(robot);
  const auto& f = robot->footprint_R_m;
  EXPECT_GT((f[1] - f[0]).x() * (f[2] - f[1]).y() - (f[1] - f[0]).y() * (f[2] - f[1]).x(), 0);
  EXPECT_NEAR(robot->width_m(), 0.2, 1e-12);
}

TEST(RobotReader, AStarThatGoesRoundTwiceIsNoFootprint) {
  const auto robot =
      read_robot(R"({"footprint_m": [[0.1,0],[-0.08,0.06],[0.03,-0.095],[0.03,0.095],[-0.08,-0.06]],
      "camera": {"hfov_deg": 60}, "mount": {"height_m": 0.2, "tilt_deg": 22}})",
                 "r.json");
  ASSERT_FALSE(robot);
  EXPECT_EQ(robot.faults().front().code(), "footprint_not_convex");
}

TEST(RobotReader, WhatIsNoRobotFileSaysSo) {
  EXPECT_EQ(read_robot("[]", "r.json").faults().front().code(), "object_needed");
  EXPECT_EQ(read_robot("{\"camera\"", "r.json").faults().front().code(), "json_broken");
  EXPECT_EQ(read_robot(R"({"format": "mirada-world", "camera": {"hfov_deg": 60},
        "mount": {"height_m": 0.2, "tilt_deg": 22}})",
                       "r.json")
                .faults()
                .front()
                .code(),
            "robot_wrong_format");
}

TEST(RobotReader, IsNotHurtByValuesOfAnyDepth) {
  const std::string deep = std::string(200'000, '[') + std::string(200'000, ']');
  const auto robot = read_robot(
      R"({"format": )" + deep + R"(, "version": )" + deep + R"(, "footprint_m": )" + deep + "}", "r.json");
  ASSERT_FALSE(robot);
  EXPECT_THAT(to_text(robot.faults(), Lang::en), HasSubstr("[...]"));
}

TEST(ShippedRobots, AllReadWithoutAWarning) {
  const auto ids = shipped_robots();
  ASSERT_THAT(ids, Contains("mirada-sim"));
  ASSERT_THAT(ids, Contains("pibot"));
  for (const std::string& id : ids) {
    Faults warnings;
    const auto robot = robot_by_name(id, &warnings);
    ASSERT_TRUE(robot) << to_text(robot.faults(), Lang::en);
    EXPECT_TRUE(warnings.empty()) << to_text(warnings, Lang::en);
    EXPECT_EQ(robot->id, id);
  }
}

TEST(ShippedRobots, AnUnknownOneNamesTheKnown) {
  const auto robot = robot_by_name("zeppelin");
  ASSERT_FALSE(robot);
  EXPECT_THAT(robot.faults().front().text(Lang::es), HasSubstr("mirada-sim"));
  EXPECT_EQ(robot_by_name("no/such/robot.json").faults().front().code(), "file_missing");
}

TEST(Angles, AChildsRightIsOurNegative) {
  EXPECT_NEAR(bearing_from_block(90), -rad(90), 1e-12);
  EXPECT_NEAR(bearing_to_block(bearing_from_block(37)), 37, 1e-12);
  EXPECT_NEAR(tilt_from_block(10), -rad(10), 1e-12);
}

}  // namespace
}  // namespace mirada
