#include "world/render/ray_table.h"

namespace mirada::world {
namespace {

int tiles(int pixels) { return (pixels + RayTable::kTile_px - 1) / RayTable::kTile_px; }

}  // namespace

RayTable::RayTable(const CameraModel& camera)
    : width(camera.width_px),
      height(camera.height_px),
      tiles_x(tiles(width)),
      tiles_y(tiles(height)),
      fx_px(static_cast<float>(camera.fx_px)),
      fy_px(static_cast<float>(camera.fy_px)),
      stride(tiles_x * kTile_px) {
  // Pixels past the picture's edge only fill up tiles; where the lens has no image there, the pinhole's ray
  // will do.
  const auto ray = [&](double u, double v, std::vector<float>& xs, std::vector<float>& ys) {
    const std::optional<Eigen::Vector3d> exact = camera.unproject({u, v});
    xs.push_back(static_cast<float>(exact ? exact->x() : (u - camera.cx_px) / camera.fx_px));
    ys.push_back(static_cast<float>(exact ? exact->y() : (v - camera.cy_px) / camera.fy_px));
    return exact.has_value();
  };
  for (int v = 0; v < tiles_y * kTile_px; ++v) {
    for (int u = 0; u < stride; ++u) sees.push_back(ray(u, v, x, y) ? 1 : 0);
  }
  for (int v = 0; v <= tiles_y; ++v) {
    for (int u = 0; u <= tiles_x; ++u) ray(u * kTile_px - 0.5, v * kTile_px - 0.5, corner_x, corner_y);
  }
}

}  // namespace mirada::world
