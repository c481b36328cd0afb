// What a picture costs the memory when it holds 2,000 places: taking it in and asking every direction. Prints
// one JSON object.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <vector>

#include "base/random.h"
#include "memory/visual_memory.h"

namespace {

using namespace mirada;
using namespace mirada::memory;

constexpr Micros kFrame = 50 * kMillisecond;

/// A look of 63 degrees at things scattered at random.
SonarPercept look(const Pose2& X_OR, double pan_deg, Micros t, Random& chance) {
  SonarPercept out;
  out.frame = static_cast<std::uint64_t>(t / kFrame) + 1;
  out.t_exposure = t;
  out.neck.pan_rad = rad(pan_deg);
  out.X_OR = X_OR;
  double distance_m = chance.uniform(0.5, 2.8);
  for (int degree = -31; degree <= 31; ++degree) {
    if (degree % 4 == 0) distance_m = chance.uniform(0.5, 2.8);
    out.readings.push_back({rad(pan_deg + degree), Answer::blocked, distance_m, 0.02});
  }
  return out;
}

/// Until it is full: places all round, seen once each from poses along a way.
Micros fill(VisualMemory& memory, Random& chance) {
  Micros t = 0;
  for (int i = 0; i < 4000 && memory.points().all().size() < ObstaclePoints::kMost - 60; ++i) {
    t += kFrame;
    const Pose2 pose{0.3 * std::sin(i * 0.01), 0.3 * std::cos(i * 0.013), wrap_rad(i * 0.7)};
    memory.moved(t, pose);
    memory.observe(look(pose, 0, t, chance));
  }
  return t;
}

}  // namespace

int main() {
  const auto robot = robot_by_name("mirada-sim");
  if (!robot) return 2;
  VisualMemory memory(*robot);
  Random chance(1, "memory bench");
  Micros t = fill(memory, chance);
  std::vector<double> costs_us;
  std::size_t least = ObstaclePoints::kMost;
  for (int i = 0; i < 1000; ++i) {
    t += kFrame;
    const Pose2 pose{0.002 * (i % 100), 0, wrap_rad(0.1 * i)};
    const SonarPercept picture = look(pose, 0, t, chance);
    const auto start = std::chrono::steady_clock::now();
    memory.moved(t, pose);
    memory.observe(picture);
    const double sum = memory.around().at(1.0).distance_m;
    const auto end = std::chrono::steady_clock::now();
    if (!std::isfinite(sum)) return 1;
    costs_us.push_back(std::chrono::duration<double, std::micro>(end - start).count());
    least = std::min(least, memory.points().all().size());
  }
  std::sort(costs_us.begin(), costs_us.end());
  std::cout << "{\"fewest_places\": " << least << ", \"most_places\": " << ObstaclePoints::kMost
            << ", \"update_and_query_us\": {\"median\": " << costs_us[500] << ", \"p90\": " << costs_us[900]
            << "}}\n";
  return 0;
}
