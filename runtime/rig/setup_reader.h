#pragma once
#include <string>
#include <vector>

#include "rig/live_robot.h"
#include "session/station.h"

namespace mirada::rig {

/// Whether somebody far away may ask for this: what ships, or what the station has now. A path would open any
/// file of this computer.
Status only_offered(const session::Setup& asked, const session::Setup& now);

/// Reads the files that a setup names (ids or paths; "" = the first that ships): every fault of room and
/// robot at once. The setup of the result holds the real ids. A calibration that was kept for this robot is
/// used; one that does not fit is not, and `notes` says why.
Result<LiveParts> read_setup(const session::Setup& setup, const std::string& camera);

/// What ships, with its names.
std::vector<session::Option> world_options();
std::vector<session::Option> robot_options();
std::vector<session::Option> camera_options();

}  // namespace mirada::rig
