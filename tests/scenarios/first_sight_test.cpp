#include <gtest/gtest.h>

#include "first_sight_run.h"

namespace mirada::scenarios {
namespace {

TEST(FirstSight, LookingWhereItIsWorthMostFindsANewThingSoonerThanThreeZonesInTurn) {
  double around_s = 0;
  double zones_s = 0;
  for (std::uint64_t seed = 51; seed < 71; ++seed) {
    const FirstSight around = run_first_sight(seed, "around");
    const FirstSight zones = run_first_sight(seed, "zones");
    EXPECT_FALSE(around.imagined || zones.imagined) << seed;
    ASSERT_TRUE(around.after_s && zones.after_s) << seed;
    around_s += *around.after_s;
    zones_s += *zones.after_s;
  }
  EXPECT_LT(around_s, 0.85 * zones_s);  // the figure itself: scripts/accuracy sight
}

}  // namespace
}  // namespace mirada::scenarios
