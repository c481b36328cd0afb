#pragma once
#include <cstdint>

#include "world/world_config.h"

namespace mirada::world {

/// The room as this seed has it: start pose, obstacles and light moved by chance within the file's jitter.
/// Obstacles that would come nearer than `room_m` to the start or to each other stay where the file put them.
WorldConfig placed(const WorldConfig& world, std::uint64_t seed, double room_m);

}  // namespace mirada::world
