#pragma once
#include "hal/neck.h"
#include "model/robot_config.h"

namespace mirada::robot {

/// Where the camera looks. The newest target wins. Control thread.
class Gaze {
 public:
  /// `neck` may be null: a fixed camera.
  Gaze(hal::Neck* neck, const NeckConfig& config) : neck_(neck), config_(config) {}

  bool can_pan() const { return neck_ != nullptr && config_.pan.max_rad > config_.pan.min_rad; }
  bool can_tilt() const { return neck_ != nullptr && config_.tilt.max_rad > config_.tilt.min_rad; }
  const JointConfig& pan_joint() const { return config_.pan; }
  const JointConfig& tilt_joint() const { return config_.tilt; }
  /// Aims one joint at the nearest angle within its range, which is returned; the other goes where it was
  /// going. Pan is positive left, tilt positive down.
  double pan_to(double pan_rad);
  double tilt_to(double tilt_rad);
  /// Straight ahead again, level.
  void look_ahead();
  void hold();
  /// Stands still for a while, then goes on to where it was going.
  void pause(bool on);
  hal::NeckState state(Micros now) const;

 private:
  hal::Neck* neck_;
  NeckConfig config_;
  NeckAngles target_;
};

}  // namespace mirada::robot
