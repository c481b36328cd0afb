#include "world/wheels.h"

#include <algorithm>
#include <cmath>

namespace mirada::world {
namespace {

double approach(double from, double to, double most) { return from + std::clamp(to - from, -most, most); }

/// The pose after rolling along an arc: exact for constant wheel speeds.
Pose2 arc(double left_m, double right_m, double track_m) {
  const double turn = (right_m - left_m) / track_m;
  const double length = (left_m + right_m) / 2;
  const double half = turn / 2;
  const double chord = std::abs(half) < 1e-9 ? length : length * std::sin(half) / half;
  return {chord * std::cos(half), chord * std::sin(half), turn};
}

}  // namespace

Wheels::Wheels(const DriveConfig& drive, const NoiseConfig& noise, std::uint64_t seed)
    : drive_(drive), noise_(noise), seed_(seed), slip_(seed, "wheel slip") {
  Random sizes(seed, "wheel sizes");
  left_scale_ = 1 + noise_.wheel_scale * sizes.gaussian();
  right_scale_ = 1 + noise_.wheel_scale * sizes.gaussian();
}

double Wheels::floor_distance(double turned_m, double scale) {
  if (turned_m == 0) return 0;
  return turned_m * scale + noise_.wheel_slip * std::sqrt(std::abs(turned_m)) * slip_.gaussian();
}

Pose2 Wheels::step(const WheelSpeeds& command, Micros dt) {
  const double dt_s = seconds(dt);
  const double most = drive_.max_accel_mps2 * dt_s;
  const double limit = drive_.max_wheel_mps;
  const WheelSpeeds before = speed_;
  speed_.left_mps = approach(speed_.left_mps, std::clamp(command.left_mps, -limit, limit), most);
  speed_.right_mps = approach(speed_.right_mps, std::clamp(command.right_mps, -limit, limit), most);
  const double left = (before.left_mps + speed_.left_mps) / 2 * dt_s;
  const double right = (before.right_mps + speed_.right_mps) / 2 * dt_s;
  X_OR_ = compose(X_OR_, arc(left, right, drive_.track_m));
  const double true_left = floor_distance(left, left_scale_);
  const double true_right = floor_distance(right, right_scale_);
  return arc(true_left, true_right, drive_.track_m);
}

void Wheels::reset() {
  speed_ = {};
  slip_ = Random(seed_, "wheel slip");
}

}  // namespace mirada::world
