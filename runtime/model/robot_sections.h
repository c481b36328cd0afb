#pragma once
#include <filesystem>

#include "base/json_reader.h"
#include "model/robot_config.h"

namespace mirada {

// The parts of robot.json, one function each (docs/robot-json.md). Each adds every fault it finds to the
// reader's list and leaves a harmless value where one was wrong. For read_robot alone.

/// `folder`: where the robot's file stands; "calibration" names a camera.json from there. What is wrong
/// inside that file goes to `file_faults`, with that file's own places.
void read_camera(JsonReader& json, const std::filesystem::path& folder, RobotConfig& robot,
                 Faults& file_faults);
/// Size, view, centre and distortion: what robot.json's camera and a camera.json have in common.
void read_camera_model(JsonReader& json, CameraModel& camera);
/// Drive and footprint.
void read_body(JsonReader& json, RobotConfig& robot);
/// Neck and mount: the chain of poses. Heights in the file are above the floor; in RobotConfig they are
/// offsets.
void read_chain(JsonReader& json, RobotConfig& robot);

}  // namespace mirada
