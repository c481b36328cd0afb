#include "memory/corridors.h"

#include <algorithm>
#include <cmath>

namespace mirada::memory {
namespace {

using Eigen::Vector2d;

constexpr double kLookStep_m = 0.05;
constexpr double kUnseen_m = 0.13;  // more floor in a row than this that nobody looked at ends the way
constexpr double kOwnPlace = 1.4;   // of the radius: there the robot stands, or its camera is blind
constexpr double kRimPart = 0.6;    // of the radius, where the floor is checked beside the middle

/// How far the floor along a line was looked at.
double seen_to(const VisualMemory& memory, const Vector2d& from, const Vector2d& along, double start_m,
               double most_m) {
  double seen_m = start_m;
  for (double at = start_m; at < most_m; at += kLookStep_m) {
    const Vector2d p = from + at * along;
    if (memory.floor().seen_at(p.x(), p.y()) >= 0) {
      seen_m = at + kLookStep_m;
    } else if (at - seen_m > kUnseen_m) {
      break;
    }
  }
  return seen_m;
}

}  // namespace

std::size_t Corridors::index(double bearing_rad) {
  const long i = std::lround(deg(wrap_rad(bearing_rad)) * kDirections / 360);
  return static_cast<std::size_t>((i + kDirections) % kDirections);
}

Corridors::Corridors(const VisualMemory& memory, double radius_m, double most_m) {
  const Pose2& X_OR = memory.X_OR();
  const Vector2d here(X_OR.x_m, X_OR.y_m);
  std::vector<Vector2d> near;
  for (const ObstaclePoint& point : memory.points().all()) {
    const Vector2d to = point.p_O_m - here;
    if (to.squaredNorm() < (most_m + radius_m) * (most_m + radius_m)) near.push_back(to);
  }
  for (int i = 0; i < kDirections; ++i) {
    const double angle = X_OR.heading_rad + bearing_rad(i);
    const Vector2d along(std::cos(angle), std::sin(angle));
    const Vector2d side(-along.y(), along.x());
    double touch_m = most_m;
    for (const Vector2d& to : near) {
      const double ahead = to.dot(along);
      const double off = to.dot(side);
      if (ahead <= 0 || std::abs(off) >= radius_m) continue;
      touch_m = std::min(touch_m, std::max(0.0, ahead - std::sqrt(radius_m * radius_m - off * off)));
    }
    double seen_m = most_m;
    for (const double rim : {0.0, kRimPart, -kRimPart}) {
      const Vector2d from = here + rim * radius_m * side;
      seen_m = std::min(seen_m, seen_to(memory, from, along, kOwnPlace * radius_m, most_m));
    }
    touch_m_[static_cast<std::size_t>(i)] = touch_m;
    // The robot's front must stay on floor that was looked at.
    free_m_[static_cast<std::size_t>(i)] = std::min(touch_m, std::max(0.0, seen_m - radius_m));
  }
}

}  // namespace mirada::memory
