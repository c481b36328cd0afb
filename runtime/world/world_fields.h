#pragma once
#include <string_view>

#include "base/json_reader.h"
#include "world/world_config.h"

namespace mirada::world {

/// "#rrggbb"; `fallback` when the field is absent.
Colour read_colour(JsonReader& reader, std::string_view field, Colour fallback);
/// x_m, y_m (needed) and heading_deg (0 when absent).
Pose2 read_pose(JsonReader& reader);

// One section of the file each; every one reports all of its faults and unknown fields.
FloorConfig read_floor(JsonReader reader);
LineConfig read_line(JsonReader reader);
WallConfig read_wall(JsonReader reader);
BoxConfig read_box(JsonReader reader);
CylinderConfig read_cylinder(JsonReader reader);
PersonConfig read_person(JsonReader reader);
TagConfig read_tag(JsonReader reader);

}  // namespace mirada::world
