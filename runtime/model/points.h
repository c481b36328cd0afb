#pragma once
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "base/json_reader.h"

namespace mirada {

/// Positions in files of rooms and places lie within this many metres of the origin.
inline constexpr double kFarthestPoint_m = 50;

/// A list of [x, y] points in metres; every point that is none is a fault of its own. Empty when the list is
/// broken, or absent where `min` is 0.
std::vector<Eigen::Vector2d> read_points(JsonReader& reader, std::string_view field, std::size_t min,
                                         std::size_t max);

}  // namespace mirada
