#include "robot/seeing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mirada::robot {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kNextReading_rad = rad(1.0);
constexpr double kSideMargin_m = 0.02;
constexpr double kCore_rad = rad(20);  // the strip's middle must be in the picture at all
constexpr double kGroundSlack_m = 0.01;

bool measured(Answer answer) { return answer == Answer::blocked || answer == Answer::clear; }

}  // namespace

SonarView::SonarView(const SonarPercept& sonar, const Pose2& X_OR_now, Micros now)
    : sonar_(&sonar),
      X_RS_(compose(inverse(X_OR_now), sonar.X_OR)),
      fresh_(sonar.frame != 0 && now - sonar.t_exposure <= kPerceptLife) {}

SonarReading SonarView::moved(const SonarReading& reading) const {
  SonarReading out = reading;
  if (!measured(reading.answer)) {
    out.bearing_rad = wrap_rad(reading.bearing_rad + X_RS_.heading_rad);
    return out;
  }
  const double angle_rad = reading.bearing_rad + X_RS_.heading_rad;
  const double x_m = X_RS_.x_m + reading.distance_m * std::cos(angle_rad);
  const double y_m = X_RS_.y_m + reading.distance_m * std::sin(angle_rad);
  out.bearing_rad = std::atan2(y_m, x_m);
  out.distance_m = std::hypot(x_m, y_m);
  return out;
}

bool SonarView::in_view(double bearing_rad) const {
  if (!fresh_ || sonar_->readings.empty()) return false;
  const double then_rad = bearing_rad - X_RS_.heading_rad;
  const double first_rad = sonar_->readings.front().bearing_rad;
  const double span_rad = wrap_rad(sonar_->readings.back().bearing_rad - first_rad);
  const double off_rad = wrap_rad(then_rad - first_rad);
  return off_rad > -kNextReading_rad && off_rad < span_rad + kNextReading_rad;
}

SonarReading SonarView::at(double bearing_rad) const {
  SonarReading best{bearing_rad, Answer::not_seen, kNaN, kNaN};
  if (!fresh_) return best;
  double best_off_rad = kNextReading_rad;
  for (const SonarReading& reading : sonar_->readings) {
    const SonarReading now = moved(reading);
    const double off_rad = std::abs(wrap_rad(now.bearing_rad - bearing_rad));
    if (off_rad >= best_off_rad) continue;
    best_off_rad = off_rad;
    best = now;
  }
  best.bearing_rad = bearing_rad;
  return best;
}

bool SonarView::way_clear(double width_m, double ahead_m) const {
  if (!fresh_) return false;
  const double half_m = width_m / 2 + kSideMargin_m;
  double rightmost_rad = 0;
  double leftmost_rad = 0;
  for (const SonarReading& reading : sonar_->readings) {
    const SonarReading now = moved(reading);
    if (std::abs(now.bearing_rad) > rad(85)) continue;
    rightmost_rad = std::min(rightmost_rad, now.bearing_rad);
    leftmost_rad = std::max(leftmost_rad, now.bearing_rad);
    const double across = std::abs(std::sin(now.bearing_rad));
    const double leaves_m = across > 0 ? half_m / across : std::numeric_limits<double>::infinity();
    const double needed_m = std::min(ahead_m / std::cos(now.bearing_rad), leaves_m);
    if (!measured(now.answer) || now.distance_m < needed_m - kGroundSlack_m) return false;
  }
  const double core_rad = std::min(std::atan2(half_m, ahead_m), kCore_rad);
  return rightmost_rad <= -core_rad && leftmost_rad >= core_rad;
}

std::optional<SonarReading> SonarView::nearest_obstacle() const {
  if (!fresh_) return std::nullopt;
  std::optional<SonarReading> nearest;
  for (const SonarReading& reading : sonar_->readings) {
    if (reading.answer != Answer::blocked) continue;
    const SonarReading now = moved(reading);
    if (!nearest || now.distance_m < nearest->distance_m) nearest = now;
  }
  return nearest;
}

}  // namespace mirada::robot
