#include "memory/surroundings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mirada::memory {
namespace {

using Eigen::Vector2d;

constexpr double kHalfSpacing_m = 0.025;  // neighbouring places of one thing are at most twice this apart
constexpr double kWidest_rad = rad(12);
constexpr double kStep_m = 0.03;
constexpr double kFarthest_m = 5;
constexpr double kGap_m = 0.13;   // squares between two looks may have been missed; more was not looked at
constexpr double kBody_m = 0.18;  // what the robot stands on is no answer
constexpr double kFloorSigma_m = 0.04;

/// The degree nearest to a direction of the robot's frame, 0 to 359: arctangent by Hastings' polynomial,
/// right to a thousandth of a degree, for thousands of places a picture.
int degree_of(const Vector2d& to_R) {
  const double x = std::abs(to_R.x());
  const double y = std::abs(to_R.y());
  const double less = std::min(x, y) / std::max(std::max(x, y), 1e-9);
  const double s = less * less;
  double angle = 0.0208351;
  for (const double factor : {-0.0851330, 0.1801410, -0.3302995, 0.9998660}) angle = angle * s + factor;
  angle *= less;
  if (y > x) angle = std::numbers::pi / 2 - angle;
  if (to_R.x() < 0) angle = std::numbers::pi - angle;
  if (to_R.y() < 0) angle = 2 * std::numbers::pi - angle;
  const int degree = static_cast<int>(deg(angle) + 0.5);
  return degree < Surroundings::kDirections ? degree : 0;
}

}  // namespace

std::size_t Surroundings::index(double bearing_rad) {
  const long degree = std::lround(deg(wrap_rad(bearing_rad)));
  return static_cast<std::size_t>((degree + kDirections) % kDirections);
}

void Surroundings::put_points(const ObstaclePoints& points, const DriftLedger& drift, const Pose2& X_OR) {
  std::array<const ObstaclePoint*, kDirections> nearest{};
  const Vector2d here(X_OR.x_m, X_OR.y_m);
  const double c = std::cos(X_OR.heading_rad);
  const double s = std::sin(X_OR.heading_rad);
  for (const ObstaclePoint& point : points.all()) {
    const Vector2d to = point.p_O_m - here;
    const double distance_m = to.norm();
    const int middle = degree_of({c * to.x() + s * to.y(), c * to.y() - s * to.x()});
    const double half_rad = std::min(kHalfSpacing_m / std::max(distance_m, 0.01), kWidest_rad);
    const int spread = static_cast<int>(deg(half_rad) + 0.5);
    for (int off = -spread; off <= spread; ++off) {
      const int turned = middle + off;
      const auto i = static_cast<std::size_t>(turned < 0              ? turned + kDirections
                                              : turned >= kDirections ? turned - kDirections
                                                                      : turned);
      if (nearest[i] != nullptr && all_[i].distance_m <= distance_m) continue;
      nearest[i] = &point;
      all_[i].distance_m = distance_m;
    }
  }
  for (std::size_t i = 0; i < nearest.size(); ++i) {
    if (nearest[i] == nullptr) continue;
    const ObstaclePoint& point = *nearest[i];
    const Vector2d along = (point.p_O_m - here).normalized();
    all_[i].answer = Answer::blocked;
    all_[i].sigma_m = std::sqrt(along.dot(point.covariance(drift) * along));
    all_[i].seen_at = point.seen_at;
  }
}

void Surroundings::walk(int i, const FreeFloor& floor, const Pose2& X_OR) {
  Direction& direction = all_[static_cast<std::size_t>(i)];
  const bool blocked = direction.answer == Answer::blocked;
  const double until_m = blocked ? direction.distance_m : kFarthest_m;
  const double angle = X_OR.heading_rad + rad(i);
  const double step_x = std::cos(angle);
  const double step_y = std::sin(angle);
  double seen_to_m = 0;
  Micros oldest = blocked ? direction.seen_at : -1;
  for (double at = 0; at < until_m; at += kStep_m) {
    const Micros seen = floor.seen_at(X_OR.x_m + at * step_x, X_OR.y_m + at * step_y);
    if (seen < 0) {
      if (at - seen_to_m > kGap_m) break;
      continue;
    }
    seen_to_m = at;
    oldest = oldest < 0 ? seen : std::min(oldest, seen);
  }
  direction.free_m = seen_to_m;
  // An obstacle behind floor that nobody looked at: something nearer may stand there.
  if (blocked && until_m - seen_to_m <= kGap_m + kStep_m) {
    direction.seen_at = oldest;
    return;
  }
  const bool some = seen_to_m > kBody_m;
  direction = {some ? Answer::clear : Answer::not_seen, some ? seen_to_m : 0, some ? kFloorSigma_m : 0,
               some ? seen_to_m : 0, some ? oldest : 0};
}

Surroundings::Surroundings(const ObstaclePoints& points, const FreeFloor& floor, const DriftLedger& drift,
                           const Pose2& X_OR) {
  put_points(points, drift, X_OR);
  for (int i = 0; i < kDirections; ++i) walk(i, floor, X_OR);
}

}  // namespace mirada::memory
