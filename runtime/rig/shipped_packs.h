#pragma once
#include <memory>

#include "blocks/native_blocks.h"
#include "packs/packs.h"

namespace mirada::rig {

/// The block packs that ship (data folder "blocks"), their native blocks acting on this link.
packs::PackSet shipped_packs(const std::shared_ptr<const blocks::Link>& link);

}  // namespace mirada::rig
