#include "rig/lab/paper_geometry.h"

#include <cmath>

namespace mirada::rig {

std::optional<Eigen::Vector2d> PaperGeometry::floor_point(const Eigen::Vector2d& pixel) const {
  const double scale = 320.0 / width_px;
  const double u = pixel.x() * scale;
  const double v = pixel.y() * scale * (static_cast<double>(width_px) * 240 / 320) / height_px;
  // Its "optical" pixel: x up, y right. u0 is cy as it was, fx goes with x.
  const double up = (239 - v - kPaperK[3]) / kPaperK[0];
  const double left = -(u - kPaperK[2]) / kPaperK[1];
  const double c = std::cos(tilt_rad);
  const double s = std::sin(tilt_rad);
  const double forward = c + s * up;
  const double drop = s - c * up;
  if (drop <= 1e-9) return std::nullopt;
  const double reach = eye_height_m / drop;
  const double x = forward * reach;
  const double y = left * reach;
  return Eigen::Vector2d(p_RC_m.x() + std::cos(pan_rad) * x - std::sin(pan_rad) * y,
                         p_RC_m.y() + std::sin(pan_rad) * x + std::cos(pan_rad) * y);
}

}  // namespace mirada::rig
