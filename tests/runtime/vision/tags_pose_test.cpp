#include <cmath>
#include <cstdlib>

#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "base/units.h"
#include "vision/tags/tag_spotter.h"

namespace mirada::vision {
namespace {

RobotConfig sim_robot() {
  RobotConfig robot;
  robot.mount.p_TM_m = {0.05, 0, 0.2};
  robot.mount.tilt_rad = rad(22);
  return robot;
}

/// The printed tag as libapriltag itself draws it: one white cell round ten.
cv::Mat printed_tag(int id) {
  apriltag_family_t* family = tag36h11_create();
  image_u8_t* drawn = apriltag_to_image(family, static_cast<std::uint32_t>(id));
  cv::Mat out;
  cv::resize(
      cv::Mat(drawn->height, drawn->width, CV_8UC1, drawn->buf, static_cast<std::size_t>(drawn->stride)), out,
      {}, 40, 40, cv::INTER_NEAREST);
  std::free(drawn->buf);
  std::free(drawn);
  tag36h11_destroy(family);
  return out;
}

/// A picture of a tag standing at X_RT, with four samples a pixel each way.
Frame picture_of(const RobotConfig& robot, const NeckAngles& neck, int id, const Eigen::Isometry3d& X_RT,
                 double size_m) {
  const cv::Mat tag = printed_tag(id);
  const double paper_m = size_m * 10 / 8;  // the white cell round the black square
  const Eigen::Isometry3d X_CT = robot.X_RC(neck).inverse() * X_RT;
  std::vector<cv::Point2f> from, to;
  for (const auto& [x, y] : {std::pair{-1, 1}, {1, 1}, {1, -1}, {-1, -1}}) {
    const auto pixel = robot.camera.project(X_CT * Eigen::Vector3d(x * paper_m / 2, y * paper_m / 2, 0));
    EXPECT_TRUE(pixel);
    const auto edge = static_cast<float>(tag.cols);
    from.emplace_back((x + 1) / 2.0F * edge - 0.5F, (1 - y) / 2.0F * edge - 0.5F);
    to.emplace_back(static_cast<float>(4 * pixel->x() + 1.5), static_cast<float>(4 * pixel->y() + 1.5));
  }
  cv::Mat large;
  cv::warpPerspective(tag, large, cv::getPerspectiveTransform(from, to), {1280, 960}, cv::INTER_AREA,
                      cv::BORDER_CONSTANT, 170);
  cv::Mat gray;
  cv::resize(large, gray, {320, 240}, 0, 0, cv::INTER_AREA);
  Frame frame;
  cv::cvtColor(gray, frame.bgr, cv::COLOR_GRAY2BGR);
  frame.number = 1;
  return frame;
}

Eigen::Isometry3d standing(double x_m, double y_m, double z_m, double turned_deg) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translation() = Eigen::Vector3d(x_m, y_m, z_m);
  // Facing the robot: z out of the paper points to -x, y up.
  X.linear() << 0, 0, -1, -1, 0, 0, 0, 1, 0;
  X.rotate(Eigen::AngleAxisd(rad(turned_deg), Eigen::Vector3d::UnitY()));
  return X;
}

TEST(TagSpotter, FindsWhereAStandingTagIs) {
  const RobotConfig robot = sim_robot();
  TagSpotter spotter(robot, 0.08);
  for (const auto& [x_m, y_m, turned_deg, pan_deg] :
       {std::array{0.5, 0.1, 0.0, 0.0}, {0.6, -0.1, 30.0, 0.0}, {0.4, 0.3, -25.0, 35.0}}) {
    const NeckAngles neck{rad(pan_deg), 0};
    const Eigen::Isometry3d X_RT = standing(x_m, y_m, 0.1, turned_deg);
    const auto spots = spotter.look(picture_of(robot, neck, 17, X_RT, 0.08), neck);
    ASSERT_EQ(spots.size(), 1u);
    EXPECT_EQ(spots[0].id, 17);
    EXPECT_NEAR((spots[0].X_RT.translation() - X_RT.translation()).norm(), 0, 0.012);
    EXPECT_NEAR(spots[0].bearing_rad, std::atan2(y_m, x_m), rad(0.6));
    EXPECT_NEAR(spots[0].distance_m, std::hypot(x_m, y_m), 0.012);
    const Eigen::Matrix3d off = spots[0].X_RT.linear().transpose() * X_RT.linear();
    EXPECT_LT(deg(Eigen::AngleAxisd(off).angle()), 6) << "turned " << turned_deg;
  }
}

TEST(TagSpotter, ATagOnTheFloorLooksUp) {
  const RobotConfig robot = sim_robot();
  Eigen::Isometry3d X_RT = Eigen::Isometry3d::Identity();
  X_RT.translation() = Eigen::Vector3d(0.45, -0.05, 0);
  X_RT.linear() = Eigen::AngleAxisd(rad(70), Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const auto spots = TagSpotter(robot, 0.08).look(picture_of(robot, {}, 3, X_RT, 0.08), {});
  ASSERT_EQ(spots.size(), 1u);
  EXPECT_GT(spots[0].X_RT.linear()(2, 2), std::cos(rad(5)));
  EXPECT_NEAR(spots[0].X_RT.translation().z(), 0, 0.01);
  EXPECT_NEAR((spots[0].X_RT.translation() - X_RT.translation()).norm(), 0, 0.012);
}

TEST(TagSpotter, PicturesThatCannotShowTagsShowNone) {
  TagSpotter spotter(sim_robot(), 0.08);
  Frame frame;
  EXPECT_TRUE(spotter.look(frame, {}).empty());
  frame.bgr = cv::Mat(1, 1, CV_8UC3, cv::Scalar::all(0));
  EXPECT_TRUE(spotter.look(frame, {}).empty());
  frame.bgr = cv::Mat(300, 300, CV_8UC3, cv::Scalar::all(90));
  EXPECT_TRUE(spotter.look(frame, {}).empty());
  frame.bgr = cv::Mat(240, 320, CV_8UC3);
  cv::randu(frame.bgr, 0, 255);
  EXPECT_TRUE(spotter.look(frame, {}).empty());
}

}  // namespace
}  // namespace mirada::vision
