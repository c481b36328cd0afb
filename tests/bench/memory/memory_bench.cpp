// What a picture costs the memory while it holds 2,000 places: taking it in and asking every direction; and
// whether an hour of driving makes it grow or slow. Prints one JSON object.
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
using Eigen::Vector2d;

constexpr Micros kFrame = 50 * kMillisecond;
constexpr int kHalfView_deg = 31;
constexpr double kNearest_m = 0.25;
constexpr double kFarthest_m = 3;

/// A look of 63 degrees at thin posts: in each degree the nearest.
SonarPercept look(const std::vector<Vector2d>& posts, const Pose2& X_OR, Micros t) {
  SonarPercept out;
  out.frame = static_cast<std::uint64_t>(t / kFrame) + 1;
  out.t_exposure = t;
  out.X_OR = X_OR;
  for (int degree = -kHalfView_deg; degree <= kHalfView_deg; ++degree)
    out.readings.push_back({rad(degree), Answer::clear, kFarthest_m, 0.02});
  for (const Vector2d& post : posts) {
    const Vector2d to = post - Vector2d(X_OR.x_m, X_OR.y_m);
    const double distance_m = to.norm();
    if (distance_m > kFarthest_m || distance_m < kNearest_m) continue;
    const double bearing_rad = wrap_rad(std::atan2(to.y(), to.x()) - X_OR.heading_rad);
    const long degree = std::lround(deg(bearing_rad));
    if (std::abs(degree) > kHalfView_deg) continue;
    SonarReading& reading = out.readings[static_cast<std::size_t>(degree + kHalfView_deg)];
    if (distance_m < reading.distance_m) reading = {rad(degree), Answer::blocked, distance_m, 0.01};
  }
  return out;
}

/// A wall all round, a place in each quarter of a degree.
std::vector<Vector2d> round_wall(double radius_m) {
  std::vector<Vector2d> out;
  for (double degree = 0; degree < 360; degree += 0.25)
    out.emplace_back(radius_m * std::cos(rad(degree)), radius_m * std::sin(rad(degree)));
  return out;
}

/// Walls one before the other, the nearer hiding the farther, until the memory is full. To and fro, for
/// turning always to one side makes the first ones unsure.
Micros fill(VisualMemory& memory) {
  Micros t = 0;
  double side = 1;
  for (double radius_m = 2.95; memory.points().all().size() < ObstaclePoints::kMost - 60; radius_m -= 0.12) {
    const std::vector<Vector2d> wall = round_wall(radius_m);
    for (int turn = -155; turn <= 155; turn += 2 * kHalfView_deg) {
      t += kFrame;
      const Pose2 pose{0, 0, side * rad(turn)};
      memory.moved(t, pose);
      memory.observe(look(wall, pose, t));
    }
    side = -side;
  }
  return t;
}

/// A picture and a question about every direction; what that took.
double one_picture_us(VisualMemory& memory, const SonarPercept& picture, Micros t) {
  const auto start = std::chrono::steady_clock::now();
  memory.moved(t, picture.X_OR);
  memory.observe(picture);
  double sum = 0;
  for (const Direction& direction : memory.around().all()) sum += direction.free_m;
  const auto end = std::chrono::steady_clock::now();
  if (!std::isfinite(sum)) std::abort();
  return std::chrono::duration<double, std::micro>(end - start).count();
}

struct Costs {
  std::vector<double> all_us;
  std::size_t fewest = ObstaclePoints::kMost, most = 0;
  void note(double cost_us, std::size_t places) {
    all_us.push_back(cost_us);
    fewest = std::min(fewest, places);
    most = std::max(most, places);
  }
  double part(double share) {
    const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(all_us.size() - 1));
    std::nth_element(all_us.begin(), all_us.begin() + at, all_us.end());
    return all_us[static_cast<std::size_t>(at)];
  }
};

std::ostream& operator<<(std::ostream& out, Costs& costs) {
  return out << "{\"fewest_places\": " << costs.fewest << ", \"most_places\": " << costs.most
             << ", \"update_and_query_us\": {\"median\": " << costs.part(0.5)
             << ", \"p90\": " << costs.part(0.9) << ", \"p99\": " << costs.part(0.99) << "}}";
}

/// Looking about in a round room: what is remembered behind its wall is hidden, stays, and costs. Fifty times
/// anew, for places that are no longer sure are merged after a while.
Costs full(const RobotConfig& robot) {
  const std::vector<Vector2d> wall = round_wall(1.9);
  Costs out;
  for (int round = 0; round < 50; ++round) {
    VisualMemory memory(robot);
    Micros t = fill(memory);
    for (int i = 0; i < 20; ++i) {
      t += kFrame;
      const Pose2 pose{0.02 * std::sin(0.01 * i), 0.02 * std::cos(0.01 * i), rad(155) * std::cos(0.008 * i)};
      out.note(one_picture_us(memory, look(wall, pose, t), t), memory.points().all().size());
    }
  }
  return out;
}

/// An hour along a ring of 12 m through 4,000 posts: the first and the last minute.
std::pair<Costs, Costs> hour(const RobotConfig& robot, Random& chance) {
  VisualMemory memory(robot);
  std::vector<Vector2d> posts;
  for (int i = 0; i < 4000; ++i) posts.emplace_back(chance.uniform(-5, 5), chance.uniform(-5, 5));
  std::pair<Costs, Costs> out;
  constexpr int kMinute = 60 * kSecond / kFrame;
  for (int i = 0; i < 60 * kMinute; ++i) {
    const Micros t = (i + 1) * kFrame;
    const double along = 0.005 * i;
    const Pose2 pose{1.9 * std::cos(along), 1.9 * std::sin(along),
                     wrap_rad(along + rad(90) + std::sin(0.1 * i))};
    const double cost_us = one_picture_us(memory, look(posts, pose, t), t);
    if (i < kMinute) out.first.note(cost_us, memory.points().all().size());
    if (i >= 59 * kMinute) out.second.note(cost_us, memory.points().all().size());
  }
  return out;
}

}  // namespace

int main() {
  const auto robot = robot_by_name("mirada-sim");
  if (!robot) return 2;
  Random chance(1, "memory bench");
  Costs costs = full(*robot);
  auto [first, last] = hour(*robot, chance);
  std::cout << "{\"full\": " << costs << ",\n \"an_hour\": {\"first_minute\": " << first
            << ",\n  \"last_minute\": " << last << "}}\n";
  return 0;
}
