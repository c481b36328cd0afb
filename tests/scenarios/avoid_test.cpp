#include <gtest/gtest.h>

#include "avoid_run.h"
#include "base/files.h"

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

TEST(Roam, DrivesAboutUnseenRoomsByMemoryWithoutTouchingAnything) {
  const auto program = read_file(data_folder("blocks") / "memory" / "examples" / "roam.json");
  ASSERT_TRUE(program.ok());
  for (const auto& [room, seed] :
       {std::pair("lab:wood:side:83002", 1), std::pair("lab:carpet:even:83001", 2)}) {
    const auto run = run_in_room(*program, room, static_cast<std::uint64_t>(seed), 60);
    ASSERT_TRUE(run.ok()) << to_text(run.faults(), Lang::en);
    EXPECT_EQ(run->contacts, 0) << room << " " << run->first_contact;
    EXPECT_GT(run->path_m, 3.0) << room;
    EXPECT_GE(run->cells, 20) << room;
  }
}

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
