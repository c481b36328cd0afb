#include "model/camera_file.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/files.h"
#include "model/camera_preset.h"
#include "model/robot_config.h"

namespace mirada {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr const char* kCamera = R"({"format": "mirada-camera", "version": 1, "name": "Mine",
  "width_px": 640, "height_px": 480, "hfov_deg": 62, "vfov_deg": 48.5, "fx_px": 532.9, "fy_px": 533.1,
  "cx_px": 342.4, "cy_px": 233.9, "lens": "brown", "distortion": [-0.28, 0.05, 0.001, -0.0001, 0.1],
  "calibration": {"rms_px": 0.18}})";

class CameraFile : public ::testing::Test {
 protected:
  CameraFile() {
    std::filesystem::create_directories(folder_);
    EXPECT_TRUE(write_file_atomically(folder_ / "camera.json", kCamera));
  }
  ~CameraFile() override { std::filesystem::remove_all(folder_); }

  Result<RobotConfig> robot_with(const std::string& camera, Faults* warnings = nullptr) const {
    return read_robot(R"({"camera": )" + camera + R"(, "mount": {"height_m": 0.2, "tilt_deg": 22}})",
                      (folder_ / "r.json").string(), warnings);
  }

  std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) /
      ("mirada-camera-" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(CameraFile, IsTakenIntoTheRobotAndScaledToItsPictures) {
  Faults warnings;
  const auto robot =
      robot_with(R"({"calibration": "camera.json", "width_px": 320, "height_px": 240})", &warnings);
  ASSERT_TRUE(robot) << to_text(robot.faults(), Lang::en);
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_EQ(robot->camera.width_px, 320);
  EXPECT_NEAR(robot->camera.fx_px, 532.9 / 2, 1e-9);
  EXPECT_NEAR(robot->camera.cx_px, 342.9 / 2 - 0.5, 1e-9);
  EXPECT_DOUBLE_EQ(robot->camera.distortion[0], -0.28);
  EXPECT_EQ(robot->camera.name, "Mine");
}

TEST_F(CameraFile, OfAnotherCameraOrShapeIsRefusedInOneSentenceEach) {
  const auto robot = robot_with(
      R"({"calibration": "camera.json", "name": "Other", "width_px": 320, "height_px": 180, "hfov_deg": 80, "fx_px": 265})");
  ASSERT_FALSE(robot);
  const std::string text = to_text(robot.faults(), Lang::en);
  EXPECT_EQ(robot.faults().size(), 4u) << text;
  EXPECT_THAT(text, HasSubstr("was made with the camera \"Mine\", but this robot has \"Other\""));
  EXPECT_THAT(text, HasSubstr("made with 640x480 pictures; 320x180 has another shape"));
  EXPECT_THAT(text, HasSubstr("sees 62 degrees, but hfov_deg is 80"));
  EXPECT_THAT(text, HasSubstr("/camera/fx_px is already in the calibration"));
}

TEST_F(CameraFile, ThatIsMissingOrBrokenSaysEverythingWithItsOwnName) {
  EXPECT_THAT(to_text(robot_with(R"({"calibration": "none.json"})").faults(), Lang::en),
              HasSubstr("There is no file"));
  ASSERT_TRUE(write_file_atomically(
      folder_ / "bad.json", R"({"format": "mirada-robot", "width_px": -1, "height_px": 480, "version": 2})"));
  const auto robot = robot_with(R"({"calibration": "bad.json", "fps": 0})");
  ASSERT_FALSE(robot);
  const std::string text = to_text(robot.faults(), Lang::en);
  for (const char* part :
       {"bad.json/format", "bad.json/width_px", "bad.json/version", "bad.json/fx_px", "r.json/camera/fps"}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
}

TEST(CameraPreset, EveryOneThatShipsIsWhole) {
  const auto ids = shipped_cameras();
  EXPECT_GE(ids.size(), 5u);
  for (const std::string& id : ids) {
    const auto preset = camera_preset(id);
    ASSERT_TRUE(preset) << to_text(preset.faults(), Lang::en);
    EXPECT_FALSE(preset->modes.empty()) << id;
  }
  EXPECT_THAT(to_text(camera_preset("pi-camera-v9").faults(), Lang::en), HasSubstr("pi-camera-v2"));
}

TEST(CameraPreset, TellsThePapersCameraFromTheOneInItsTable) {
  const auto v1 = camera_preset("pi-camera-v1");
  const auto v2 = camera_preset("pi-camera-v2");
  ASSERT_TRUE(v1 && v2);
  const double paper_rad = rad(54.0);
  EXPECT_TRUE(v1->agrees(*v1->nearest_mode(320, 240, paper_rad), paper_rad));
  EXPECT_FALSE(v2->agrees(*v2->nearest_mode(320, 240, paper_rad), paper_rad));
  EXPECT_TRUE(v2->agrees(*v2->nearest_mode(320, 240, rad(62.9)), rad(62.9)));
  EXPECT_EQ(v2->nearest_mode(300, 300, paper_rad), nullptr);
}

}  // namespace
}  // namespace mirada
