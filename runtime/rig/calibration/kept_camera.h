#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "model/robot_config.h"

namespace mirada::rig {

/// Where the calibration of a robot's camera is kept: the file that robot.json's "calibration" names, else
/// <robot>.camera.json beside the robot's file; for a robot that ships, in the user's own folder
/// (XDG_DATA_HOME/mirada/cameras). The simulated camera's is a file of its own: another lens took it.
std::filesystem::path kept_camera_file(const std::string& robot, bool simulated);

/// Puts a kept calibration into the robot. Ok also when there is none; else why it is not used, in words.
Status use_kept_camera(const std::filesystem::path& file, RobotConfig& robot);

/// Writes the calibration; the file that was there before stays under another name, which is returned.
Result<std::optional<std::filesystem::path>> keep_camera(const std::filesystem::path& file,
                                                         const std::string& camera_json);

}  // namespace mirada::rig
