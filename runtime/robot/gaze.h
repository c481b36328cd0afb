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
  const JointConfig& pan_joint() const { return config_.pan; }
  /// Aims at the nearest angle within the joint's range, which is returned. Positive left.
  double pan_to(double pan_rad);
  /// Straight ahead again.
  void look_ahead() { pan_to(0); }
  void hold();
  hal::NeckState state(Micros now) const;

 private:
  hal::Neck* neck_;
  NeckConfig config_;
};

}  // namespace mirada::robot
