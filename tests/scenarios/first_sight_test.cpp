#include <gtest/gtest.h>

#include "first_sight_run.h"

namespace mirada::scenarios {
namespace {

TEST(FirstSight, LookingWhereItIsWorthMostFindsANewThingSoonerThanThreeZonesInTurn) {
  double around_s = 0;
  double zones_s = 0;
  int compared = 0;
  for (std::uint64_t seed = 51; seed < 71; ++seed) {
    const FirstSight around = run_first_sight(seed, "around");
    const FirstSight zones = run_first_sight(seed, "zones");
    // An obstacle imagined on the empty floor before the thing stands there ends a run.
    if (around.imagined || zones.imagined) continue;
    ASSERT_TRUE(around.after_s && zones.after_s) << seed;
    ++compared;
    around_s += *around.after_s;
    zones_s += *zones.after_s;
  }
  EXPECT_GE(compared, 6);
  EXPECT_LT(around_s, 0.75 * zones_s);
}

}  // namespace
}  // namespace mirada::scenarios
