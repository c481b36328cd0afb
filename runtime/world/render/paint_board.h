#pragma once
#include <cstdint>
#include <vector>

#include "world/held_board.h"
#include "world/render/ray_table.h"

namespace mirada::world {

/// Lays a held print over a picture (rows of rays.stride, BGRA), through the lens as everything else: each
/// pixel is the mean of 16 rays, so its corners lie where CameraModel::project says.
void paint_board(const RayTable& rays, const HeldBoard& board, std::vector<std::uint32_t>& bgra);

}  // namespace mirada::world
