#pragma once
#include <vector>

#include "model/camera_model.h"

namespace mirada::world {

/// Where each pixel of a camera looks: rays (x, y, 1) in the optical frame, exact with distortion, made once.
/// The picture is cut into square tiles whose corner rays are kept too.
struct RayTable {
  static constexpr int kTile_px = 8;

  explicit RayTable(const CameraModel& camera);

  int width, height;
  int tiles_x, tiles_y;
  float fx_px, fy_px;
  std::vector<float> x, y;                ///< a pixel's middle, row by row, width + padding of `stride`
  std::vector<std::uint8_t> sees;         ///< 0 where the lens has no image
  std::vector<float> corner_x, corner_y;  ///< of the tiles, rows of tiles_x + 1
  int stride;                             ///< a multiple of the tile
};

}  // namespace mirada::world
