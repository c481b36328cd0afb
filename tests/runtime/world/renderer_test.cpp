#include "world/render/renderer.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/objdetect.hpp>

#include "base/random.h"
#include "rooms_for_tests.h"
#include "world/simulation.h"

namespace mirada::world {
namespace {

RobotConfig robot() { return robot_by_name("mirada-sim").value(); }

Eigen::Isometry3d at_origin(const RobotConfig& r, double pan_deg = 0) { return r.X_RC({rad(pan_deg), 0}); }

/// Where a column's brightness changes from the floor's to the box's, to a part of a pixel: the dark share of
/// the pixels from `top` to `bottom` is counted, which is exact for an area-filtered edge.
double edge_row(const cv::Mat& picture, int column, int top, int bottom) {
  const double above = picture.at<cv::Vec3b>(top, column)[1];
  const double below = picture.at<cv::Vec3b>(bottom, column)[1];
  double share_above = 0;
  for (int v = top; v <= bottom; ++v)
    share_above += (picture.at<cv::Vec3b>(v, column)[1] - below) / (above - below);
  return top + share_above - 0.5;
}

struct Case {
  const char* name;
  double k1, p1;
  double pan_deg;
};
class FootOfABox : public testing::TestWithParam<Case> {};

TEST_P(FootOfABox, AppearsWhereTheCameraModelSays) {
  RobotConfig r = robot();
  r.camera.distortion = {GetParam().k1, 0, GetParam().p1, 0, 0};
  Random random(7, "boxes");
  for (int trial = 0; trial < 5; ++trial) {
    WorldConfig world = quiet_room();
    const double distance_m = random.uniform(0.4, 1.8);
    const double pan_rad = rad(GetParam().pan_deg);
    BoxConfig box;
    box.X_WB = {(distance_m + 0.1) * std::cos(pan_rad), (distance_m + 0.1) * std::sin(pan_rad), pan_rad};
    box.length_m = 0.2;
    box.width_m = 0.5;
    box.height_m = 0.5;
    box.look = BoxLook::plain;
    box.colour = {250, 250, 250};
    world.boxes.push_back(box);
    Renderer renderer(world, r.camera, 1);
    const Eigen::Isometry3d X_WC = at_origin(r, GetParam().pan_deg);
    const cv::Mat picture = renderer.render(X_WC, {}, 1);
    for (const double across_m : {-0.1, 0.0, 0.1}) {
      const Eigen::Vector3d foot_W(distance_m * std::cos(pan_rad) - across_m * std::sin(pan_rad),
                                   distance_m * std::sin(pan_rad) + across_m * std::cos(pan_rad), 0);
      const auto pixel = r.camera.project(X_WC.inverse() * foot_W);
      ASSERT_TRUE(pixel);
      const int column = static_cast<int>(std::lround(pixel->x()));
      const int row = static_cast<int>(std::lround(pixel->y()));
      const double seen = edge_row(picture, column, row - 2, row + 2);
      EXPECT_NEAR(seen, pixel->y(), 0.25) << distance_m << " m, " << across_m << " m across";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Lenses, FootOfABox,
                         testing::Values(Case{"pinhole", 0, 0, 0}, Case{"barrel", -0.25, 0, 0},
                                         Case{"crooked", 0.12, 0.01, 0}, Case{"panned", -0.1, 0, 50}),
                         [](const auto& lens) { return lens.param.name; });

TEST(Renderer, PutsACylindersFootWhereTheModelSays) {
  const RobotConfig r = robot();
  WorldConfig world = quiet_room();
  world.cylinders.push_back({{1.2, 0.0}, 0.1, 0.5, CylinderLook::plain, {250, 250, 250}});
  Renderer renderer(world, r.camera, 1);
  const Eigen::Isometry3d X_WC = at_origin(r);
  const auto pixel = r.camera.project(X_WC.inverse() * Eigen::Vector3d(1.1, 0, 0));
  const cv::Mat picture = renderer.render(X_WC, {}, 1);
  const int row = static_cast<int>(std::lround(pixel->y()));
  EXPECT_NEAR(edge_row(picture, 160, row - 2, row + 2), pixel->y(), 0.25);
}

TEST(Renderer, ShowsALineOnTheFloorWhereTheModelSays) {
  const RobotConfig r = robot();
  WorldConfig world = quiet_room();
  world.lines.push_back({{{1.0, -1}, {1.0, 1}}, 0.06, {255, 255, 255}});
  Renderer renderer(world, r.camera, 1);
  const Eigen::Isometry3d X_WC = at_origin(r);
  const cv::Mat picture = renderer.render(X_WC, {}, 1);
  const double near_row = r.camera.project(X_WC.inverse() * Eigen::Vector3d(0.97, 0, 0))->y();
  const double far_row = r.camera.project(X_WC.inverse() * Eigen::Vector3d(1.03, 0, 0))->y();
  double weight = 0, centre = 0;
  const int from = static_cast<int>(far_row) - 4;
  const int to = static_cast<int>(near_row) + 5;
  const double floor = picture.at<cv::Vec3b>(to + 2, 160)[1];
  for (int v = from; v <= to; ++v) {
    const double light = picture.at<cv::Vec3b>(v, 160)[1] - floor;
    weight += light;
    centre += light * v;
  }
  EXPECT_NEAR(centre / weight, (near_row + far_row) / 2, 0.3);
}

TEST(Renderer, GivesTheSameBitsAgainAndOtherNoiseForAnotherPicture) {
  const RobotConfig r = robot();
  const WorldConfig world = world_by_name("sala-1").value();
  std::vector<Pose2> people;
  for (const PersonConfig& person : world.people) people.push_back(person.X_WP);
  Renderer one(world, r.camera, 5), two(world, r.camera, 5);
  const cv::Mat a = one.render(at_origin(r), people, 100);
  const cv::Mat b = two.render(at_origin(r), people, 100);
  const cv::Mat c = two.render(at_origin(r), people, 200);
  EXPECT_EQ(cv::norm(a, b, cv::NORM_INF), 0);
  EXPECT_GT(cv::norm(b, c, cv::NORM_INF), 0);
}

bool face_found(cv::CascadeClassifier& cascade, const cv::Mat& picture, const Eigen::Vector2d& middle) {
  cv::Mat grey;
  cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
  std::vector<cv::Rect> found;
  cascade.detectMultiScale(grey, found, 1.1, 3, 0, {24, 24});
  return std::any_of(found.begin(), found.end(), [&](const cv::Rect& box) {
    return box.contains(cv::Point(static_cast<int>(middle.x()), static_cast<int>(middle.y())));
  });
}

/// A face must look like one to Debian's cascade, from 30 to 120 pixels wide and turned a little.
TEST(Renderer, PaintsFacesThatAreFound) {
  cv::CascadeClassifier cascade;
  const std::string file = "/usr/share/opencv4/haarcascades/haarcascade_frontalface_alt2.xml";
  if (!cascade.load(file)) GTEST_SKIP() << "no " << file;
  RobotConfig r = robot();
  r.mount.tilt_rad = 0;
  int seen = 0, looked = 0;
  for (const Colour skin : {Colour{224, 180, 148}, Colour{201, 143, 106}, Colour{168, 116, 80}}) {
    WorldConfig world = quiet_room();
    world.noise.sensor = 2.5;
    PersonConfig person;
    person.height_m = 1.1;
    person.skin = skin;
    world.people.push_back(person);
    Renderer renderer(world, r.camera, 3);
    for (const double head_px : {30, 40, 60, 80, 100, 120}) {
      for (const double turned_deg : {180.0, 168.0, 192.0}) {
        Eigen::Isometry3d X_WC = at_origin(r);
        X_WC.translation().z() = 0.95;
        const Pose2 X_WP{X_WC.translation().x() + 0.19 * r.camera.fx_px / head_px, 0, rad(turned_deg)};
        const auto middle = r.camera.project(X_WC.inverse() * Eigen::Vector3d(X_WP.x_m, 0, 0.98));
        const bool found = face_found(cascade, renderer.render(X_WC, {X_WP}, looked), *middle);
        ++looked;
        seen += found;
        EXPECT_TRUE(found || turned_deg != 180) << head_px << " px, skin " << to_hex(skin);
      }
    }
  }
  EXPECT_GE(seen, looked * 9 / 10) << "of " << looked;
}

}  // namespace
}  // namespace mirada::world
