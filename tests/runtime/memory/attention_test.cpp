#include "memory/attention.h"

#include <gtest/gtest.h>

#include "flat_room.h"

namespace mirada::memory {
namespace {

GazeRange range() {
  GazeRange out;
  out.pan = sim_robot().neck.pan;
  out.half_view_rad = sim_robot().camera.hfov_rad() / 2;
  return out;
}

class Attending : public ::testing::Test {
 protected:
  void look(double pan_deg, Micros t) {
    memory_.moved(t, {});
    memory_.observe(FlatRoom{}.look({}, pan_deg, t));
  }
  VisualMemory memory_{sim_robot()};
  Attention attention_;
};

TEST_F(Attending, AllRoundGoesWhereItNeverLooked) {
  attention_.watch(Watching::around);
  look(0, kSecond);
  look(50, 2 * kSecond);
  const NextLook next = attention_.next(memory_, range());
  EXPECT_EQ(next.why, "never_seen");
  EXPECT_LT(next.pan_rad, rad(-30));
}

TEST_F(Attending, AllRoundThenGoesWhereItLookedLongestAgo) {
  attention_.watch(Watching::around);
  look(-80, 10 * kSecond);
  look(-40, 11 * kSecond);
  look(80, 12 * kSecond);
  look(40, 14 * kSecond);
  look(0, 15 * kSecond);
  memory_.moved(16 * kSecond, {});
  const NextLook next = attention_.next(memory_, range());
  EXPECT_LT(next.pan_rad, rad(-20));
}

TEST_F(Attending, WhoRollsLooksWhereItRolls) {
  attention_.watch(Watching::ahead);
  look(0, kSecond);
  for (Micros t = 1; t <= 12; ++t) look(80, kSecond + t * 50 * kMillisecond);
  GazeRange rolling = range();
  rolling.speed_mps = 0.2;
  rolling.pan_now_rad = rad(80);
  EXPECT_EQ(attention_.next(memory_, rolling).why, "on_the_way");
  EXPECT_NEAR(attention_.next(memory_, rolling).pan_rad, 0, 1e-9);
  rolling.turn_radps = 1;
  EXPECT_GT(attention_.next(memory_, rolling).pan_rad, rad(20));
}

TEST_F(Attending, ThreeZonesTakeTurnsAndRankedOnesPreferAhead) {
  attention_.watch(Watching::zones);
  memory_.moved(kSecond, {});
  const double first = attention_.next(memory_, range()).pan_rad;
  const double second = attention_.next(memory_, range()).pan_rad;
  const double third = attention_.next(memory_, range()).pan_rad;
  EXPECT_GT(first, second);
  EXPECT_NEAR(second, 0, 1e-9);
  EXPECT_LT(third, second);
  EXPECT_EQ(attention_.next(memory_, range()).pan_rad, first);
  EXPECT_EQ(attention_.dwell(), Attention::kZoneTime);
  attention_.watch(Watching::ranked_zones);
  EXPECT_NEAR(attention_.next(memory_, range()).pan_rad, 0, 1e-9);
  EXPECT_EQ(attention_.dwell(), 0);
}

TEST_F(Attending, TheFaceIsLookedAtAndWithoutOneItIsLookedFor) {
  attention_.watch(Watching::face);
  memory_.moved(kSecond, {});
  GazeRange with_face = range();
  with_face.face_rad = rad(25);
  EXPECT_EQ(attention_.next(memory_, with_face).why, "the_face");
  EXPECT_NEAR(attention_.next(memory_, with_face).pan_rad, rad(25), 1e-9);
  EXPECT_EQ(attention_.next(memory_, range()).why, "never_seen");
}

TEST(Sweep, CoversEightyDegreesToBothSidesInFewStops) {
  const GazeRange from = range();
  const auto stops = sweep_stops(from, rad(80));
  EXPECT_LE(stops.size(), 3u);
  for (double degree = -80; degree <= 80; ++degree) {
    bool seen = false;
    for (const double stop : stops) seen = seen || std::abs(rad(degree) - stop) <= from.half_view_rad;
    EXPECT_TRUE(seen) << degree;
  }
  double travel = 0;
  double at = from.pan_now_rad;
  for (const double stop : stops) {
    travel += std::abs(stop - at);
    at = stop;
  }
  EXPECT_LT(travel / from.pan.max_radps, 0.65);
}

TEST(Sweep, ANeckWithAShortReachLooksAsFarAsItCan) {
  GazeRange stiff = range();
  stiff.pan.min_rad = -rad(20);
  stiff.pan.max_rad = rad(20);
  for (const double stop : sweep_stops(stiff, rad(80))) EXPECT_LE(std::abs(stop), rad(20) + 1e-9);
}

}  // namespace
}  // namespace mirada::memory
