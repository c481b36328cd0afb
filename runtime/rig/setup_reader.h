#pragma once
#include <string>
#include <vector>

#include "rig/live_robot.h"
#include "session/station.h"

namespace mirada::rig {

/// Reads the files that a setup names (ids or paths; "" = the first that ships): every fault of room and
/// robot at once. The setup of the result holds the real ids.
Result<LiveParts> read_setup(const session::Setup& setup, const std::string& camera);

/// What ships, with its names.
std::vector<session::Option> world_options();
std::vector<session::Option> robot_options();

}  // namespace mirada::rig
