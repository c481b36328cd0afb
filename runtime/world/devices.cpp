#include "world/devices.h"

#include <algorithm>
#include <cmath>

namespace mirada::world {
namespace {

// The word: 16 bits of stop count, then two signed 24-bit speeds in µm/s (up to 8.3 m/s).
constexpr double kUnits_per_mps = 1e6;
constexpr std::uint64_t kSpeedMask = 0xFFFFFF;
constexpr int kStopShift = 48;

std::uint64_t pack_speed(double mps) {
  return static_cast<std::uint64_t>(std::llround(mps * kUnits_per_mps)) & kSpeedMask;
}

double unpack_speed(std::uint64_t bits) {
  const auto shifted = static_cast<std::int32_t>(static_cast<std::uint32_t>(bits & kSpeedMask) << 8);
  return (shifted >> 8) / kUnits_per_mps;
}

double limited(double mps, double most) { return std::isfinite(mps) ? std::clamp(mps, -most, most) : 0; }

double approach(double from, double to, double most) { return from + std::clamp(to - from, -most, most); }

double in_range(double angle, const JointConfig& joint, double otherwise) {
  return std::isfinite(angle) ? std::clamp(angle, joint.min_rad, joint.max_rad) : otherwise;
}

}  // namespace

void SimDrive::set(const WheelSpeeds& speeds) {
  std::uint64_t seen = word_.load();
  const std::uint64_t stops = seen >> kStopShift;
  const double most = std::min(max_wheel_mps_, 8.0);
  const std::uint64_t wanted = (stops << kStopShift) | (pack_speed(limited(speeds.left_mps, most)) << 24) |
                               pack_speed(limited(speeds.right_mps, most));
  while (seen >> kStopShift == stops && !word_.compare_exchange_weak(seen, wanted)) {
  }
}

void SimDrive::stop() {
  std::uint64_t seen = word_.load();
  while (!word_.compare_exchange_weak(seen, ((seen >> kStopShift) + 1) << kStopShift)) {
  }
}

WheelSpeeds SimDrive::command() const {
  const std::uint64_t word = word_.load();
  return {unpack_speed(word >> 24), unpack_speed(word)};
}

hal::Odometry SimDrive::odometry() const {
  const std::lock_guard lock(mutex_);
  return odometry_;
}

void SimDrive::publish(const hal::Odometry& odometry) {
  const std::lock_guard lock(mutex_);
  odometry_ = odometry;
}

SimNeck::SimNeck(const NeckConfig& config) : config_(config) { reset(0); }

void SimNeck::aim(const NeckAngles& target) {
  const std::lock_guard lock(mutex_);
  target_.pan_rad = in_range(target.pan_rad, config_.pan, target_.pan_rad);
  target_.tilt_rad = in_range(target.tilt_rad, config_.tilt, target_.tilt_rad);
  state_.settled = target_.pan_rad == state_.angles.pan_rad && target_.tilt_rad == state_.angles.tilt_rad;
}

void SimNeck::hold() {
  const std::lock_guard lock(mutex_);
  target_ = state_.angles;
  state_.settled = true;
}

hal::NeckState SimNeck::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

void SimNeck::step(Micros dt, Micros now) {
  const std::lock_guard lock(mutex_);
  NeckAngles& at = state_.angles;
  at.pan_rad = approach(at.pan_rad, target_.pan_rad, config_.pan.max_radps * seconds(dt));
  at.tilt_rad = approach(at.tilt_rad, target_.tilt_rad, config_.tilt.max_radps * seconds(dt));
  state_.t = now;
  state_.settled = at.pan_rad == target_.pan_rad && at.tilt_rad == target_.tilt_rad;
}

void SimNeck::reset(Micros now) {
  const std::lock_guard lock(mutex_);
  target_ = {in_range(0, config_.pan, 0), in_range(0, config_.tilt, 0)};
  state_ = {now, target_, true};
}

}  // namespace mirada::world
