// Counts what the visual sonar takes from the heap: in a program of its own, since it replaces operator new.
#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

#include "scene.h"
#include "vision/visual_sonar.h"

namespace {

bool counting = false;
int taken = 0;

void* take(std::size_t size) {
  taken += counting;
  if (void* out = std::malloc(size == 0 ? 1 : size)) return out;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return take(size); }
void* operator new[](std::size_t size) { return take(size); }
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }

namespace mirada::vision {
namespace {

TEST(VisualSonar, TakesNoMemoryForAPictureButItsAnswersOwn) {
  RobotConfig robot;
  robot.mount.p_TM_m = {0.05, 0, 0.20};
  robot.mount.tilt_rad = rad(22);
  testing::Scene scene;
  scene.floor = testing::Floor::tiles;
  scene.boxes.push_back(testing::Box{0.8, 0, 0, 0.2, 0.3, 0.25, {0.1, 0.1, 0.7}});
  VisualSonar sonar(robot);
  for (std::uint64_t number = 1; number <= 6; ++number) {
    const Pose2 X_WR{0.02 * static_cast<double>(number), 0, 0};
    scene.seed = number;
    const Frame frame{testing::render(scene, robot, X_WR, {}), static_cast<Micros>(number), number};
    taken = 0;
    counting = true;
    const SonarPercept percept = sonar.look(frame, {}, X_WR);
    counting = false;
    EXPECT_FALSE(percept.readings.empty());
    constexpr int kAnswers = 2;  // readings and boundary
    if (number > 1) {
      EXPECT_EQ(taken, kAnswers) << "picture " << number;
    }
  }
}

}  // namespace
}  // namespace mirada::vision
