#pragma once
#include <optional>

#include <Eigen/Core>

namespace mirada::rig {

/// The geometry of Vega & Canas 2019 as published, kept to show its error beside ours: its camera matrix (of
/// another camera than its table lists), used on the picture turned by 90 degrees with the principal point
/// exchanged but not mirrored and fx, fy not exchanged; no distortion. Height and tilt are given to it as
/// they truly are.
struct PaperGeometry {
  int width_px = 320;
  int height_px = 240;
  double eye_height_m = 0.11;
  double tilt_rad = 0;  ///< positive down
  double pan_rad = 0;   ///< positive left
  Eigen::Vector2d p_RC_m{0, 0};

  /// Floor point in the robot's frame of a pixel; nothing at or above its horizon.
  std::optional<Eigen::Vector2d> floor_point(const Eigen::Vector2d& pixel) const;
};

/// The calibration that the paper's code carries in a comment: fx, fy, cx, cy for 320x240.
inline constexpr double kPaperK[4] = {313.89382026, 316.64906146, 158.04145907, 117.5728043};

}  // namespace mirada::rig
