#pragma once
#include <algorithm>
#include <cmath>
#include <deque>
#include <vector>

#include "base/clock.h"
#include "hal/camera.h"
#include "hal/drive.h"
#include "hal/neck.h"

namespace mirada::robot {

/// Wheels that lag behind their command by their acceleration, as real ones do, and remember what they were
/// told.
class LaggingDrive final : public hal::Drive {
 public:
  explicit LaggingDrive(double accel_mps2 = 1.0, double track_m = 0.15)
      : accel_(accel_mps2), track_m_(track_m) {}

  void set(const WheelSpeeds& speeds) override {
    told_.push_back(speeds);
    target_ = speeds;
  }
  void stop() override {
    ++stops_;
    target_ = {};
  }
  hal::Odometry odometry() const override { return odometry_; }

  void step(Micros dt) {
    const double dt_s = seconds(dt);
    const double most = blocked_ ? 0 : accel_ * dt_s;
    WheelSpeeds& now = odometry_.speed;
    now.left_mps += std::clamp(target_.left_mps - now.left_mps, -most, most);
    now.right_mps += std::clamp(target_.right_mps - now.right_mps, -most, most);
    const double forward_m = (now.left_mps * (1 + left_error_) + now.right_mps) / 2 * dt_s;
    const double turned_rad = (now.right_mps - now.left_mps * (1 + left_error_)) / track_m_ * dt_s;
    Pose2& pose = odometry_.X_OR;
    pose.x_m += forward_m * std::cos(pose.heading_rad + turned_rad / 2);
    pose.y_m += forward_m * std::sin(pose.heading_rad + turned_rad / 2);
    pose.heading_rad = wrap_rad(pose.heading_rad + turned_rad);
    odometry_.t += dt;
  }

  std::vector<WheelSpeeds> told_;
  int stops_ = 0;
  bool blocked_ = false;
  double left_error_ = 0;
  WheelSpeeds target_;

 private:
  double accel_;
  double track_m_;
  hal::Odometry odometry_;
};

class ListCamera final : public hal::Camera {
 public:
  std::optional<Frame> poll() override {
    if (waiting_.empty()) return std::nullopt;
    Frame frame = waiting_.back();
    waiting_.clear();
    return frame;
  }
  Status health() const override { return Ok{}; }
  void enable(bool on) override { enabled_ = on; }

  void offer(std::uint64_t number, Micros t_exposure) { waiting_.push_back({cv::Mat(), t_exposure, number}); }

  std::deque<Frame> waiting_;
  bool enabled_ = false;
};

class PlainNeck final : public hal::Neck {
 public:
  void aim(const NeckAngles& target) override { target_ = target; }
  void hold() override { target_ = state_.angles; }
  hal::NeckState state() const override { return state_; }

  NeckAngles target_;
  hal::NeckState state_;
};

}  // namespace mirada::robot
