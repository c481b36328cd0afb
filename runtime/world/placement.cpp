#include "world/placement.h"

#include <algorithm>

#include "base/random.h"
#include "world/shapes.h"

namespace mirada::world {
namespace {

using Eigen::Vector2d;

class Placer {
 public:
  Placer(WorldConfig& world, std::uint64_t seed, double room_m)
      : world_(world),
        room_m_(room_m),
        start_(seed, "start"),
        obstacles_(seed, "obstacles"),
        light_(seed, "light") {}

  void run() {
    const JitterConfig& jitter = world_.jitter;
    world_.light.level *= 1 + light_.uniform(-jitter.light, jitter.light);
    world_.light.from_rad += light_.uniform(-2, 2) * jitter.light;
    move_start();
    if (jitter.obstacles_m <= 0 && jitter.obstacles_rad <= 0) return;
    for (BoxConfig& box : world_.boxes) move(box, box.X_WB);
    for (CylinderConfig& cylinder : world_.cylinders) {
      Pose2 pose{cylinder.p_W_m.x(), cylinder.p_W_m.y(), 0};
      const CylinderConfig before = cylinder;
      pose = shaken(pose);
      cylinder.p_W_m = {pose.x_m, pose.y_m};
      if (!fits(shape_of(cylinder), shape_of(before))) cylinder = before;
    }
    for (PersonConfig& person : world_.people) {
      if (person.path_m.empty()) move(person, person.X_WP);
    }
  }

 private:
  Pose2 shaken(const Pose2& pose) {
    const JitterConfig& j = world_.jitter;
    return {pose.x_m + obstacles_.uniform(-j.obstacles_m, j.obstacles_m),
            pose.y_m + obstacles_.uniform(-j.obstacles_m, j.obstacles_m),
            pose.heading_rad + obstacles_.uniform(-j.obstacles_rad, j.obstacles_rad)};
  }

  template <class Thing>
  void move(Thing& thing, Pose2& pose) {
    const Thing before = thing;
    pose = shaken(pose);
    if (!fits(shape_of(thing), shape_of(before))) thing = before;
  }

  void move_start() {
    const JitterConfig& j = world_.jitter;
    const Pose2 before = world_.X_WR_start;
    const double dx = start_.uniform(-j.start_m, j.start_m);
    const double dy = start_.uniform(-j.start_m, j.start_m);
    world_.X_WR_start = {before.x_m + dx, before.y_m + dy,
                         before.heading_rad + start_.uniform(-j.start_rad, j.start_rad)};
    for (const Shape& shape : shapes()) {
      if (room_at_start(shape) < room_m_) world_.X_WR_start = before;
    }
  }

  double room_at_start(const Shape& shape) const {
    return separation(rectangle(world_.X_WR_start, 0.002, 0.002), shape).distance_m;
  }

  std::vector<Shape> shapes() const {
    std::vector<Shape> out;
    for (const WallConfig& wall : world_.walls) {
      for (Shape& shape : shapes_of(wall)) out.push_back(std::move(shape));
    }
    for (const BoxConfig& box : world_.boxes) out.push_back(shape_of(box));
    for (const CylinderConfig& cylinder : world_.cylinders) out.push_back(shape_of(cylinder));
    for (const PersonConfig& person : world_.people) out.push_back(shape_of(person));
    return out;
  }

  /// A moved thing may not come nearer to another than `gap_m` unless it already was (stacks of boxes stay
  /// stacks), nor to the start.
  bool fits(const Shape& moved, const Shape& before) const {
    if (room_at_start(moved) < room_m_ + 0.1) return false;
    for (const Shape& other : shapes()) {
      if (same(other, moved)) continue;
      const double was = gap(before, other);
      const double is = gap(moved, other);
      if (is < was && is < kGap_m) return false;
    }
    return true;
  }

  static bool same(const Shape& a, const Shape& b) {
    return a.radius_m == b.radius_m && a.core_m == b.core_m;
  }

  static double gap(const Shape& a, const Shape& b) {
    if (a.core_m.size() > 2) {
      return separation(a.core_m, b).distance_m - a.radius_m;
    }
    const Pose2 at{a.core_m[0].x(), a.core_m[0].y(), 0};
    return separation(rectangle(at, 0.002, 0.002), b).distance_m - a.radius_m;
  }

  static constexpr double kGap_m = 0.6;  // narrower than this is no gap for a small robot

  WorldConfig& world_;
  double room_m_;
  Random start_, obstacles_, light_;
};

}  // namespace

WorldConfig placed(const WorldConfig& world, std::uint64_t seed, double room_m) {
  WorldConfig out = world;
  Placer(out, seed, room_m).run();
  return out;
}

}  // namespace mirada::world
