#include "vision/lines/line_finder.h"

#include <cmath>

#include <gtest/gtest.h>

#include "scene.h"

namespace mirada::vision {
namespace {

using Eigen::Vector2d;
using mirada::testing::Floor;
using mirada::testing::Light;
using mirada::testing::Scene;

/// Green, with white lines 5 cm wide: x = 0, y = 1.4 and -1.4, and a circle of 0.6 m about the middle.
Scene field(std::uint64_t seed, Light light = Light::even) {
  Scene scene;
  scene.floor = Floor::field;
  scene.light = light;
  scene.floor_colour = {0.06, 0.22, 0.05};
  scene.wall_colour = {0.3, 0.25, 0.2};
  scene.room_x_m = scene.room_y_m = 2.4;
  scene.seed = seed;
  return scene;
}

/// How far a place of the floor is from the nearest of the field's lines.
double from_lines_m(const Vector2d& p_m) {
  return std::min({std::abs(p_m.x()), std::abs(std::abs(p_m.y()) - 1.4), std::abs(p_m.norm() - 0.6)});
}

class LineFinderTest : public ::testing::Test {
 protected:
  std::vector<LineSeen> seen_from(const Scene& scene, const Pose2& X_WR, const NeckAngles& neck = {}) {
    Frame frame;
    frame.bgr = mirada::testing::render(scene, robot_, X_WR, neck);
    frame.number = 1;
    std::vector<LineSeen> lines = finder_.find(frame, neck);
    const Eigen::Rotation2Dd turn(X_WR.heading_rad);
    for (LineSeen& line : lines) {
      line.p_RA_m = Vector2d(X_WR.x_m, X_WR.y_m) + turn * line.p_RA_m;
      line.p_RB_m = Vector2d(X_WR.x_m, X_WR.y_m) + turn * line.p_RB_m;
    }
    return lines;
  }

  RobotConfig robot_ = *robot_by_name("mirada-sim");
  LineFinder finder_{robot_, 0.05, 0.05};
};

double length_m(const LineSeen& line) { return (line.p_RB_m - line.p_RA_m).norm(); }
Vector2d middle_m(const LineSeen& line) { return (line.p_RA_m + line.p_RB_m) / 2; }

TEST_F(LineFinderTest, finds_a_line_across_the_view_to_a_centimetre) {
  const auto lines = seen_from(field(1), {-0.9, 1.0, 0});
  double most_m = 0;
  for (const LineSeen& line : lines) {
    if (std::abs(middle_m(line).x()) > 0.1) continue;
    most_m = std::max(most_m, length_m(line));
    EXPECT_LT(std::abs(middle_m(line).x()), 0.012);
    EXPECT_LT(std::abs((line.p_RB_m - line.p_RA_m).x()), 0.03 * length_m(line));
  }
  EXPECT_GT(most_m, 0.5);
}

TEST_F(LineFinderTest, finds_a_line_that_runs_ahead_and_one_aslant) {
  for (const double heading_rad : {rad(0), rad(25), rad(50)}) {
    const auto lines = seen_from(field(2), {-1.6, 1.25 - 0.3 * std::sin(heading_rad), heading_rad});
    double most_m = 0;
    for (const LineSeen& line : lines) {
      if (std::abs(middle_m(line).y() - 1.4) < 0.1) most_m = std::max(most_m, length_m(line));
    }
    EXPECT_GT(most_m, 0.4) << deg(heading_rad);
  }
}

TEST_F(LineFinderTest, whatever_it_finds_lies_on_a_line) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    Random random(seed, "line finder test");
    Scene scene = field(seed, seed % 2 == 0 ? Light::shadow : Light::lamp);
    scene.boxes.push_back({0.9, -0.5, random.uniform(-3, 3), 0.24, 0.3, 0.4, {0.85, 0.85, 0.85}});
    scene.posts.push_back({-0.9, 0.6, 0.025, 0.5, {0.85, 0.85, 0.85}});
    const Pose2 X_WR{random.uniform(-1.6, -0.3), random.uniform(-1.2, 0.3), random.uniform(-3, 3)};
    const NeckAngles neck{random.uniform(-1, 1), 0};
    for (const LineSeen& line : seen_from(scene, X_WR, neck)) {
      ++found;
      // The camera is where it says, so pixels alone are left to err.
      const double may_m = 3 * line.across_sigma_m;
      EXPECT_LT(from_lines_m(middle_m(line)), may_m) << seed;
      EXPECT_LT(from_lines_m(line.p_RA_m), may_m + 0.02) << seed;
      EXPECT_LT(from_lines_m(line.p_RB_m), may_m + 0.02) << seed;
    }
  }
  EXPECT_GT(found, 30);
}

TEST_F(LineFinderTest, a_circle_is_found_in_pieces_that_lie_on_it) {
  int found = 0;
  for (const LineSeen& line : seen_from(field(5), {-1.15, 0, 0})) {
    if (std::abs(line.p_RA_m.norm() - 0.6) > 0.05 || middle_m(line).x() > -0.1) continue;
    ++found;
    EXPECT_NEAR(middle_m(line).norm(), 0.6, 0.02);
    EXPECT_LT(length_m(line), 0.5);
  }
  EXPECT_GE(found, 2);
}

TEST_F(LineFinderTest, a_tilt_that_is_badly_known_makes_a_line_ahead_uncertain) {
  RobotConfig exact = robot_;
  exact.mount.sigma_tilt_rad = exact.mount.sigma_height_m = exact.mount.sigma_pan_rad = 0;
  LineFinder by_pixels(exact, 0.05, 0.05);
  Frame frame;
  frame.bgr = mirada::testing::render(field(6), robot_, {-0.8, 1.0, 0}, {});
  const auto with_mount = finder_.find(frame, {}), without = by_pixels.find(frame, {});
  ASSERT_FALSE(without.empty());
  ASSERT_EQ(with_mount.size(), without.size());
  const double height_m = robot_.X_RC({}).translation().z();
  const double ahead_m = middle_m(without.front()).x() - robot_.X_RC({}).translation().x();
  const double by_tilt_m = robot_.mount.sigma_tilt_rad * (ahead_m * ahead_m + height_m * height_m) / height_m;
  EXPECT_LT(without.front().across_sigma_m, 0.01);
  EXPECT_NEAR(with_mount.front().across_sigma_m, by_tilt_m, 0.3 * by_tilt_m);
}

TEST_F(LineFinderTest, a_band_of_another_width_is_no_line_that_is_looked_for) {
  LineFinder wide(robot_, 0.12, 0.12), narrow(robot_, 0.02, 0.02);
  Frame frame;
  frame.bgr = mirada::testing::render(field(3), robot_, {-0.7, 1.0, 0}, {});
  ASSERT_FALSE(finder_.find(frame, {}).empty());
  EXPECT_TRUE(wide.find(frame, {}).empty());
  EXPECT_TRUE(narrow.find(frame, {}).empty());
}

TEST_F(LineFinderTest, a_floor_without_lines_has_none) {
  for (const Floor floor : {Floor::plain, Floor::carpet, Floor::planks, Floor::tiles, Floor::terrazzo}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      Scene scene = mirada::testing::draw_scene(floor, Light::even, seed);
      scene.boxes.clear();
      scene.posts.clear();
      EXPECT_TRUE(seen_from(scene, {0, 0, 0.3 * static_cast<double>(seed)}).empty())
          << mirada::testing::kFloorNames[static_cast<std::size_t>(floor)] << " " << seed;
    }
  }
}

TEST_F(LineFinderTest, a_larger_picture_says_the_same_and_one_of_another_shape_nothing) {
  const Pose2 X_WR{-0.9, 1.0, 0};
  RobotConfig fine = robot_;
  fine.camera = robot_.camera.scaled_to(640, 480);
  Frame large;
  large.bgr = mirada::testing::render(field(4), fine, X_WR, {});
  const auto lines = finder_.find(large, {});
  ASSERT_FALSE(lines.empty());
  EXPECT_LT(std::abs(middle_m(lines.front()).x() - 0.9), 0.012);
  Frame odd;
  odd.bgr = cv::Mat(200, 320, CV_8UC3, cv::Scalar(90, 90, 90));
  EXPECT_TRUE(finder_.find(odd, {}).empty());
  EXPECT_TRUE(finder_.find({}, {}).empty());
}

}  // namespace
}  // namespace mirada::vision
