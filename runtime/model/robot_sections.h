#pragma once
#include "base/json_reader.h"
#include "model/robot_config.h"

namespace mirada {

// The parts of robot.json, one function each (docs/robot-json.md). Each adds every fault it finds to the
// reader's list and leaves a harmless value where one was wrong. For read_robot alone.

void read_camera(JsonReader& json, RobotConfig& robot);
/// Drive and footprint.
void read_body(JsonReader& json, RobotConfig& robot);
/// Neck and mount: the chain of poses. Heights in the file are above the floor; in RobotConfig they are
/// offsets.
void read_chain(JsonReader& json, RobotConfig& robot);

}  // namespace mirada
