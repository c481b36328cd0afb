#pragma once
#include <optional>

#include <Eigen/Geometry>

#include "model/robot_config.h"

namespace mirada::vision {

/// Pixels to points on the floor (z = 0 in the robot's frame) and back, for one picture size and one neck
/// position. Cheap to make; immutable.
class GroundProjection {
 public:
  /// `camera` is the robot's camera scaled to the picture's size.
  GroundProjection(const RobotConfig& robot, const CameraModel& camera, const NeckAngles& neck);

  /// Where the pixel's ray meets the floor, in the robot's frame (m); nothing at or above the horizon.
  std::optional<Eigen::Vector2d> floor_point(const Eigen::Vector2d& pixel) const;
  /// Where a floor point is seen: floor_point's exact inverse; nothing behind the camera.
  std::optional<Eigen::Vector2d> pixel(const Eigen::Vector2d& p_R_m) const;

  /// The floor point of a ray in the camera's frame; nothing when it does not go down.
  std::optional<Eigen::Vector2d> floor_point_of_ray(const Eigen::Vector3d& ray_C) const;
  /// Positive when the ray goes down.
  double drop(const Eigen::Vector3d& ray_C) const { return -down_row_.dot(ray_C); }

  const Eigen::Isometry3d& X_RC() const { return X_RC_; }
  double height_m() const { return X_RC_.translation().z(); }

 private:
  CameraModel camera_;
  Eigen::Isometry3d X_RC_;
  Eigen::RowVector3d down_row_;  ///< the third row of R_RC
};

/// 1-sigma of a ground distance `d_m` (from below the lens) seen by a camera `height_m` high: from
/// `sigma_pixel_px` in the picture's rows, tilt and height (DESIGN section 6). `tilt_rad` is the lens's whole
/// tilt, positive down.
double ground_sigma_m(double d_m, double height_m, double tilt_rad, double focal_px, double sigma_pixel_px,
                      const MountConfig& mount);

}  // namespace mirada::vision
