#include "memory/obstacle_points.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirada::memory {
namespace {

using Eigen::Vector2d;

constexpr double kFarthestBound_m = 0.6;  // of what the picture cuts off below
constexpr double kGate = 3;               // sigmas within which two sightings are one place
constexpr double kLeastGate_m = 0.05;
constexpr double kPassed_m = 0.03;  // a ray passes through only when it clearly does
constexpr double kSamePlace_m = 0.03;
constexpr int kWidestWindow = 8;  // readings to a side that may show a place whose bearing has drifted
constexpr double kReach_m = 6;
constexpr double kBeside_rad = rad(0.6);
constexpr double kWidestWedge_rad = rad(170);  // two half planes make a wedge only below 180 degrees
constexpr double kTooUnsure_m = 0.5;
constexpr double kRoom = 0.95;       // after a clearance this part of kMost is left
constexpr unsigned char kKnown = 1;  // a place known better explains the reading
constexpr unsigned char kTaken = 2;  // a place was put where the reading is

bool measured(Answer answer) { return answer == Answer::blocked || answer == Answer::clear; }

double length(const Eigen::Matrix2d& covariance, const Vector2d& along) {
  return std::sqrt(std::max(0.0, along.dot(covariance * along)));
}

/// The half plane to the left of an edge of the view, through the robot.
struct Edge {
  Vector2d along_O;
  double left_of_m(const Vector2d& v) const { return along_O.x() * v.y() - along_O.y() * v.x(); }
};

}  // namespace

Eigen::Matrix2d ObstaclePoint::covariance(const DriftLedger& drift) const {
  const Vector2d side(-sight_O.y(), sight_O.x());
  // Across the sight a place is known to half a degree of the neck, and to the spacing of the readings.
  const double across_m = 0.005 + 0.01 * (p_O_m - seen.p_OR_m).norm();
  return sigma_m * sigma_m * sight_O * sight_O.transpose() + across_m * across_m * side * side.transpose() +
         drift.covariance(seen, p_O_m);
}

/// One picture and what of it is explained by places known already.
struct ObstaclePoints::Look {
  const SonarPercept& sonar;
  const NearEdge& near;
  const DriftLedger& drift;
  Vector2d p_OR_m;
  std::vector<unsigned char>& explained;

  int last() const { return static_cast<int>(sonar.readings.size()) - 1; }
  const SonarReading& reading(int i) const { return sonar.readings[static_cast<std::size_t>(i)]; }
  /// The reading nearest to a bearing of the robot's frame; outside of 0..last() when there is none.
  int index(double bearing_rad) const {
    return static_cast<int>(std::lround(deg(wrap_rad(bearing_rad - sonar.readings.front().bearing_rad))));
  }
  Vector2d direction(double bearing_rad) const {
    const double angle = sonar.X_OR.heading_rad + bearing_rad;
    return {std::cos(angle), std::sin(angle)};
  }
  /// Blocked where the picture ends below: the thing is somewhere nearer.
  bool upper_bound(const SonarReading& reading) const {
    return reading.distance_m <= near.distance_m(reading.bearing_rad) + kPassed_m / 2;
  }
  /// Both edges of what was looked at, half a reading and a little more outside.
  std::array<Edge, 2> edges() const {
    return {Edge{direction(sonar.readings.front().bearing_rad - kBeside_rad)},
            Edge{direction(sonar.readings.back().bearing_rad + kBeside_rad)}};
  }
  bool wide() const {
    return sonar.readings.back().bearing_rad - sonar.readings.front().bearing_rad > kWidestWedge_rad;
  }
};

void ObstaclePoints::confront(ObstaclePoint& point, Look& look) {
  const Vector2d from = point.p_O_m - look.p_OR_m;
  const double distance_m = from.norm();
  if (distance_m < 0.02 || distance_m > kReach_m) return;
  const double bearing_rad = wrap_rad(std::atan2(from.y(), from.x()) - look.sonar.X_OR.heading_rad);
  const int at = look.index(bearing_rad);
  if (at < 0 || at > look.last()) return;
  const Eigen::Matrix2d covariance = point.covariance(look.drift);
  const Vector2d along = from / distance_m;
  const double sigma_m = length(covariance, along);
  const double sideways_m = length(covariance, {-along.y(), along.x()});
  const int window =
      std::clamp(static_cast<int>(std::ceil(deg(2 * sideways_m / distance_m))), 1, kWidestWindow);
  int seen_in = -1;
  bool passed = true;
  for (int off = 0; off <= window && seen_in < 0; ++off) {
    for (const int i : {at - off, at + off}) {
      if (i < 0 || i > look.last()) continue;
      const SonarReading& reading = look.reading(i);
      if (!measured(reading.answer)) {
        passed = false;
        continue;
      }
      const double both_m = std::hypot(sigma_m, reading.sigma_m);
      const double beyond_m = reading.distance_m - distance_m;
      const bool same = std::abs(beyond_m) < std::max(kGate * both_m, kLeastGate_m);
      if (reading.answer == Answer::blocked && same && !look.upper_bound(reading)) {
        seen_in = i;
        break;
      }
      const double margin_m = std::max(kPassed_m, 2 * both_m);
      passed = passed && beyond_m > margin_m;
    }
  }
  if (seen_in < 0) {
    if (passed && distance_m > look.near.distance_m(bearing_rad)) ++point.misses;
    return;
  }
  const SonarReading& reading = look.reading(seen_in);
  point.misses = 0;
  point.seen_at = look.sonar.t_exposure;
  unsigned char& explained = look.explained[static_cast<std::size_t>(seen_in)];
  const bool taken = explained == kTaken;
  if (explained == 0) explained = kKnown;
  // The better of two looks wins; looks one after the other err alike, so that a mean would promise too much.
  if (reading.sigma_m > sigma_m) return;
  explained = kTaken;
  if (taken) {
    point.misses = kLooksToClear;  // a twin stands there already
    return;
  }
  const Vector2d sight = look.direction(reading.bearing_rad);
  point.p_O_m = look.p_OR_m + reading.distance_m * sight;
  point.sight_O = sight;
  point.sigma_m = reading.sigma_m;
  point.seen = look.drift.now();
}

void ObstaclePoints::add_unexplained(const Look& look) {
  const std::size_t before = points_.size();
  for (int i = 0; i <= look.last(); ++i) {
    const SonarReading& reading = look.reading(i);
    if (reading.answer != Answer::blocked || look.explained[static_cast<std::size_t>(i)] != 0) continue;
    // Somewhere nearer than that is no place.
    if (reading.distance_m > kFarthestBound_m && look.upper_bound(reading)) continue;
    ObstaclePoint point;
    point.sight_O = look.direction(reading.bearing_rad);
    point.p_O_m = look.p_OR_m + reading.distance_m * point.sight_O;
    // Several readings of one small thing close by are one place.
    const bool twin = points_.size() > before && (points_.back().p_O_m - point.p_O_m).norm() < kSamePlace_m;
    if (twin) continue;
    point.sigma_m = reading.sigma_m;
    point.seen = look.drift.now();
    point.seen_at = look.sonar.t_exposure;
    points_.push_back(point);
  }
}

void ObstaclePoints::observe(const SonarPercept& sonar, const NearEdge& near, const DriftLedger& drift) {
  if (sonar.readings.empty()) return;
  explained_.assign(sonar.readings.size(), 0);
  Look look{sonar, near, drift, {sonar.X_OR.x_m, sonar.X_OR.y_m}, explained_};
  const auto [right, left] = look.edges();
  const bool wide = look.wide();
  bool cleared = false;
  for (ObstaclePoint& point : points_) {
    // Most places are out of view, which takes no angle to tell.
    const Vector2d from = point.p_O_m - look.p_OR_m;
    if (!wide && (right.left_of_m(from) < 0 || left.left_of_m(from) > 0)) continue;
    confront(point, look);
    cleared = cleared || point.misses >= kLooksToClear;
  }
  if (cleared)
    std::erase_if(points_, [](const ObstaclePoint& point) { return point.misses >= kLooksToClear; });
  add_unexplained(look);
}

void ObstaclePoints::prune(Micros now, const DriftLedger& drift) {
  const Vector2d here = drift.now().p_OR_m;
  std::erase_if(points_, [&](const ObstaclePoint& point) {
    if (now - point.seen_at > kLife || (point.p_O_m - here).norm() > kReach_m) return true;
    return std::sqrt(point.covariance(drift).trace()) > kTooUnsure_m;
  });
  if (points_.size() <= kMost) return;
  std::vector<Micros> ages;
  ages.reserve(points_.size());
  for (const ObstaclePoint& point : points_) ages.push_back(point.seen_at);
  const auto spare = points_.size() - static_cast<std::size_t>(kRoom * kMost);
  std::nth_element(ages.begin(), ages.begin() + static_cast<std::ptrdiff_t>(spare), ages.end());
  const Micros oldest = ages[spare];
  std::erase_if(points_, [oldest](const ObstaclePoint& point) { return point.seen_at < oldest; });
  // Many of the same moment: those that came last stay.
  if (points_.size() > kMost)
    points_.erase(points_.begin(), points_.end() - static_cast<std::ptrdiff_t>(kMost));
}

}  // namespace mirada::memory
