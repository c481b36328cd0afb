#include "robot/sureness.h"

#include <limits>

#include <gtest/gtest.h>

namespace mirada::robot {
namespace {

TEST(Sureness, IsTheChanceToBeWithinATenth) {
  EXPECT_NEAR(sureness({0, Answer::blocked, 1.0, 0.1}), 0.6827, 1e-3);    // one sigma
  EXPECT_NEAR(sureness({0, Answer::clear, 1.0, 0.05}), 0.9545, 1e-3);     // two
  EXPECT_NEAR(sureness({0, Answer::blocked, 0.05, 0.02}), 0.6827, 1e-3);  // 2 cm is near enough close by
  EXPECT_EQ(sureness({0, Answer::blocked, 1.0, 0}), 1);
}

TEST(Sureness, OfWhatIsNotSeenIsNone) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(sureness({0, Answer::not_seen, kNaN, kNaN}), 0);
  EXPECT_EQ(sureness({0, Answer::above_horizon, kNaN, kNaN}), 0);
  EXPECT_EQ(sureness({0, Answer::blocked, 1.0, kNaN}), 0);
}

}  // namespace
}  // namespace mirada::robot
