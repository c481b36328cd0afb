#pragma once
#include <memory>
#include <string>

#include "model/robot_config.h"
#include "robot/detectors.h"

namespace mirada::rig {

/// The vision that this robot sees with. The face finder is opened when it is first used; `face_model` is a
/// network's file, "" = the one that was fetched, or none; `book`: who is known.
robot::Detectors make_detectors(const RobotConfig& robot, const std::string& face_model,
                                std::shared_ptr<vision::FaceBook> book);

}  // namespace mirada::rig
