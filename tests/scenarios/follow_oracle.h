#pragma once
#include <deque>

#include "model/robot_config.h"
#include "world/world_config.h"

namespace mirada::scenarios {

/// Follows by the truth of a moment ago: knows where somebody was and how they walked, but not what they will
/// do next; its wheels are the robot's.
class FollowOracle {
 public:
  FollowOracle(const DriveConfig& drive, const Pose2& X_WR, double keep_m, double delay_s)
      : drive_(drive), X_WR_(X_WR), keep_m_(keep_m), delay_s_(delay_s) {}

  /// Where it is `dt_s` later, with the person there.
  Pose2 step(const Pose2& person, double dt_s);
  /// Whether the camera of a neck that turns 80 degrees shows them in its middle.
  bool sees() const { return sees_; }

 private:
  DriveConfig drive_;
  Pose2 X_WR_;
  double keep_m_;
  double delay_s_;
  std::deque<Pose2> person_;
  bool sees_ = true;
  double left_mps_ = 0, right_mps_ = 0;
};

}  // namespace mirada::scenarios
