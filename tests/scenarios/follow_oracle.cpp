#include "follow_oracle.h"

#include <algorithm>
#include <cmath>

namespace mirada::scenarios {
namespace {

using Eigen::Vector2d;

constexpr double kKeepGain_per_s = 3;
constexpr double kTurnGain_per_s = 3;
constexpr double kHeadway_s = 0.35;
constexpr double kNeck_rad = rad(80);
constexpr double kMiddle_rad = rad(10);
constexpr double kWalls_m = 3.9;  // of follow_room()

}  // namespace

Pose2 FollowOracle::step(const Pose2& person, double dt_s) {
  person_.push_back(person);
  const double delay_s = std::min(delay_s_, dt_s * static_cast<double>(person_.size() - 1));
  if (static_cast<double>(person_.size()) * dt_s > delay_s_ + 3 * dt_s) person_.pop_front();
  const Pose2& then = person_.front();
  const Pose2& next = person_[std::min<std::size_t>(1, person_.size() - 1)];
  const Vector2d v((next.x_m - then.x_m) / dt_s, (next.y_m - then.y_m) / dt_s);
  const Vector2d to = Vector2d(next.x_m - X_WR_.x_m, next.y_m - X_WR_.y_m) + delay_s * v;
  const double bearing_rad = wrap_rad(std::atan2(to.y(), to.x()) - X_WR_.heading_rad);
  sees_ = std::abs(bearing_rad) < kNeck_rad + kMiddle_rad;
  const double theirs = v.dot(to.normalized());
  const double off_m = to.norm() - keep_m_ - kHeadway_s * theirs;
  const double forward = (theirs + kKeepGain_per_s * off_m) * std::max(0.0, std::cos(bearing_rad));
  const double half_m = drive_.track_m / 2;
  const double turn_mps =
      half_m * std::clamp(kTurnGain_per_s * bearing_rad, -drive_.turn_radps, drive_.turn_radps);
  const double scale = std::min(1.0, drive_.max_wheel_mps / (std::abs(forward) + std::abs(turn_mps) + 1e-9));
  const double most = drive_.max_accel_mps2 * dt_s;
  left_mps_ += std::clamp(scale * (forward - turn_mps) - left_mps_, -most, most);
  right_mps_ += std::clamp(scale * (forward + turn_mps) - right_mps_, -most, most);
  const double along_m = (left_mps_ + right_mps_) / 2 * dt_s;
  X_WR_.heading_rad = wrap_rad(X_WR_.heading_rad + (right_mps_ - left_mps_) / drive_.track_m * dt_s);
  X_WR_.x_m = std::clamp(X_WR_.x_m + along_m * std::cos(X_WR_.heading_rad), -kWalls_m, kWalls_m);
  X_WR_.y_m = std::clamp(X_WR_.y_m + along_m * std::sin(X_WR_.heading_rad), -kWalls_m, kWalls_m);
  return X_WR_;
}

}  // namespace mirada::scenarios
