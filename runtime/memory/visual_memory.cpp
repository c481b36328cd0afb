#include "memory/visual_memory.h"

#include <algorithm>
#include <cmath>

namespace mirada::memory {
namespace {

constexpr double kEdge_m = 0.03;  // nearest the boundary the floor is left to the obstacle
// Beyond where a level picture begins: one that looks up leaves floor unseen.
constexpr double kBeginsLater_m = 0.1;
constexpr double kSideMargin_m = 0.02;
constexpr std::uint64_t kPruneEvery = 16;  // pictures
constexpr double kCornerPart = 1.8;
constexpr double kOlder_s_per_m = 4;
constexpr double kStill_m = 1e-6;
constexpr double kStill_rad = 1e-6;

}  // namespace

VisualMemory::VisualMemory(const RobotConfig& robot)
    : near_(robot),
      drift_(drift_rates(robot.drive)),
      body_m_(robot.width_m() / 2),
      begins_m_(near_.distance_m(0) + kBeginsLater_m) {}

void VisualMemory::moved(Micros now, const Pose2& X_OR) {
  const bool still = std::hypot(X_OR.x_m - X_OR_.x_m, X_OR.y_m - X_OR_.y_m) < kStill_m &&
                     std::abs(wrap_rad(X_OR.heading_rad - X_OR_.heading_rad)) < kStill_rad;
  drift_.moved(X_OR);
  floor_.centre(X_OR.x_m, X_OR.y_m, now, drift_.now().tyre_m);
  X_OR_ = X_OR;
  // What is too old no longer counts: looked at once a second.
  if (!still || now / kSecond != now_ / kSecond) ++version_;
  if (now / kSecond != now_ / kSecond) things_.prune(now);
  now_ = now;
}

void VisualMemory::observe(const SonarPercept& sonar) {
  if (sonar.readings.empty()) return;
  last_look_ = sonar.t_exposure;
  note_looks(sonar);
  ++version_;
  near_.aim(sonar.neck);
  if (!remembers_) {
    points_.forget();
    floor_.forget();
  }
  points_.observe(sonar, near_, drift_);
  // What is too old or too unsure is looked for now and then, for it costs a look at every place.
  if (sonar.frame % kPruneEvery == 0 || points_.all().size() > ObstaclePoints::kMost)
    points_.prune(now_, drift_);
  const Pose2& X = sonar.X_OR;
  // What the robot stands on is free.
  for (double x = -body_m_; x <= body_m_; x += FreeFloor::kCell_m)
    for (double y = -body_m_; y <= body_m_; y += FreeFloor::kCell_m) floor_.mark(X.x_m + x, X.y_m + y);
  for (const SonarReading& reading : sonar.readings) {
    const bool blocked = reading.answer == Answer::blocked;
    if (!blocked && reading.answer != Answer::clear) continue;
    const double near_m = near_.distance_m(reading.bearing_rad);
    if (blocked && reading.distance_m <= near_m) continue;
    const double from_m = near_m > begins_m_ ? near_m : 0;
    const double length_m = reading.distance_m - (blocked ? kEdge_m : 0) - from_m;
    const double direction_rad = X.heading_rad + reading.bearing_rad;
    if (from_m > 0)
      floor_.mark_ray(X.x_m, X.y_m, direction_rad, std::min(from_m, reading.distance_m),
                      FreeFloor::Mark::before);
    if (length_m <= 0) continue;
    floor_.mark_ray(X.x_m + from_m * std::cos(direction_rad), X.y_m + from_m * std::sin(direction_rad),
                    direction_rad, length_m);
  }
}

std::size_t VisualMemory::bin(double heading_rad) const {
  const long i = std::lround(deg(heading_rad) * kLookedBins / 360) % kLookedBins;
  return static_cast<std::size_t>((i + kLookedBins) % kLookedBins);
}

void VisualMemory::note_looks(const SonarPercept& sonar) {
  const Looked now{sonar.t_exposure, drift_.now().tyre_m, true};
  for (const SonarReading& reading : sonar.readings)
    if (reading.answer != Answer::above_horizon)
      looked_[bin(sonar.X_OR.heading_rad + reading.bearing_rad)] = now;
}

Micros VisualMemory::look_age(double bearing_rad) const {
  const Looked& looked = looked_[bin(X_OR_.heading_rad + bearing_rad)];
  if (!looked.ever) return kNeverLooked;
  const Micros driven = micros(kOlder_s_per_m * (drift_.now().tyre_m - looked.tyre_m));
  return std::min(now_ - looked.at + driven, kNeverLooked);
}

void VisualMemory::observe(const ThingSeen& thing, const Pose2& X_OR, Micros t) {
  things_.observe(thing, X_OR, t, drift_);
  things_.prune(now_);
  ++version_;
}

void VisualMemory::forget() {
  things_.forget();
  points_.forget();
  floor_.forget();
  looked_.fill({});
  ++version_;
}

const Surroundings& VisualMemory::around() const {
  if (around_version_ != version_) around_ = Surroundings(points_, floor_, drift_, X_OR_);
  around_version_ = version_;
  return around_;
}

bool VisualMemory::way_clear(double bearing_rad, double width_m, double ahead_m) const {
  const double half_m = width_m / 2 + kSideMargin_m;
  const double angle = X_OR_.heading_rad + bearing_rad;
  const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
  const Eigen::Vector2d side(-along.y(), along.x());
  const Eigen::Vector2d here(X_OR_.x_m, X_OR_.y_m);
  for (const ObstaclePoint& point : points_.all()) {
    const Eigen::Vector2d to = point.p_O_m - here;
    const double ahead = to.dot(along);
    if (ahead > 0 && ahead < ahead_m && std::abs(to.dot(side)) < half_m) return false;
  }
  int unseen = 0;
  int all = 0;
  // Beside its front corners a robot never sees; floor begins where its width is in view.
  for (double ahead = std::min(kCornerPart * half_m, ahead_m); ahead <= ahead_m;
       ahead += FreeFloor::kCell_m) {
    for (double across = -half_m; across <= half_m; across += FreeFloor::kCell_m, ++all) {
      const Eigen::Vector2d p = here + ahead * along + across * side;
      unseen += floor_.seen_at(p.x(), p.y()) < 0 ? 1 : 0;
    }
  }
  // A square at the rim of the robot's width may lie between two looks.
  return all > 0 && unseen * 20 <= all;
}

}  // namespace mirada::memory
