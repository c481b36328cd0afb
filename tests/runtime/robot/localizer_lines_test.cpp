#include <cmath>

#include <gtest/gtest.h>

#include "base/random.h"
#include "robot/line_match.h"
#include "robot/localizer.h"

namespace mirada::robot {
namespace {

using Eigen::Vector2d;

/// A field of 4 by 3 m with a line across its middle and a circle about it.
Place field() {
  Place place;
  const Vector2d corners[] = {{-2, -1.5}, {2, -1.5}, {2, 1.5}, {-2, 1.5}, {-2, -1.5}};
  for (int i = 0; i < 4; ++i) place.lines.push_back({corners[i], corners[i + 1]});
  place.lines.push_back({{0, -1.5}, {0, 1.5}});
  place.circles.push_back({{0, 0}, 0.5});
  place.X_PR_start = Pose2{};
  return place;
}

Vector2d seen_from(const Pose2& X_PR, const Vector2d& p_P_m) {
  return Eigen::Rotation2Dd(-X_PR.heading_rad) * (p_P_m - Vector2d(X_PR.x_m, X_PR.y_m));
}

LineSeen piece(const Pose2& X_PR, const Vector2d& p_PA_m, const Vector2d& p_PB_m) {
  return {seen_from(X_PR, p_PA_m), seen_from(X_PR, p_PB_m), 0.01, 0.01};
}

/// A robot that drives over the field; odometry turns too far with each metre.
class LocalizerLinesTest : public testing::Test {
 protected:
  void begin(const Pose2& X_PR) {
    place_.X_PR_start = truth_ = X_PR;
    localizer_.know(place_);
  }

  void drive(int steps, double bend_rad = 0.02) {
    for (int i = 0; i < steps; ++i) {
      truth_ = compose(truth_, {0.02, 0, bend_rad});
      X_OR_ = compose(X_OR_, {0.02 * 1.005, 0, bend_rad + 0.02 * 0.02});
      localizer_.moved(X_OR_);
      if (i % 3 == 0) look();
    }
  }

  /// What lies within 1.3 m and 30 degrees to both sides is seen, a little wrong.
  void look() {
    std::vector<LineSeen> seen;
    if (sees_lines_) {
      for (const PlaceLine& line : field_.lines) see_part_of(line, seen);
    }
    see(seen);
  }

  void see_part_of(const PlaceLine& line, std::vector<LineSeen>& out) {
    std::vector<Vector2d> points_m;
    const Vector2d way = line.p_PB_m - line.p_PA_m;
    for (double at_m = 0; at_m <= way.norm(); at_m += 0.02) {
      const Vector2d p_R_m = seen_from(truth_, line.p_PA_m + way.normalized() * at_m);
      const bool in_view = p_R_m.norm() < 1.3 && std::abs(std::atan2(p_R_m.y(), p_R_m.x())) < rad(30);
      if (in_view) points_m.push_back(p_R_m);
    }
    if (points_m.size() < 10) return;
    const Vector2d middle_m = (points_m.front() + points_m.back()) / 2;
    const Vector2d half_m = Eigen::Rotation2Dd(0.01 * random_.gaussian()) * (points_m.back() - middle_m);
    const Vector2d off_m = Vector2d(-half_m.y(), half_m.x()).normalized() * 0.01 * random_.gaussian();
    out.push_back({middle_m - half_m + off_m, middle_m + half_m + off_m, 0.01, 0.01});
  }

  void see(const std::vector<LineSeen>& lines) {
    LinesPercept percept;
    percept.frame = ++frame_;
    percept.X_OR = X_OR_;
    percept.lines = lines;
    localizer_.see(percept);
  }

  double off_m() const {
    const Pose2 believed = localizer_.estimate().X_PR;
    return std::hypot(believed.x_m - truth_.x_m, believed.y_m - truth_.y_m);
  }

  Random random_{5, "localizer lines test"};
  const Place field_ = field();
  Place place_ = field();
  Localizer localizer_{DriveConfig{}};
  Pose2 truth_, X_OR_;
  bool sees_lines_ = true;
  std::uint64_t frame_ = 0;
};

TEST_F(LocalizerLinesTest, lines_keep_it_where_the_wheels_alone_go_astray) {
  begin({-1.2, -0.6, 0});
  double worst_m = 0;
  for (int i = 0; i < 60; ++i) {
    drive(20);
    worst_m = std::max(worst_m, off_m());
    EXPECT_LT(off_m(), 3 * localizer_.estimate().sigma_m) << i;
  }
  EXPECT_LT(worst_m, 0.1);
  EXPECT_TRUE(localizer_.estimate().known);

  localizer_ = Localizer{DriveConfig{}};
  sees_lines_ = false;
  begin({-1.2, -0.6, 0});
  double astray_m = 0;
  for (int i = 0; i < 60; ++i) {
    drive(20);
    astray_m = std::max(astray_m, off_m());
  }
  EXPECT_GT(astray_m, 0.3);
}

TEST_F(LocalizerLinesTest, it_learns_how_unequal_wheels_turn_it_and_keeps_that_when_put_down_anew) {
  const auto heading_off_rad = [&] {
    return std::abs(wrap_rad(localizer_.estimate().X_PR.heading_rad - truth_.heading_rad));
  };
  sees_lines_ = false;
  begin({-1.2, -0.6, 0});
  drive(200);  // 4 m
  EXPECT_GT(heading_off_rad(), rad(4));
  const double unsure_rad = localizer_.estimate().sigma_rad;
  sees_lines_ = true;
  begin({-1.2, -0.6, 0});
  drive(600);
  sees_lines_ = false;
  begin({-1.2, -0.6, 0});
  drive(200);
  EXPECT_LT(heading_off_rad(), rad(1.5));
  EXPECT_LT(localizer_.estimate().sigma_rad, unsure_rad);
}

TEST_F(LocalizerLinesTest, a_line_tells_the_way_to_it_and_the_heading_but_nothing_along_it) {
  begin({1.2, 0.3, 0});
  truth_ = {1.16, 0.35, rad(4)};
  see({piece(truth_, {2, 0.1}, {2, 0.7})});
  const Localizer::Estimate at = localizer_.estimate();
  EXPECT_NEAR(at.X_PR.x_m, 1.16, 0.005);
  EXPECT_NEAR(at.X_PR.heading_rad, rad(4), rad(0.3));
  EXPECT_NEAR(at.X_PR.y_m, 0.3, 0.01);
  EXPECT_GT(at.sigma_m, 0.08);
  EXPECT_LT(at.sigma_rad, rad(1));
}

TEST_F(LocalizerLinesTest, an_arc_of_a_circle_corrects_towards_its_middle) {
  begin({-1.2, 0, 0});
  truth_ = {-1.15, 0, 0};
  // An arc of 0.2 m: the straight line through it lies 0.2^2 / 24 r inside of the circle.
  const double x_m = -0.5 + 0.2 * 0.2 / 24 / 0.5;
  see({piece(truth_, {x_m, -0.1}, {x_m, 0.1})});
  EXPECT_NEAR(localizer_.estimate().X_PR.x_m, -1.15, 0.003);
}

TEST_F(LocalizerLinesTest, looks_from_one_place_make_it_no_surer_than_one_of_them_can) {
  begin({1.2, 0.3, 0});
  for (int i = 0; i < 300; ++i) {
    LineSeen wrong = piece({1.22, 0.3, 0}, {2, 0}, {2, 0.6});
    wrong.across_sigma_m = 0.03;
    see({wrong});
  }
  // 2 cm wrong by a tilted camera, each time the same.
  EXPECT_NEAR(localizer_.estimate().X_PR.x_m, 1.22, 0.01);
  const LineSeen across = piece(truth_, {1.2, 1.5}, {1.8, 1.5});
  see({across});
  EXPECT_GT(localizer_.estimate().sigma_m, 0.02);
}

TEST_F(LocalizerLinesTest, lines_alone_never_give_a_pose) {
  place_.X_PR_start.reset();
  truth_ = {-1.2, -0.6, 0};
  localizer_.know(place_);
  drive(300);
  EXPECT_FALSE(localizer_.estimate().known);
}

TEST_F(LocalizerLinesTest, lines_too_near_each_other_to_be_told_apart_change_nothing) {
  place_.lines.push_back({{1.8, -1.5}, {1.8, 1.5}});
  begin({1.0, 0.3, 0});
  truth_ = {0.95, 0.3, 0};
  see({piece(truth_, {2, 0}, {2, 0.6})});
  EXPECT_DOUBLE_EQ(localizer_.estimate().X_PR.x_m, 1.0);
  EXPECT_TRUE(localizer_.estimate().known);
}

TEST_F(LocalizerLinesTest, a_piece_beyond_a_lines_end_is_another_line) {
  begin({-1.2, 0.8, rad(90)});
  see({piece({-1.2, 0.75, rad(90)}, {-2.9, 1.5}, {-2.5, 1.5})});
  EXPECT_DOUBLE_EQ(localizer_.estimate().X_PR.y_m, 0.8);
}

TEST_F(LocalizerLinesTest, a_robot_that_is_carried_away_says_that_it_is_lost_and_waits_for_a_tag) {
  place_.tags.push_back({4, {1.9, 0, rad(180)}, 0.1});
  begin({-1.2, -0.6, 0});
  drive(100);
  EXPECT_TRUE(localizer_.estimate().known);
  truth_ = {0.9, 0.5, rad(55)};
  double driven_m = 0;
  for (; driven_m < 3 && !localizer_.estimate().lost; driven_m += 0.1) drive(5);
  EXPECT_TRUE(localizer_.estimate().lost);
  EXPECT_LT(driven_m, 2.5);
  const Pose2 believed = localizer_.estimate().X_PR;
  Pose2 beside = believed;
  beside.y_m += 0.02;
  for (const PlaceLine& line : field_.lines) see({piece(beside, line.p_PA_m, line.p_PB_m)});
  EXPECT_EQ(localizer_.estimate().X_PR.y_m, believed.y_m);
  for (int i = 0; i < 60; ++i) {
    drive(10);
    EXPECT_FALSE(localizer_.estimate().known);
  }
  ThingsPercept things;
  for (int i = 0; i < 8; ++i) {
    truth_ = {1.0, 0, 0};
    things.X_OR = X_OR_;
    things.things = {{ThingKind::tag, 4, 0, 0.9, 0.03, rad(180), true}};
    localizer_.see(things);
  }
  EXPECT_TRUE(localizer_.estimate().known);
  EXPECT_LT(off_m(), 0.1);
}

TEST_F(LocalizerLinesTest, white_things_that_are_on_no_map_do_not_make_it_lost) {
  sees_lines_ = false;
  begin({-1.2, -0.6, 0});
  for (int i = 0; i < 20; ++i) {
    drive(9);
    see({{{0.5, 0.2}, {0.6, 0.35}, 0.01, 0.01}});  // short
    EXPECT_FALSE(localizer_.estimate().lost);
  }
  sees_lines_ = true;
  begin({-1.2, -0.6, 0});
  drive(60);
  for (int i = 0; i < 100; ++i) see({{{0.5, 0.2}, {0.8, 0.5}, 0.01, 0.01}});  // long, from one place
  EXPECT_FALSE(localizer_.estimate().lost);
}

TEST(LineError, a_long_arc_tells_less_of_the_direction_than_a_short_one) {
  const Place place = field();
  const LineError short_arc =
      line_error(place, 5, {-1.2, 0, 0}, piece({-1.2, 0, 0}, {-0.5, -0.1}, {-0.5, 0.1}));
  const LineError long_arc =
      line_error(place, 5, {-1.2, 0, 0}, piece({-1.2, 0, 0}, {-0.5, -0.2}, {-0.5, 0.2}));
  EXPECT_NEAR(std::sqrt(short_arc.noise2(1)), 0.1, 0.002);
  EXPECT_NEAR(std::sqrt(long_arc.noise2(1)), 0.2, 0.002);
}

TEST(OnSeenFloor, a_piece_that_reaches_beyond_where_the_floor_ends_is_none) {
  SonarPercept sonar;
  for (int degree = -30; degree <= 30; ++degree) sonar.readings.push_back({rad(degree), Answer::clear, 2, 0});
  const LineSeen across{{1, -0.3}, {1, 0.3}, 0.01, 0.01};
  EXPECT_TRUE(on_seen_floor(across, sonar));
  sonar.readings[40].distance_m = 0.9;  // at 10 degrees, a check at 8.5
  EXPECT_TRUE(on_seen_floor(across, sonar));
  for (int i = 35; i < 45; ++i)
    sonar.readings[static_cast<std::size_t>(i)] = {rad(i - 30), Answer::blocked, 0.9, 0};
  EXPECT_FALSE(on_seen_floor(across, sonar));
  EXPECT_TRUE(on_seen_floor({{0.8, -0.3}, {0.8, 0.3}, 0.01, 0.01}, sonar));
  for (SonarReading& reading : sonar.readings) reading.answer = Answer::not_seen;
  EXPECT_FALSE(on_seen_floor(across, sonar));
  EXPECT_FALSE(on_seen_floor(across, {}));
}

TEST(LineError, tells_how_it_changes_with_the_pose) {
  const Place place = field();
  const Pose2 X_PR{-0.9, 0.35, 0.4};
  const LineSeen seen = piece({-0.93, 0.4, 0.45}, {-0.45, 0.1}, {-0.35, 0.3});
  for (const int line : {3, 4, 5}) {
    const LineError here = line_error(place, line, X_PR, seen);
    for (int i = 0; i < 3; ++i) {
      constexpr double kStep = 1e-6;
      Pose2 there = X_PR;
      (i == 0 ? there.x_m : i == 1 ? there.y_m : there.heading_rad) += kStep;
      const Vector2d slope = (line_error(place, line, there, seen).off - here.off) / kStep;
      EXPECT_NEAR(here.h(0, i), slope.x(), 1e-5) << line << " " << i;
      EXPECT_NEAR(here.h(1, i), slope.y(), 1e-5) << line << " " << i;
    }
  }
}

}  // namespace
}  // namespace mirada::robot
