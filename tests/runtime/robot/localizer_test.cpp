#include "robot/localizer.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/random.h"

namespace mirada::robot {
namespace {

/// A robot that drives round a square of tags; odometry turns a little too far with each metre.
class LocalizerTest : public testing::Test {
 protected:
  static Place square(bool start) {
    Place place;
    int id = 0;
    for (const double at : {-1.0, 0.0, 1.0}) {
      place.tags.push_back({id++, {at, 2, rad(-90)}, 0.1});
      place.tags.push_back({id++, {at, -2, rad(90)}, 0.1});
      place.tags.push_back({id++, {-2, at, 0}, 0.1});
      place.tags.push_back({id++, {2, at, rad(180)}, 0.1});
    }
    if (start) place.X_PR_start = Pose2{0, 0, 0};
    return place;
  }

  /// A few centimetres ahead and a bend, for the body and for the odometry.
  void drive(int steps, double bend_rad = 0.02) {
    for (int i = 0; i < steps; ++i) {
      truth_ = compose(truth_, {0.02, 0, bend_rad});
      X_OR_ = compose(X_OR_, {0.02 * 1.003, 0, bend_rad + 0.02 * 0.02});
      localizer_.moved(X_OR_);
      if (i % 5 == 0) look();
    }
  }

  /// Tags within 2.2 m and 30 degrees to both sides are seen, a little wrong.
  void look() {
    ThingsPercept seen;
    seen.frame = ++frame_;
    seen.X_OR = X_OR_;
    for (const PlaceTag& tag : place_.tags) {
      const Pose2 X_RT = compose(inverse(truth_), tag.X_PT);
      const double distance_m = std::hypot(X_RT.x_m, X_RT.y_m);
      const double bearing_rad = std::atan2(X_RT.y_m, X_RT.x_m);
      const bool turned_away = std::abs(wrap_rad(X_RT.heading_rad - bearing_rad)) < rad(110);
      if (distance_m > 2.2 || std::abs(bearing_rad) > rad(30) || turned_away) continue;
      ThingSeen thing{ThingKind::tag, tag.id, bearing_rad + random_.gaussian() * rad(0.4),
                      distance_m * (1 + 0.02 * random_.gaussian()), 0.03 * distance_m};
      thing.facing_rad = X_RT.heading_rad + random_.gaussian() * rad(6);
      thing.facing_known = true;
      seen.things.push_back(thing);
    }
    localizer_.see(seen);
  }

  double off_m() const {
    const Pose2 believed = localizer_.estimate().X_PR;
    return std::hypot(believed.x_m - truth_.x_m, believed.y_m - truth_.y_m);
  }

  Random random_{3, "localizer test"};
  Place place_ = square(true);
  Localizer localizer_{DriveConfig{}};
  Pose2 truth_, X_OR_;
  std::uint64_t frame_ = 0;
};

TEST_F(LocalizerTest, without_a_place_it_never_knows) {
  localizer_.know(std::nullopt);
  drive(20);
  EXPECT_FALSE(localizer_.estimate().known);
  EXPECT_FALSE(localizer_.estimate().lost);
}

TEST_F(LocalizerTest, tags_keep_it_where_the_wheels_alone_go_astray) {
  localizer_.know(place_);
  drive(1000);
  const double by_wheels_m = std::hypot(X_OR_.x_m - truth_.x_m, X_OR_.y_m - truth_.y_m);
  EXPECT_GT(by_wheels_m, 0.3);
  EXPECT_LT(off_m(), 0.12);
  EXPECT_TRUE(localizer_.estimate().known);
  EXPECT_LT(off_m(), 3 * localizer_.estimate().sigma_m + 0.02);
}

TEST_F(LocalizerTest, it_gets_less_sure_on_the_way_without_tags) {
  localizer_.know(place_);
  drive(200);
  const double sure_m = localizer_.estimate().sigma_m;
  place_.tags.clear();
  drive(200);
  EXPECT_GT(localizer_.estimate().sigma_m, 1.5 * sure_m);
}

TEST_F(LocalizerTest, a_robot_that_is_carried_away_says_that_it_is_lost_and_finds_itself_again) {
  localizer_.know(place_);
  drive(100);
  truth_ = {-0.9, 0.9, rad(150)};
  bool lost = false;
  for (int i = 0; i < 60 && !lost; ++i) {
    drive(5);
    lost = localizer_.estimate().lost;
    EXPECT_FALSE(lost && localizer_.estimate().known);
  }
  EXPECT_TRUE(lost);
  drive(200);
  EXPECT_TRUE(localizer_.estimate().known);
  EXPECT_LT(off_m(), 0.2);
}

TEST_F(LocalizerTest, put_down_anywhere_it_knows_nothing_until_it_sees_a_tag) {
  truth_ = {0.6, -0.5, rad(70)};
  place_ = square(false);
  localizer_.know(place_);
  EXPECT_FALSE(localizer_.estimate().known);
  drive(100);
  EXPECT_TRUE(localizer_.estimate().known);
  EXPECT_LT(off_m(), 0.25);
}

TEST_F(LocalizerTest, a_tag_that_is_on_no_map_and_one_false_sighting_change_nothing) {
  localizer_.know(place_);
  drive(50);
  const double before_m = off_m();
  ThingsPercept odd;
  odd.frame = ++frame_;
  odd.X_OR = X_OR_;
  odd.things = {{ThingKind::tag, 99, 0, 1, 0.03}, {ThingKind::tag, 0, rad(170), 0.4, 0.01}};
  localizer_.see(odd);
  EXPECT_DOUBLE_EQ(off_m(), before_m);
  EXPECT_TRUE(localizer_.estimate().known);
}

}  // namespace
}  // namespace mirada::robot
