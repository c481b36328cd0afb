#pragma once
#include <array>
#include <optional>
#include <string>

#include <Eigen/Core>

namespace mirada {

/// A calibrated camera: pinhole with Brown (k1 k2 p1 p2 k3) or Kannala-Brandt fisheye (k1..k4) distortion.
/// Optical frame C: x right, y down, z forward; pixel centres at integers, top-left origin.
struct CameraModel {
  enum class Lens { brown, fisheye };

  int width_px = 320;
  int height_px = 240;
  double fx_px = 265;
  double fy_px = 265;
  double cx_px = 159.5;
  double cy_px = 119.5;
  Lens lens = Lens::brown;
  std::array<double, 5> distortion{};  ///< brown: k1 k2 p1 p2 k3; fisheye: k1 k2 k3 k4 and 0
  std::string name;                    ///< "" or what the calibration says of itself

  /// Horizontal and vertical field of view of the undistorted pinhole, in rad.
  double hfov_rad() const;
  double vfov_rad() const;

  /// The pixel of a point p_C (m) in the optical frame; nothing when it lies behind the camera.
  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d& p_C) const;
  /// The ray (z = 1) in the optical frame that is seen at a pixel: project's exact inverse (to 1e-9 in
  /// normalised coordinates). Nothing where the distortion has no inverse (outside the lens's image).
  std::optional<Eigen::Vector3d> unproject(const Eigen::Vector2d& pixel) const;

  /// The same camera delivering pictures of another size (scaled about the picture's edges, not pixel
  /// centres).
  CameraModel scaled_to(int new_width_px, int new_height_px) const;
};

}  // namespace mirada
