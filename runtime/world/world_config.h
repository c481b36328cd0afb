#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "model/geometry.h"

namespace mirada::world {

/// world.json as read; the world/ room extends this struct (floor, lines, walls, obstacles, people, light, noise).
struct WorldConfig {
    std::string id;
    std::string name_en;
    std::string name_es;
    Pose2 X_WR_start;
};

Result<WorldConfig> read_world(std::string_view json_text, const std::string& file_name, Faults* warnings = nullptr);
/// The ids of the rooms that ship (runtime/world/rooms/<id>.json), sorted; one of them, or a file by path.
std::vector<std::string> shipped_worlds();
Result<WorldConfig> world_by_name(const std::string& id_or_path, Faults* warnings = nullptr);

}  // namespace mirada::world
