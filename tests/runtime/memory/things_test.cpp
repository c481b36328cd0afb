#include "memory/things.h"

#include <gtest/gtest.h>

namespace mirada::memory {
namespace {

ThingSeen seen(ThingKind kind, int id, double bearing_rad, double distance_m) {
  return {kind, id, bearing_rad, distance_m, 0.05};
}

TEST(Things, TheNewestSightingOfEachCounts) {
  DriftLedger drift({});
  Things things;
  things.observe(seen(ThingKind::tag, 3, 0, 1), {}, kSecond, drift);
  things.observe(seen(ThingKind::tag, 4, 0, 2), {}, kSecond, drift);
  things.observe(seen(ThingKind::tag, 3, rad(90), 0.5), {1, 0, 0}, 2 * kSecond, drift);
  ASSERT_EQ(things.all().size(), 2u);
  const Thing* tag = things.find(ThingKind::tag, 3);
  ASSERT_NE(tag, nullptr);
  EXPECT_NEAR(tag->p_O_m.x(), 1, 1e-9);
  EXPECT_NEAR(tag->p_O_m.y(), 0.5, 1e-9);
  EXPECT_EQ(tag->seen_at, 2 * kSecond);
  EXPECT_EQ(things.find(ThingKind::red_ball), nullptr);
}

TEST(Things, AreForgottenWhenOldAndBoundedInNumber) {
  DriftLedger drift({});
  Things things;
  for (int id = 0; id < 200; ++id) things.observe(seen(ThingKind::tag, id, 0, 1), {}, id, drift);
  EXPECT_EQ(things.all().size(), Things::kMost);
  EXPECT_EQ(things.find(ThingKind::tag, 0), nullptr);
  EXPECT_NE(things.find(ThingKind::tag, 199), nullptr);
  things.prune(Things::kLife + kSecond);
  EXPECT_TRUE(things.all().empty());
}

}  // namespace
}  // namespace mirada::memory
