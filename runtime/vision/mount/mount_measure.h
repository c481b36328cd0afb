#pragma once
#include "base/result.h"
#include "model/robot_config.h"
#include "vision/mount/floor_sight.h"

namespace mirada::vision {

/// Everything that makes a measured attitude implausible for this robot: not on the floor, upside down, too
/// unsure, or far from what the robot's file says (a wrong square or tag size). Empty when it can be
/// believed.
Faults doubt(const FloorSight& sight, const RobotConfig& robot, const NeckAngles& neck);

/// The robot's mount with height, tilt, roll and their sigma as measured with the neck at `neck`. `sight`
/// must have a height.
MountConfig measured_mount(const RobotConfig& robot, const NeckAngles& neck, const FloorSight& sight);

/// What the start-up check says.
struct MountCheck {
  enum class Verdict { fine, knocked, cannot_tell };
  Verdict verdict = Verdict::cannot_tell;
  double height_off_m = 0;  ///< measured minus what the mount says; NaN for a horizon
  double tilt_off_rad = 0;
  double roll_off_rad = 0;
  Faults words;  ///< one sentence a thing that is off; warnings
};

/// Compares what is seen now (a board, a tag on the floor, a horizon) with the mount in the robot's file:
/// knocked when it is off by more than three sigma of both and half a degree (or 3 % of the height). Cannot
/// tell when the sight itself is unsure. For use before a program starts; one thread.
MountCheck check_mount(const RobotConfig& robot, const NeckAngles& neck, const FloorSight& sight);

}  // namespace mirada::vision
