#include "rig/mount_watch.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "base/units.h"
#include "vision/ground_projection.h"
#include "vision/tags/tag_picture.h"

namespace mirada::rig {
namespace {

constexpr double kTag_m = 0.1;
constexpr double kAhead_m = 0.45;

/// The robot as its file says it is.
RobotConfig told() {
  RobotConfig robot;
  robot.mount.p_TM_m = {0.05, 0, 0.20};
  robot.mount.tilt_rad = rad(22);
  robot.check = CheckConfig{.tag_m = kTag_m};
  return robot;
}

/// What a robot that stands so sees of a sheet with a tag on the floor before it.
cv::Mat picture(const RobotConfig& robot, bool with_tag = true) {
  const CameraModel& camera = robot.camera;
  cv::Mat out(camera.height_px, camera.width_px, CV_8UC3, cv::Scalar(90, 100, 110));
  if (!with_tag) return out;
  const cv::Mat tag = vision::tag_picture(vision::TagFamily::april_36h11, 3);
  const vision::GroundProjection ground(robot, camera, {});
  constexpr int kCellsOfTag = 8;
  constexpr int kParts = 4;  // of a pixel, each way
  const double cell_m = kTag_m / kCellsOfTag;
  for (int v = 0; v < out.rows; ++v) {
    for (int u = 0; u < out.cols; ++u) {
      double sum = 0;
      for (int part = 0; part < kParts * kParts; ++part) {
        const Eigen::Vector2d pixel(u + (part % kParts + 0.5) / kParts - 0.5,
                                    v + (part / kParts + 0.5) / kParts - 0.5);
        const auto p_R_m = ground.floor_point(pixel);
        double light = 190;
        if (p_R_m) {
          const int row = static_cast<int>(std::floor((kAhead_m - p_R_m->x()) / cell_m + tag.rows / 2.0));
          const int column = static_cast<int>(std::floor(-p_R_m->y() / cell_m + tag.cols / 2.0));
          const bool on_tag = row >= 0 && column >= 0 && row < tag.rows && column < tag.cols;
          if (on_tag) light = tag.at<std::uint8_t>(row, column);
        }
        sum += light / (kParts * kParts);
      }
      out.at<cv::Vec3b>(v, u) = cv::Vec3b::all(cv::saturate_cast<std::uint8_t>(sum));
    }
  }
  return out;
}

/// Watches until it has an answer; the answer's names.
std::vector<std::string> verdict(MountWatch& watch, const cv::Mat& bgr) {
  for (std::uint64_t number = 1; number < 100 && watch.wants_pictures(); ++number)
    watch.look(Frame{bgr, static_cast<Micros>(number), number}, {});
  std::vector<std::string> out;
  for (const Fault& fault : watch.words()) out.emplace_back(fault.code());
  return out;
}

using Codes = std::vector<std::string>;

TEST(MountWatch, ACameraThatStandsAsTheFileSaysIsFine) {
  MountWatch watch(told(), false);
  EXPECT_EQ(verdict(watch, picture(told())), Codes{"mount_check_fine"});
}

TEST(MountWatch, ACameraThatWasKnockedIsSaid) {
  RobotConfig knocked = told();
  knocked.mount.tilt_rad = rad(25);
  MountWatch watch(told(), false);
  const Codes codes = verdict(watch, picture(knocked));
  ASSERT_EQ(codes.size(), 1u);
  EXPECT_EQ(codes[0], "mount_knocked_tilt");
}

TEST(MountWatch, WithoutATagItSaysThatItCouldNotLook) {
  MountWatch watch(told(), false);
  EXPECT_EQ(verdict(watch, picture(told(), false)), Codes{"mount_check_no_tag"});
}

TEST(MountWatch, AFileWithoutACheckAsksForNoPictures) {
  RobotConfig robot = told();
  robot.check.reset();
  EXPECT_FALSE(MountWatch(robot, false).wants_pictures());
  EXPECT_TRUE(MountWatch(robot, true).wants_pictures());
}

}  // namespace
}  // namespace mirada::rig
