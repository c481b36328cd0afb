#pragma once
#include <set>
#include <string>

#include "robot/robot.h"
#include "vm/machine.h"

namespace mirada::session {

/// What blocks that name these `needs` must see.
robot::Needs needs_of(const std::set<std::string>& names);

/// What this one block and the reporters in it name, wherever it lies: the program's own needs leave out what
/// cannot run.
std::set<std::string> needs_of_block(const std::string& program_json, const std::string& block_id,
                                     const vm::LoadedProgram& program, const vm::BlockCatalog& catalog);

/// Whether everything needed has been seen lately, or never will be.
bool seen_enough(const robot::Robot& robot, const robot::Needs& needs);

}  // namespace mirada::session
