#include <gtest/gtest.h>

#include "corner_run.h"

namespace mirada::scenarios {
namespace {

TEST(Corner, TheWayOutIsKnownFromMemoryWithoutLookingAgain) {
  for (const std::uint64_t seed : {41, 42}) {
    const CornerRun run = run_corner(seed, true);
    EXPECT_TRUE(run.left) << seed << ": nearest " << run.nearest_m << " end " << run.end_m << " crossed "
                          << run.crossings << " " << run.status;
  }
}

TEST(Corner, WhoForgetsKnowsNoWayOut) {
  const CornerRun run = run_corner(41, false);
  EXPECT_FALSE(run.left);
  EXPECT_EQ(run.crossings, 0);
}

}  // namespace
}  // namespace mirada::scenarios
