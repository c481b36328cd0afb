#include <algorithm>

#include <gtest/gtest.h>

#include "base/files.h"
#include "rig/lockstep.h"

namespace mirada::scenarios {
namespace {

class Greet : public ::testing::TestWithParam<std::string> {};

TEST_P(Greet, FindsThePersonOfTheRoomAndSaysHello) {
  const auto program = read_file(data_folder("blocks") / "vision" / "examples" / "greet.json");
  auto room = world::world_by_name(GetParam());
  auto robot = robot_by_name("mirada-sim");
  ASSERT_TRUE(program.ok() && room.ok() && robot.ok());
  rig::LockstepOptions options;
  options.world = std::move(*room);
  options.robot = std::move(*robot);
  options.seed = 2;
  options.seconds = 15;
  const session::RunReport report = rig::run_lockstep(*program, options);
  EXPECT_TRUE(report.faults.empty());
  EXPECT_TRUE(
      std::ranges::any_of(report.say, [](const auto& said) { return said.text.starts_with("Hello"); }));
}

INSTANTIATE_TEST_SUITE_P(ShippedRooms, Greet, ::testing::Values("sala-1", "green-field", "workshop"));

}  // namespace
}  // namespace mirada::scenarios
