#pragma once
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "world/world_config.h"

namespace mirada::rig {

/// How a laboratory room is lit.
enum class LabLight {
  even,  ///< soft light from everywhere
  side,  ///< a low sun: hard shadows, a strong fall across the room
  dim    ///< half the light, coloured, noisier
};
const char* to_string(LabLight light);
const char* to_string(world::FloorKind floor);
std::optional<LabLight> lab_light_from(std::string_view name);
std::optional<world::FloorKind> lab_floor_from(std::string_view name);

/// A room that nobody designed: walls, boxes and cylinders of any look at any place, a floor of this kind
/// with any colour, some with painted lines; and places to look from. The same arguments give the same room.
struct LabRoom {
  world::WorldConfig world;
  std::vector<Pose2> stands;  ///< X_WR; nothing nearer than 0.25 m
};
LabRoom lab_room(world::FloorKind floor, LabLight light, std::uint64_t seed);

}  // namespace mirada::rig
