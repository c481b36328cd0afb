#include "world/sim_camera.h"

#include "../hal/camera_contract_cases.h"
#include "rooms_for_tests.h"
#include "world/simulation.h"

namespace mirada::hal {
namespace {

CameraUnderTest make_simulated() {
  struct Keeps {
    world::Simulation simulation{world::quiet_room(), robot_by_name("mirada-sim").value(), 1};
  };
  auto keeps = std::make_shared<Keeps>();
  world::Simulation& s = keeps->simulation;
  // Half a period in, so that each further period brings one ripe picture.
  s.step(40 * kMillisecond);
  return {keeps, &s.camera(), [&s] { s.step(50 * kMillisecond); }, [&s] { return s.now(); }};
}

INSTANTIATE_TEST_SUITE_P(Simulated, CameraContract, testing::Values(CameraMaker{"room", make_simulated}),
                         [](const auto& maker) { return maker.param.name; });

TEST(SimCamera, APictureCanBeReadWhenItIsAsOldAsTheRobotSays) {
  world::Simulation simulation(world::quiet_room(), robot_by_name("mirada-sim").value(), 1);
  simulation.camera().enable(true);
  simulation.step(70 * kMillisecond);
  EXPECT_FALSE(simulation.camera().poll());
  simulation.step(10 * kMillisecond);
  const auto frame = simulation.camera().poll();
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->t_exposure, 50 * kMillisecond);
}

}  // namespace
}  // namespace mirada::hal
