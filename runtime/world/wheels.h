#pragma once
#include "base/random.h"
#include "base/units.h"
#include "hal/drive.h"
#include "model/robot_config.h"
#include "world/world_config.h"

namespace mirada::world {

/// Two wheels with limited acceleration. The encoders count what the motors turned; the floor gets that with
/// each wheel's own size error and slip, so that odometry drifts from the truth.
class Wheels {
 public:
  Wheels(const DriveConfig& drive, const NoiseConfig& noise, std::uint64_t seed);

  /// Turns the wheels for dt towards the commanded speeds; gives the robot's displacement on the floor
  /// (X_RR').
  Pose2 step(const WheelSpeeds& command, Micros dt);
  const Pose2& X_OR() const { return X_OR_; }
  const WheelSpeeds& speed() const { return speed_; }
  /// At rest, chance as at the beginning; odometry goes on.
  void reset();

 private:
  double floor_distance(double turned_m, double scale);

  DriveConfig drive_;
  NoiseConfig noise_;
  std::uint64_t seed_;
  Random slip_;
  double left_scale_ = 1;
  double right_scale_ = 1;
  WheelSpeeds speed_;
  Pose2 X_OR_;
};

}  // namespace mirada::world
