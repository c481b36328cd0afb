#pragma once
#include <atomic>
#include <mutex>

#include "hal/drive.h"
#include "hal/neck.h"
#include "model/robot_config.h"

namespace mirada::world {

/// The simulated wheels as a program sees them. The command is one atomic word {stops so far, left, right} in
/// µm/s: a set() writes it only if no stop() came since that set() was called, so an older set() never
/// overtakes a stop(). stop() takes no lock and waits for nothing; the next step() of the simulation already
/// brakes.
class SimDrive final : public hal::Drive {
 public:
  explicit SimDrive(double max_wheel_mps) : max_wheel_mps_(max_wheel_mps) {}

  void set(const WheelSpeeds& speeds) override;
  void stop() override;
  hal::Odometry odometry() const override;

  /// The simulation's side: what is wanted now, and what the encoders say.
  WheelSpeeds command() const;
  void publish(const hal::Odometry& odometry);

 private:
  double max_wheel_mps_;
  std::atomic<std::uint64_t> word_{0};
  mutable std::mutex mutex_;
  hal::Odometry odometry_;
};

/// A pan-tilt servo with range and speed. Any thread may aim.
class SimNeck final : public hal::Neck {
 public:
  explicit SimNeck(const NeckConfig& config);

  void aim(const NeckAngles& target) override;
  void hold() override;
  hal::NeckState state() const override;

  void step(Micros dt, Micros now);
  /// At the middle (as near to zero as the range allows), at rest.
  void reset(Micros now);

 private:
  NeckConfig config_;
  mutable std::mutex mutex_;
  NeckAngles target_;
  hal::NeckState state_;
};

}  // namespace mirada::world
