#pragma once
#include <atomic>

#include "hal/drive.h"
#include "hal/neck.h"
#include "model/robot_config.h"

namespace mirada::rig {

/// Wheels that do at once and exactly what they are told: the body of a run without a world. step() and set()
/// on one thread, stop() on any.
class IdealDrive final : public hal::Drive {
 public:
  explicit IdealDrive(const DriveConfig& config) : track_m_(config.track_m) {}

  void step(Micros dt);
  double path_m() const { return path_m_; }

  void set(const WheelSpeeds& speeds) override;
  void stop() override { stopped_.store(true); }
  hal::Odometry odometry() const override { return odometry_; }

 private:
  double track_m_;
  WheelSpeeds speeds_;
  std::atomic<bool> stopped_{false};
  hal::Odometry odometry_;
  double path_m_ = 0;
};

/// A neck that is where it should be at its joints' speed.
class IdealNeck final : public hal::Neck {
 public:
  explicit IdealNeck(const NeckConfig& config) : config_(config) {}

  void step(Micros dt);

  void aim(const NeckAngles& target) override { target_ = target; }
  void hold() override { target_ = state_.angles; }
  hal::NeckState state() const override;

 private:
  NeckConfig config_;
  NeckAngles target_;
  hal::NeckState state_;
};

}  // namespace mirada::rig
