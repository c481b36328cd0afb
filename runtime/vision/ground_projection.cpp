#include "vision/ground_projection.h"

#include <cmath>

namespace mirada::vision {

GroundProjection::GroundProjection(const RobotConfig& robot, const CameraModel& camera,
                                   const NeckAngles& neck)
    : camera_(camera), X_RC_(robot.X_RC(neck)), down_row_(X_RC_.linear().row(2)) {}

std::optional<Eigen::Vector2d> GroundProjection::floor_point_of_ray(const Eigen::Vector3d& ray_C) const {
  const Eigen::Vector3d ray_R = X_RC_.linear() * ray_C;
  if (!(ray_R.z() < -1e-9)) return std::nullopt;
  const double reach = -X_RC_.translation().z() / ray_R.z();
  return Eigen::Vector2d(X_RC_.translation().head<2>() + reach * ray_R.head<2>());
}

std::optional<Eigen::Vector2d> GroundProjection::floor_point(const Eigen::Vector2d& pixel) const {
  const auto ray_C = camera_.unproject(pixel);
  if (!ray_C) return std::nullopt;
  return floor_point_of_ray(*ray_C);
}

std::optional<Eigen::Vector2d> GroundProjection::pixel(const Eigen::Vector2d& p_R_m) const {
  const Eigen::Vector3d p_R(p_R_m.x(), p_R_m.y(), 0);
  return camera_.project(X_RC_.inverse() * p_R);
}

double ground_sigma_m(double d_m, double height_m, double tilt_rad, double focal_px, double sigma_pixel_px,
                      const MountConfig& mount) {
  const double per_angle_m = (d_m * d_m + height_m * height_m) / height_m;
  const double cosine = std::cos(std::atan2(height_m, d_m) - tilt_rad);
  const double from_pixel_m = per_angle_m * cosine * cosine / focal_px * sigma_pixel_px;
  const double from_tilt_m = per_angle_m * mount.sigma_tilt_rad;
  const double from_height_m = d_m / height_m * mount.sigma_height_m;
  return std::sqrt(from_pixel_m * from_pixel_m + from_tilt_m * from_tilt_m + from_height_m * from_height_m);
}

}  // namespace mirada::vision
