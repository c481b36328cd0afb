#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "world/simulation.h"

namespace mirada::world {
namespace {

/// Keeps a picture for people to look at, in the folder that MIRADA_GALLERY names; without that, nothing is
/// written.
void keep(const std::string& name, const cv::Mat& bgr) {
  const char* folder = std::getenv("MIRADA_GALLERY");
  if (!folder) return;
  std::filesystem::create_directories(folder);
  cv::imwrite((std::filesystem::path(folder) / name).string(), bgr);
}

TEST(Gallery, EveryRoomGivesALivelyPictureInEveryDirection) {
  const RobotConfig robot = robot_by_name("mirada-sim").value();
  for (const std::string& id : shipped_worlds()) {
    Simulation simulation(world_by_name(id).value(), robot, 1);
    simulation.camera().enable(true);
    for (const double pan_deg : {-70.0, -35.0, 0.0, 35.0, 70.0}) {
      simulation.neck().aim({rad(pan_deg), 0});
      simulation.step(kSecond);
      const std::optional<Frame> frame = simulation.camera().poll();
      ASSERT_TRUE(frame);
      cv::Scalar mean, spread;
      cv::meanStdDev(frame->bgr, mean, spread);
      EXPECT_GT(mean[1], 40) << id << pan_deg;
      EXPECT_LT(mean[1], 225) << id << pan_deg;
      EXPECT_GT(spread[1], 6) << id << pan_deg;
      keep(id + "_pan" + std::to_string(static_cast<int>(pan_deg)) + ".png", frame->bgr);
    }
  }
}

}  // namespace
}  // namespace mirada::world
