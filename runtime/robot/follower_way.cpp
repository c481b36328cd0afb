#include <algorithm>
#include <cmath>

#include "robot/follower.h"

// Where there is room to roll: the follower's ways.
namespace mirada::robot {
namespace {

using Eigen::Vector2d;

constexpr double kDroveOn_m = 0.25;  // floor, this near to where it drove itself
constexpr double kOwnCrumb_m = 0.05;
constexpr std::size_t kMostOwnCrumbs = 190;
constexpr double kWalked_m = 0.25;  // floor, this near to where they walked
constexpr double kPerson_m = 0.24;  // an obstacle this near to where they were then was they
constexpr Micros kPersonTime = 1'200 * kMillisecond;

}  // namespace

/// Where it drove looking ahead: a step back must not vouch for the next one.
void Follower::note_own_way(const Sight& sight) {
  const Vector2d here(sight.X_OR.x_m, sight.X_OR.y_m);
  const Vector2d ahead(std::cos(sight.X_OR.heading_rad), std::sin(sight.X_OR.heading_rad));
  const Vector2d step = own_way_.empty() ? Vector2d::Zero() : Vector2d(here - own_way_.back().p_O_m);
  if (own_way_.empty() || (step.norm() > kOwnCrumb_m && step.dot(ahead) > 0))
    own_way_.push_back({here, sight.now, sight.now});
  else if (step.norm() <= kOwnCrumb_m)
    own_way_.back().until = sight.now;
  if (own_way_.size() > kMostOwnCrumbs) own_way_.pop_front();
}

bool Follower::walked_on(const Vector2d& p_O_m) const {
  for (const Crumb& mine : own_way_)
    if ((mine.p_O_m - p_O_m).squaredNorm() < kDroveOn_m * kDroveOn_m) return true;
  return std::any_of(crumbs_.begin(), crumbs_.end(), [&](const Crumb& crumb) {
    return crumb.sure && (crumb.p_O_m - p_O_m).squaredNorm() < kWalked_m * kWalked_m;
  });
}

/// Whether what was seen there was the person, who has gone on since.
bool Follower::was_the_person(const memory::ObstaclePoint& point) const {
  return std::any_of(crumbs_.begin(), crumbs_.end(), [&](const Crumb& crumb) {
    return (crumb.p_O_m - point.p_O_m).squaredNorm() < kPerson_m * kPerson_m &&
           point.seen_at > crumb.since - kPersonTime && point.seen_at < crumb.until + kPersonTime;
  });
}

/// Whether the robot itself has stood there since that was seen: then it is not there any more.
bool Follower::stood_on(const memory::ObstaclePoint& point) const {
  constexpr double kUnder_m = 0.085;  // well within its footprint
  return std::any_of(own_way_.begin(), own_way_.end(), [&](const Crumb& mine) {
    return point.seen_at < mine.until && (mine.p_O_m - point.p_O_m).squaredNorm() < kUnder_m * kUnder_m;
  });
}

/// How far the robot can roll in this direction: until something remembered, or
/// floor that nobody looked at. Where the person walked there is floor, and
/// what was seen there was the person.
double Follower::room_m(const memory::VisualMemory& memory, double bearing_rad) const {
  constexpr double kMost_m = 1.2;
  constexpr double kStep_m = 0.05;
  constexpr double kUnseen_m = 0.13;
  constexpr double kSigmas = 2;
  const Pose2& X_OR = memory.X_OR();
  const Vector2d here(X_OR.x_m, X_OR.y_m);
  const double angle = X_OR.heading_rad + bearing_rad;
  const Vector2d along(std::cos(angle), std::sin(angle));
  const Vector2d side(-along.y(), along.x());
  // Backward no picture warns of what stands beside the middle, or nearer than it was seen from afar.
  const bool backward = std::abs(wrap_rad(bearing_rad)) > M_PI / 2;
  double room_m = kMost_m;
  for (const memory::ObstaclePoint& point : memory.points().all()) {
    const Vector2d to = point.p_O_m - here;
    const double ahead = to.dot(along);
    const double off = to.dot(side);
    const double unsure_m = backward ? kSigmas * point.sigma_m : 0;
    if (ahead <= 0 || ahead > room_m + unsure_m + radius_m_ || std::abs(off) >= radius_m_) continue;
    if (was_the_person(point) || stood_on(point)) continue;
    room_m = std::min(room_m, std::max(0.0, ahead - unsure_m - std::sqrt(radius_m_ * radius_m_ - off * off)));
  }
  const auto is_floor = [&](const Vector2d& p) {
    return memory.floor().likely_at(p.x(), p.y()) || walked_on(p);
  };
  const Vector2d lane = 0.7 * radius_m_ * side;
  double seen_m = 1.4 * radius_m_;
  for (double at = seen_m; at < room_m + radius_m_; at += kStep_m) {
    if (is_floor(here + at * along) &&
        (!backward || (is_floor(here + at * along + lane) && is_floor(here + at * along - lane))))
      seen_m = at + kStep_m;
    else if (at - seen_m > kUnseen_m)
      break;
  }
  room_m = std::min(room_m, std::max(0.0, seen_m - radius_m_));
  // The person is no floor.
  if (target_) {
    const Vector2d to = target_->p_O_m - here;
    const double ahead = to.dot(along);
    const double reach = radius_m_ + 0.15;
    const double off = std::abs(to.dot(side));
    if (ahead > 0 && off < reach)
      room_m = std::min(room_m, std::max(0.0, ahead - std::sqrt(reach * reach - off * off)));
  }
  return room_m;
}

/// Facing them, or turned so that it backs off where there is room; the neck keeps looking at them.
double Follower::way_back(const memory::VisualMemory& memory, double bearing_rad, double away_m) const {
  constexpr double kTooNear_m = 0.05, kNeed_m = 0.35;
  if (away_m > keep_m_ - kTooNear_m) return bearing_rad;
  double best = bearing_rad, most_m = 0;
  for (double aside = 0; aside <= kBackAside_rad + 1e-6; aside += rad(10)) {
    for (const double side : {search_side_, -search_side_}) {
      const double way = wrap_rad(bearing_rad - side * aside);
      const double room = room_m(memory, wrap_rad(way + M_PI));
      if (room >= kNeed_m) return way;
      if (room > most_m + 0.05) {
        most_m = room;
        best = way;
      }
    }
  }
  return best;
}

/// Straight to them where there is room, else round what is in between, else where there is most.
double Follower::way_to(const memory::VisualMemory& memory, double bearing_rad, double away_m) const {
  constexpr double kBetter_m = 0.1;
  const double need_m = std::clamp(away_m - keep_m_ * 0.6, 0.15, 0.6);
  double best = bearing_rad, most_m = 0;
  for (int i = 0; i <= 17; ++i) {
    for (const double side : {search_side_, -search_side_}) {
      const double way = wrap_rad(bearing_rad + side * rad(6) * i);
      const double room = room_m(memory, way);
      if (room >= need_m) return way;
      if (i == 0) most_m = room;
      if (i == 0) break;
      if (room < most_m + kBetter_m) continue;
      most_m = room;
      best = way;
    }
  }
  return best;
}

}  // namespace mirada::robot
