#pragma once
#include "model/robot_config.h"
#include "robot/detectors.h"

namespace mirada::rig {

/// The vision that this robot sees with. The face finder is opened when it is first used.
robot::Detectors make_detectors(const RobotConfig& robot);

}  // namespace mirada::rig
