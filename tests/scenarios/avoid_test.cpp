#include <gtest/gtest.h>

#include "avoid_run.h"

namespace mirada::scenarios {
namespace {

class Avoid : public ::testing::TestWithParam<std::string> {};

TEST_P(Avoid, RoamsTheRoomWithoutTouchingAnything) {
  const auto run = run_in_room(avoid_program(), GetParam(), 3, 40);
  ASSERT_TRUE(run.ok()) << to_text(run.faults(), Lang::en);
  EXPECT_EQ(run->status, "time_up");
  EXPECT_EQ(run->contacts, 0) << run->first_contact;
  EXPECT_GT(run->path_m, 2.0);
  EXPECT_GE(run->cells, 10);
}

INSTANTIATE_TEST_SUITE_P(ShippedRooms, Avoid, ::testing::Values("sala-1", "green-field", "workshop"));

TEST(Lockstep, TheSameRunTwiceIsTheSameBitForBit) {
  const auto first = run_in_room(avoid_program(), "sala-1", 7, 10);
  const auto again = run_in_room(avoid_program(), "sala-1", 7, 10);
  const auto other = run_in_room(avoid_program(), "sala-1", 8, 10);
  ASSERT_TRUE(first.ok() && again.ok() && other.ok());
  EXPECT_EQ(first->hash, again->hash);
  EXPECT_EQ(first->path_m, again->path_m);
  EXPECT_NE(first->hash, other->hash);
}

}  // namespace
}  // namespace mirada::scenarios
