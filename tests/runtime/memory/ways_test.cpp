#include "memory/ways.h"

#include <gtest/gtest.h>

#include "flat_room.h"
#include "memory/corridors.h"
#include "memory/route.h"

namespace mirada::memory {
namespace {

constexpr double kRadius_m = 0.13;

/// A room of walls 2.4 m square around the origin with a wall across at x = 0.6 but for a gap at its left.
FlatRoom room_with_gap() {
  FlatRoom room;
  const auto wall = [&](double x, double y) { room.pillars.push_back({x, y, 0.015}); };
  for (double s = -1.2; s <= 1.2; s += 0.02) {
    wall(s, 1.2);
    wall(s, -1.2);
    wall(-1.2, s);
    wall(1.2, s);
    if (s < 0.5 || s > 1.0) wall(0.6, s);
  }
  return room;
}

VisualMemory seen_all_round(const FlatRoom& room) {
  VisualMemory memory(sim_robot());
  Micros t = 0;
  for (int degree = -180; degree < 180; degree += 40) {
    t += 50 * kMillisecond;
    memory.moved(t, {});
    memory.observe(room.look({}, degree, t));
  }
  return memory;
}

TEST(Corridors, EndBeforeWhatWouldBeTouched) {
  const VisualMemory memory = seen_all_round(room_with_gap());
  const Corridors ways(memory, kRadius_m, 2);
  EXPECT_NEAR(ways.free_m(0), 0.6 - 0.015 - kRadius_m, 0.06);
  EXPECT_NEAR(ways.free_m(rad(180)), 1.2 - 0.015 - kRadius_m, 0.06);
}

TEST(Corridors, NoFloorThatWasNotLookedAtIsFree) {
  VisualMemory memory(sim_robot());
  memory.moved(1, {});
  memory.observe(FlatRoom{}.look({}, 0, 1));
  const Corridors ways(memory, kRadius_m, 2);
  EXPECT_GT(ways.free_m(0), 1.5);
  EXPECT_LT(ways.free_m(rad(90)), 0.15);
  EXPECT_LT(ways.free_m(rad(180)), 0.15);
}

TEST(Route, LeadsThroughTheGapAndKeepsClearOfTheWalls) {
  const FlatRoom room = room_with_gap();
  const VisualMemory memory = seen_all_round(room);
  const Route route = route_to(memory, {0.9, 0}, kRadius_m);
  ASSERT_FALSE(route.steps_O_m.empty());
  EXPECT_EQ(route.misses_by_m, 0);
  for (const Eigen::Vector2d& step : route.steps_O_m) {
    for (const FlatRoom::Pillar& pillar : room.pillars)
      EXPECT_GT((step - Eigen::Vector2d(pillar.x_m, pillar.y_m)).norm(), kRadius_m - 0.03);
  }
}

TEST(Route, EndsWhereAClosedRoomLetsIt) {
  FlatRoom room = room_with_gap();
  for (double s = 0.5; s <= 1.0; s += 0.02) room.pillars.push_back({0.6, s, 0.015});
  const Route route = route_to(seen_all_round(room), {0.9, 0}, kRadius_m);
  EXPECT_GT(route.misses_by_m, 0.2);
  ASSERT_FALSE(route.steps_O_m.empty());
  EXPECT_LT(route.steps_O_m.back().x(), 0.6);
}

TEST(Route, GoesWhereItPaysMostOnceTheWayIsPaid) {
  const VisualMemory memory = seen_all_round(room_with_gap());
  const Eigen::Vector2d beyond(0.95, 0.75), behind(-0.9, 0);
  const auto two_places = [&](double beyond_m, double behind_m) {
    return route_to_best(memory, kRadius_m, [&, beyond_m, behind_m](const Eigen::Vector2d& p) {
      if ((p - beyond).norm() < 0.12) return beyond_m;
      return (p - behind).norm() < 0.12 ? behind_m : 0.0;
    });
  };
  // 0.9 m straight back, or 1.2 m and through the gap, where it is tight.
  const Route near = two_places(3, 3);
  ASSERT_FALSE(near.steps_O_m.empty());
  EXPECT_LT((near.steps_O_m.back() - behind).norm(), 0.2);
  const Route far = two_places(6, 3);
  ASSERT_FALSE(far.steps_O_m.empty());
  EXPECT_LT((far.steps_O_m.back() - beyond).norm(), 0.2);
  EXPECT_TRUE(two_places(0.5, 0.5).steps_O_m.empty());
}

TEST(Gap, IsTheOneNearestToTheDirection) {
  FlatRoom room;
  for (int degree = -180; degree < 180; degree += 2) {
    const bool gap = std::abs(degree - 30) < 15 || std::abs(degree + 60) < 15;
    if (!gap) room.pillars.push_back({std::cos(rad(degree)), std::sin(rad(degree)), 0.03});
  }
  const VisualMemory memory = seen_all_round(room);
  const auto left = gap_near(memory, rad(20), 2 * kRadius_m, 1.5, rad(60));
  const auto right = gap_near(memory, rad(-50), 2 * kRadius_m, 1.5, rad(60));
  ASSERT_TRUE(left && right);
  EXPECT_NEAR(deg(left->bearing_rad), 30, 4);
  EXPECT_NEAR(deg(right->bearing_rad), -60, 4);
  EXPECT_NEAR(left->edge_m, 0.97, 0.08);
  EXPECT_FALSE(gap_near(memory, rad(150), 2 * kRadius_m, 1.5, rad(60)).has_value());
}

}  // namespace
}  // namespace mirada::memory
