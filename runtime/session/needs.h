#pragma once
#include <set>
#include <string>

#include "robot/robot.h"

namespace mirada::session {

/// What blocks that name these `needs` must see.
robot::Needs needs_of(const std::set<std::string>& names);

/// Whether everything needed has been seen lately, or never will be.
bool seen_enough(const robot::Robot& robot, const robot::Needs& needs);

}  // namespace mirada::session
