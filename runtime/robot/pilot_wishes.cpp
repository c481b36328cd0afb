// Where the pilot wants to go: roaming, along a wall, to a place.
#include <algorithm>
#include <cmath>

#include "robot/pilot.h"

namespace mirada::robot {
namespace {

using Eigen::Vector2d;

constexpr double kVisit_m = 0.25;
constexpr std::size_t kMostVisited = 4'096;
constexpr Micros kChooseEvery = 250 * kMillisecond;
constexpr double kGoodWay_m = 0.3;
constexpr double kFarWay_m = 1.6;
constexpr double kPreferAhead = 0.35;
constexpr double kPreferNew = 0.45;
constexpr double kPreferSame = 0.2;
constexpr double kWallGap_m = 0.16;  // between the robot's rim and the wall
constexpr double kWallGain = 2.5;    // rad a metre off
constexpr double kWallSeen_m = 0.9;
constexpr double kArrived_m = 0.03;
constexpr Micros kRouteEvery = 300 * kMillisecond;
constexpr double kCarrot_m = 0.9;
constexpr Micros kPatience = 9 * kSecond;
constexpr double kProgress_m = 0.05;
constexpr double kSlowdown_per_s = 1.5;

std::pair<int, int> square(const Vector2d& p) {
  return {static_cast<int>(std::floor(p.x() / kVisit_m)), static_cast<int>(std::floor(p.y() / kVisit_m))};
}

Vector2d here(const memory::VisualMemory& memory) { return {memory.X_OR().x_m, memory.X_OR().y_m}; }

}  // namespace

double Pilot::novelty(const memory::VisualMemory& memory, double bearing_rad, double free_m) const {
  const double angle = memory.X_OR().heading_rad + bearing_rad;
  const Vector2d along(std::cos(angle), std::sin(angle));
  int fresh = 0;
  for (double at = kVisit_m; at <= kFarWay_m; at += kVisit_m) {
    if (at > free_m + radius_m_) break;
    fresh += visited_.contains(square(here(memory) + at * along)) ? 0 : 1;
  }
  return fresh * kVisit_m / kFarWay_m;
}

Pilot::Wish Pilot::roam_wish(Micros now, const memory::VisualMemory& memory, const memory::Corridors& ways) {
  if (visited_.size() < kMostVisited) visited_.insert(square(here(memory)));
  const double heading = memory.X_OR().heading_rad;
  const double last_rad = heading_O_rad_ ? wrap_rad(*heading_O_rad_ - heading) : 0;
  const bool good = heading_O_rad_ && ways.free_m(last_rad) > kGoodWay_m;
  if (good && now - chosen_at_ < kChooseEvery) return Wish{last_rad};
  double most = -1;
  double best_rad = 0;
  for (int i = 0; i < memory::Corridors::kDirections; ++i) {
    const double bearing = memory::Corridors::bearing_rad(i);
    const double free_m = ways.free_m(bearing);
    if (free_m < kGoodWay_m) continue;
    const double same = heading_O_rad_ ? std::max(0.0, std::cos(bearing - last_rad)) : 0;
    const double value = std::min(free_m, kFarWay_m) / kFarWay_m + kPreferAhead * std::cos(bearing) +
                         kPreferNew * novelty(memory, bearing, free_m) + kPreferSame * same;
    if (value <= most) continue;
    most = value;
    best_rad = bearing;
  }
  chosen_at_ = now;
  if (most < 0) {
    // Nowhere to go that was looked at: turn on the spot and look; always the same way round.
    if (heading_O_rad_) spin_ = wrap_rad(*heading_O_rad_ - heading) >= 0 ? 1 : -1;
    heading_O_rad_.reset();
    return Wish{spin_ * rad(60)};
  }
  heading_O_rad_ = wrap_rad(heading + best_rad);
  return Wish{best_rad};
}

Pilot::Wish Pilot::wall_wish(const memory::VisualMemory& memory, const memory::Corridors& ways) {
  const auto nearest = [&](int side) {
    std::pair<double, double> best{kWallSeen_m, 0};  // distance, bearing
    for (int degree = 15; degree <= 140; degree += 3) {
      const memory::Direction& known = memory.around().at(side * rad(degree));
      if (known.answer == Answer::blocked && known.distance_m < best.first)
        best = {known.distance_m, side * rad(degree)};
    }
    return best;
  };
  if (side_ == 0) {
    const double left_m = nearest(1).first;
    const double right_m = nearest(-1).first;
    if (left_m < kWallSeen_m || right_m < kWallSeen_m) side_ = left_m < right_m ? 1 : -1;
  }
  double wish_rad = 0;
  if (side_ != 0) {
    const auto [distance_m, bearing_rad] = nearest(side_);
    // The wall's end is rounded; the wall itself is kept at its distance.
    wish_rad = distance_m >= kWallSeen_m ? side_ * rad(30)
                                         : bearing_rad - side_ * rad(90) +
                                               side_ * kWallGain * (distance_m - radius_m_ - kWallGap_m);
  }
  wish_rad = std::clamp(wish_rad, -rad(80), rad(80));
  const double away = side_ == 0 ? 1 : -side_;
  for (int i = 0; i < 36 && ways.free_m(wish_rad) < kGoodWay_m; ++i) wish_rad += away * rad(5);
  return Wish{wrap_rad(wish_rad)};
}

Pilot::Wish Pilot::goal_wish(Micros now, const memory::VisualMemory& memory, const memory::Corridors& ways) {
  const Vector2d to = goal_O_m_ - here(memory);
  const double left_m = to.norm();
  if (left_m < kArrived_m) return Wish{0, 1, true};
  const double heading = memory.X_OR().heading_rad;
  const auto bearing_of = [&](const Vector2d& p) {
    const Vector2d off = p - here(memory);
    return wrap_rad(std::atan2(off.y(), off.x()) - heading);
  };
  if (nearest_at_ == 0 || left_m < nearest_m_ - kProgress_m) {
    nearest_m_ = left_m;
    nearest_at_ = now;
  }
  if (now - nearest_at_ > kPatience + micros(route_.steps_O_m.size() * 0.1 / drive_.cruise_mps))
    return Wish{0, 1, false, true};
  const double slow = std::max(kSlowdown_per_s * left_m, 0.03);
  // Straight there when nothing is in between.
  const double direct_rad = bearing_of(goal_O_m_);
  if (left_m < kFarWay_m && ways.free_m(direct_rad) >= left_m) return Wish{direct_rad, slow};
  if (routed_at_ == 0 || now - routed_at_ > kRouteEvery) {
    route_ = memory::route_to(memory, goal_O_m_, radius_m_);
    routed_at_ = now;
  }
  if (route_.steps_O_m.empty()) return Wish{direct_rad};
  // The farthest step of the route that can be rolled to straight.
  Vector2d carrot = route_.steps_O_m.front();
  for (const Vector2d& step : route_.steps_O_m) {
    const double step_m = (step - here(memory)).norm();
    if (step_m > kCarrot_m) break;
    if (step_m < 0.15 || ways.free_m(bearing_of(step)) >= step_m) carrot = step;
  }
  return Wish{bearing_of(carrot), slow};
}

}  // namespace mirada::robot
