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
constexpr double kPreferFresh = 1.2;
constexpr double kFreshWorth_m = 4;  // what never having been somewhere is worth of a way
constexpr double kOldAtMost = 0.7;
constexpr double kOld_s = 600;
constexpr double kTurnCost_m = 0.8;
constexpr double kStay_m = 0.3;
constexpr Micros kGiveUp = 12 * kSecond;
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

double bearing_to(const memory::VisualMemory& memory, const Vector2d& p_O_m) {
  const Vector2d off = p_O_m - here(memory);
  return wrap_rad(std::atan2(off.y(), off.x()) - memory.X_OR().heading_rad);
}

}  // namespace

/// 1 where it never was, rising again from 0 with the time since: the wheels do not let old squares keep
/// their places for ever.
double Pilot::freshness(Micros now, const Vector2d& p_O_m) const {
  const auto found = visited_.find(square(p_O_m));
  if (found == visited_.end()) return 1;
  return kOldAtMost * std::min(1.0, seconds(now - found->second) / kOld_s);
}

double Pilot::novelty(Micros now, const memory::VisualMemory& memory, double bearing_rad,
                      double free_m) const {
  const double angle = memory.X_OR().heading_rad + bearing_rad;
  const Vector2d along(std::cos(angle), std::sin(angle));
  double fresh = 0;
  for (double at = kVisit_m; at <= kFarWay_m; at += kVisit_m) {
    if (at > free_m + radius_m_) break;
    fresh += freshness(now, here(memory) + at * along);
  }
  return fresh * kVisit_m / kFarWay_m;
}

void Pilot::note_visit(Micros now, const Vector2d& p_O_m) {
  const auto at = square(p_O_m);
  if (visited_.size() < kMostVisited || visited_.contains(at)) visited_[at] = now;
}

/// Plans the way to the place best worth going to.
void Pilot::explore(Micros now, const memory::VisualMemory& memory) {
  if (fresh_O_m_ && now - fresh_since_ > kGiveUp) note_visit(now, *fresh_O_m_);
  const double heading = memory.X_OR().heading_rad;
  const Vector2d ahead(std::cos(heading), std::sin(heading));
  route_ = memory::route_to_best(memory, radius_m_, [&](const Vector2d& p_O_m) {
    const Vector2d to = p_O_m - here(memory);
    const double turn = to.norm() > 0 ? 1 - to.dot(ahead) / to.norm() : 0;
    const bool same = fresh_O_m_ && square(*fresh_O_m_) == square(p_O_m);
    return kFreshWorth_m * freshness(now, p_O_m) - kTurnCost_m * turn + (same ? kStay_m : 0);
  });
  if (route_.steps_O_m.empty()) {
    fresh_O_m_.reset();
    return;
  }
  const Vector2d& end = route_.steps_O_m.back();
  if (!fresh_O_m_ || square(*fresh_O_m_) != square(end)) fresh_since_ = now;
  fresh_O_m_ = end;
}

Pilot::Wish Pilot::roam_wish(Micros now, const memory::VisualMemory& memory, const memory::Corridors& ways) {
  note_visit(now, here(memory));
  const double heading = memory.X_OR().heading_rad;
  const double last_rad = heading_O_rad_ ? wrap_rad(*heading_O_rad_ - heading) : 0;
  const bool good = heading_O_rad_ && ways.free_m(last_rad) > kGoodWay_m;
  if (good && now - chosen_at_ < kChooseEvery) return Wish{last_rad};
  // Where no way is good every step chooses anew; a plan costs too much for that.
  if (routed_at_ == 0 || now - routed_at_ >= kChooseEvery) {
    explore(now, memory);
    routed_at_ = now;
  }
  const auto fresh_rad = route_.steps_O_m.empty() ? std::nullopt : std::optional(carrot_rad(memory, ways));
  double most = -1;
  double best_rad = 0;
  for (int i = 0; i < memory::Corridors::kDirections; ++i) {
    const double bearing = memory::Corridors::bearing_rad(i);
    const double free_m = ways.free_m(bearing);
    if (free_m < kGoodWay_m) continue;
    const double same = heading_O_rad_ ? std::max(0.0, std::cos(bearing - last_rad)) : 0;
    const double fresh = fresh_rad ? std::cos(bearing - *fresh_rad) : 0;
    const double value = std::min(free_m, kFarWay_m) / kFarWay_m + kPreferAhead * std::cos(bearing) +
                         kPreferNew * novelty(now, memory, bearing, free_m) + kPreferSame * same +
                         kPreferFresh * fresh;
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
  if (nearest_at_ == 0 || left_m < nearest_m_ - kProgress_m) {
    nearest_m_ = left_m;
    nearest_at_ = now;
  }
  if (now - nearest_at_ > kPatience + micros(route_.steps_O_m.size() * 0.1 / drive_.cruise_mps))
    return Wish{0, 1, false, true};
  const double slow = std::max(kSlowdown_per_s * left_m, 0.03);
  // Straight there when nothing is in between.
  const double direct_rad = bearing_to(memory, goal_O_m_);
  if (left_m < kFarWay_m && ways.free_m(direct_rad) >= left_m) return Wish{direct_rad, slow};
  if (routed_at_ == 0 || now - routed_at_ > kRouteEvery) {
    route_ = memory::route_to(memory, goal_O_m_, radius_m_);
    routed_at_ = now;
  }
  if (route_.steps_O_m.empty()) return Wish{direct_rad};
  return Wish{carrot_rad(memory, ways), slow};
}

/// The bearing of the farthest step of the route that can be rolled to straight.
double Pilot::carrot_rad(const memory::VisualMemory& memory, const memory::Corridors& ways) const {
  Vector2d carrot = route_.steps_O_m.front();
  for (const Vector2d& step : route_.steps_O_m) {
    const double step_m = (step - here(memory)).norm();
    if (step_m > kCarrot_m) break;
    if (step_m < 0.15 || ways.free_m(bearing_to(memory, step)) >= step_m) carrot = step;
  }
  return bearing_to(memory, carrot);
}

}  // namespace mirada::robot
