#include "rig/ideal_body.h"

#include <algorithm>
#include <cmath>

namespace mirada::rig {
namespace {

double toward(double from, double to, double most) { return from + std::clamp(to - from, -most, most); }

}  // namespace

void IdealDrive::set(const WheelSpeeds& speeds) {
  stopped_.store(false);
  speeds_ = speeds;
}

void IdealDrive::step(Micros dt) {
  if (stopped_.exchange(false)) speeds_ = {};
  const double dt_s = seconds(dt);
  const double forward_m = (speeds_.left_mps + speeds_.right_mps) / 2 * dt_s;
  const double turned_rad = (speeds_.right_mps - speeds_.left_mps) / track_m_ * dt_s;
  const double middle_rad = odometry_.X_OR.heading_rad + turned_rad / 2;
  odometry_.X_OR.x_m += forward_m * std::cos(middle_rad);
  odometry_.X_OR.y_m += forward_m * std::sin(middle_rad);
  odometry_.X_OR.heading_rad = wrap_rad(odometry_.X_OR.heading_rad + turned_rad);
  odometry_.speed = speeds_;
  odometry_.t += dt;
  path_m_ += std::abs(forward_m);
}

void IdealNeck::step(Micros dt) {
  const double dt_s = seconds(dt);
  state_.t += dt;
  state_.angles.pan_rad = toward(state_.angles.pan_rad, target_.pan_rad, config_.pan.max_radps * dt_s);
  state_.angles.tilt_rad = toward(state_.angles.tilt_rad, target_.tilt_rad, config_.tilt.max_radps * dt_s);
}

hal::NeckState IdealNeck::state() const {
  hal::NeckState now = state_;
  now.settled = now.angles.pan_rad == target_.pan_rad && now.angles.tilt_rad == target_.tilt_rad;
  return now;
}

}  // namespace mirada::rig
