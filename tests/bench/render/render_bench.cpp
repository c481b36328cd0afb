// Times the simulated camera: render_bench [ROBOT]. Every shipped room is driven through for 60 simulated
// seconds; JSON with this thread's CPU time a picture (quantiles), a world step without a camera, and making
// the room.
#include <algorithm>
#include <ctime>
#include <iostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>

#include "world/simulation.h"

namespace mirada::world {
namespace {

/// CPU time of this thread: other work on the machine disturbs it less than wall time.
double cpu_ms() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) * 1e-6;
}

double quantile(std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

nlohmann::json measure(const std::string& room, const RobotConfig& robot) {
  constexpr Micros kStep = 10 * kMillisecond;
  const WorldConfig world = world_by_name(room).value();
  const double begin = cpu_ms();
  Simulation simulation(world, robot, 1);
  const double made = cpu_ms();
  simulation.drive().set({0.06, 0.12});
  for (int i = 0; i < 1000; ++i) simulation.step(kStep);
  const double stepped = cpu_ms();
  simulation.camera().enable(true);
  std::vector<double> pictures;
  for (int i = 0; i < 6000; ++i) {
    const double before = cpu_ms();
    simulation.step(kStep);
    const double after = cpu_ms();
    if (simulation.now() % 50'000 == 0) pictures.push_back(after - before);
    simulation.camera().poll();
  }
  std::sort(pictures.begin(), pictures.end());
  return {{"room", room},
          {"pictures", pictures.size()},
          {"make_room_ms", made - begin},
          {"step_ms", (stepped - made) / 1000},
          {"picture_ms",
           {{"fastest", pictures.front()},
            {"p10", quantile(pictures, 0.1)},
            {"median", quantile(pictures, 0.5)},
            {"p90", quantile(pictures, 0.9)}}}};
}

}  // namespace
}  // namespace mirada::world

int main(int argc, char** argv) {
  cv::setNumThreads(1);
  const auto robot = mirada::robot_by_name(argc > 1 ? argv[1] : "mirada-sim");
  if (!robot) {
    std::cerr << mirada::to_text(robot.faults(), mirada::Lang::en) << "\n";
    return 2;
  }
  nlohmann::json out = nlohmann::json::array();
  for (const std::string& room : mirada::world::shipped_worlds()) {
    out.push_back(mirada::world::measure(room, *robot));
  }
  std::cout << out.dump(2) << "\n";
  return 0;
}
