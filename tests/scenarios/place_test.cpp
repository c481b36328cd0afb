#include <gtest/gtest.h>

#include "where_run.h"

namespace mirada::scenarios {
namespace {

WhereRun run_of(Knows knows, std::uint64_t seed, double for_s) {
  WherePlan plan;
  plan.seed = seed;
  plan.knows = knows;
  plan.seconds = for_s;
  return run_where(plan);
}

TEST(WhereAmI, TagsKeepARovingRobotWithinADecimetre) {
  const WhereSummary sum = summary_of(run_of(Knows::tags, 3, 30));
  EXPECT_GT(sum.known_share, 0.9);
  EXPECT_LT(sum.off_worst_m, 0.1);
}

TEST(WhereAmI, LinesKeepARobotWithBadWheelsWhereThoseAloneLoseIt) {
  for (const std::uint64_t seed : {3, 4}) {
    const WhereRun with_lines = run_of(Knows::lines, seed, 60);
    const WhereSummary lines = summary_of(with_lines);
    const WhereSummary wheels = summary_of(run_of(Knows::start, seed, 60));
    EXPECT_GT(with_lines.path_m, 5) << seed;
    EXPECT_EQ(lines.known_share, 1) << seed;
    EXPECT_LT(lines.off_median_m, 0.04) << seed;
    EXPECT_LT(lines.off_worst_m, 0.1) << seed;
    EXPECT_LT(lines.off_p90_m, 0.3 * wheels.off_p90_m) << seed;
    EXPECT_GT(lines.honest_share, 0.9) << seed;
    EXPECT_LT(lines.possible_median_m, 0.1) << seed;
  }
}

TEST(WhereAmI, ARobotThatIsCarriedAwaySaysSoAndFindsItselfAgainByTags) {
  WherePlan plan;
  plan.seed = 3;
  plan.knows = Knows::lines_and_tags;
  plan.seconds = 40;
  plan.carried_at = 10 * kSecond;
  plan.carried_to = Pose2{1.6, 0.2, rad(180)};
  const WhereRun run = run_where(plan);
  const CarriedSummary sum = carried_summary(run, plan.carried_at);
  ASSERT_TRUE(sum.lost_s);
  EXPECT_LT(*sum.lost_s, 10);
  ASSERT_TRUE(run.told.back().known);
  EXPECT_LT(run.told.back().off_m, 0.1);
  EXPECT_EQ(sum.wrong_after_s, 0);
}

TEST(WhereAmI, ByLinesAloneOneThatIsCarriedAwayStaysLostRatherThanWrong) {
  for (const Pose2& X_PR : {Pose2{-0.3, -0.5, rad(144)}, Pose2{1.3, 0, rad(-103)}}) {
    WherePlan plan;
    plan.seed = 3;
    plan.seconds = 30;
    plan.carried_at = 10 * kSecond;
    plan.carried_to = X_PR;
    const WhereRun run = run_where(plan);
    const CarriedSummary sum = carried_summary(run, plan.carried_at);
    ASSERT_TRUE(sum.lost_s);
    EXPECT_LT(*sum.lost_s, 10);
    EXPECT_FALSE(sum.back_s);
    EXPECT_FALSE(run.told.back().known);
  }
}

}  // namespace
}  // namespace mirada::scenarios
