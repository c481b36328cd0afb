#pragma once
#include <memory>

#include "vm/catalog.h"

namespace mirada::vm {

/// Blocks that only imported Scratch projects have: say and think without a robot's pack, clones, shown
/// variables.
std::shared_ptr<const BlockCatalog> scratch_blocks();

}  // namespace mirada::vm
