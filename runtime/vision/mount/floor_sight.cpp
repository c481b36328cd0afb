#include "vision/mount/floor_sight.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <opencv2/calib3d.hpp>

#include "vision/mount/least_squares.h"
#include "vision/mount/messages.h"

namespace mirada::vision {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kLineClick_px = 0.5;  ///< how well a point of a line is pointed at
constexpr double kHorizonClick_px = 1.0;
constexpr double kLeastInformation = 1e-9;  ///< smallest over largest eigenvalue that still settles a thing

/// Height, tilt and roll of the lens over a plane: `up_C` points from the plane to the lens.
Vector3d attitude(const Vector3d& up_C, double height_m) {
  return {height_m, std::asin(std::clamp(-up_C.z(), -1.0, 1.0)), std::atan2(-up_C.x(), -up_C.y())};
}

Eigen::Matrix3d rotation(const Vector3d& vector) {
  const double angle = vector.norm();
  if (angle < 1e-12) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix();
}

/// Pose vector: rotation vector and translation of the thing in the camera's frame.
Vector3d attitude_of_pose(const VectorXd& pose) {
  Vector3d up_C = rotation(pose.head<3>()).col(2);
  const Vector3d t = pose.tail<3>();
  if (up_C.dot(t) > 0) up_C = -up_C;
  return attitude(up_C, -up_C.dot(t));
}

std::vector<VectorXd> first_poses(const CameraModel& camera, const std::vector<cv::Point2d>& points_px,
                                  const std::vector<Vector2d>& points_m) {
  std::vector<cv::Point2d> rays;
  std::vector<cv::Point3d> points;
  for (std::size_t i = 0; i < points_px.size(); ++i) {
    const auto ray = camera.unproject({points_px[i].x, points_px[i].y});
    if (!ray) return {};
    rays.emplace_back(ray->x(), ray->y());
    points.emplace_back(points_m[i].x(), points_m[i].y(), 0);
  }
  std::vector<cv::Mat> rotations;
  std::vector<cv::Mat> translations;
  try {
    cv::solvePnPGeneric(points, rays, cv::Matx33d::eye(), cv::noArray(), rotations, translations, false,
                        cv::SOLVEPNP_IPPE);
  } catch (const cv::Exception&) {
    return {};
  }
  std::vector<VectorXd> out;
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    VectorXd pose(6);
    for (int k = 0; k < 3; ++k) {
      pose[k] = rotations[i].at<double>(k);
      pose[3 + k] = translations[i].at<double>(k);
    }
    out.push_back(pose);
  }
  return out;
}

/// 1-sigma of height, tilt and roll from the pose's covariance, by differences.
Vector3d attitude_sigma(const LeastSquares& fit, const VectorXd& step, double sigma_px) {
  const Eigen::Index n = fit.x.size();
  const Eigen::MatrixXd covariance =
      fit.information.ldlt().solve(Eigen::MatrixXd::Identity(n, n)) * sigma_px * sigma_px;
  Eigen::MatrixXd J(3, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    VectorXd up = fit.x;
    VectorXd down = fit.x;
    up[i] += step[i];
    down[i] -= step[i];
    J.col(i) = (attitude_of_pose(up) - attitude_of_pose(down)) / (2 * step[i]);
  }
  return (J * covariance * J.transpose()).diagonal().cwiseMax(0).cwiseSqrt();
}

/// What a fit's own scatter cannot show: the lens's centre is known to about a pixel, its focal length to a
/// few thousandths, and paper does not lie quite flat.
void add_what_is_not_seen(const CameraModel& camera, FloorSight& sight) {
  const double centre_rad = 1.0 * (camera.width_px / 640.0) / camera.fy_px;
  sight.sigma_tilt_rad = std::hypot(sight.sigma_tilt_rad, centre_rad);
  sight.sigma_roll_rad = std::hypot(sight.sigma_roll_rad, centre_rad);
  if (std::isfinite(sight.height_m)) {
    sight.sigma_height_m = std::hypot(sight.sigma_height_m, 0.003 * sight.height_m, 0.0005);
  }
}

bool settled(const Eigen::MatrixXd& information) {
  const VectorXd d = information.ldlt().vectorD().cwiseAbs();
  return d.minCoeff() > kLeastInformation * d.maxCoeff();
}

}  // namespace

Result<FloorSight> sight_from_points(const CameraModel& camera, const std::vector<cv::Point2d>& points_px,
                                     const std::vector<Vector2d>& points_m, double thickness_m,
                                     double corner_sigma_px) {
  const Residuals residuals = [&](const VectorXd& pose) {
    VectorXd out(static_cast<Eigen::Index>(2 * points_px.size()));
    const Eigen::Matrix3d R = rotation(pose.head<3>());
    for (std::size_t i = 0; i < points_px.size(); ++i) {
      const Vector3d p_C = R.leftCols<2>() * points_m[i] + pose.tail<3>();
      const auto seen = camera.project(p_C);
      if (!seen) return VectorXd();
      out.segment<2>(static_cast<Eigen::Index>(2 * i)) = *seen - Vector2d(points_px[i].x, points_px[i].y);
    }
    return out;
  };
  VectorXd step(6);
  step << 1e-5, 1e-5, 1e-5, 1e-5, 1e-5, 1e-5;
  LeastSquares best;
  for (const VectorXd& start : first_poses(camera, points_px, points_m)) {
    LeastSquares fit = minimise(residuals, start, step);
    if (fit.converged && (!best.converged || fit.rms < best.rms)) best = std::move(fit);
  }
  if (!best.converged) return make_fault("picture", messages::mount_no_pose);
  const double freedom = static_cast<double>(2 * points_px.size()) /
                         std::max(1.0, 2.0 * static_cast<double>(points_px.size()) - 6);
  const double sigma_px = std::max(best.rms * std::sqrt(freedom), corner_sigma_px);
  const Vector3d found = attitude_of_pose(best.x);
  const Vector3d sigma = attitude_sigma(best, step, sigma_px);
  FloorSight out{found[0] + thickness_m,    found[1], found[2], sigma[0], sigma[1], sigma[2],
                 best.rms * std::sqrt(2.0), 0};
  Vector2d middle = Vector2d::Zero();
  for (const Vector2d& p : points_m) middle += p / static_cast<double>(points_m.size());
  out.distance_m = (rotation(best.x.head<3>()).leftCols<2>() * middle + best.x.tail<3>()).norm();
  add_what_is_not_seen(camera, out);
  return out;
}

Result<FloorSight> sight_from_lines(const RobotConfig& robot, const CameraModel& camera,
                                    const NeckAngles& neck, const std::vector<KnownLine>& lines) {
  const Eigen::Isometry3d X_RC = robot.X_RC(neck);
  const Vector3d start_attitude = attitude(X_RC.linear().row(2).transpose(), X_RC.translation().z());
  const Vector3d forward_R = X_RC.linear().col(2);
  const double heading_rad = std::atan2(forward_R.y(), forward_R.x());
  const Residuals residuals = [&](const VectorXd& x) {
    VectorXd out(static_cast<Eigen::Index>(2 * lines.size()));
    RobotConfig lens;
    lens.mount.tilt_rad = x[1];
    lens.mount.roll_rad = x[2];
    lens.mount.yaw_rad = heading_rad;
    const Eigen::Matrix3d R_RC = lens.X_RC({}).linear();
    const Vector3d eye_R(X_RC.translation().x(), X_RC.translation().y(), x[0]);
    Eigen::Index row = 0;
    for (const KnownLine& line : lines) {
      const Vector3d a(line.points_R_m[0].x(), line.points_R_m[0].y(), 0);
      const Vector3d b(line.points_R_m[1].x(), line.points_R_m[1].y(), 0);
      const Vector3d normal = (a - eye_R).cross(b - eye_R).normalized();
      for (const Vector2d& pixel : line.seen_px) {
        const auto ray = camera.unproject(pixel);
        if (!ray) return VectorXd();
        out[row++] = camera.fy_px * normal.dot((R_RC * *ray).normalized());
      }
    }
    return out;
  };
  VectorXd start = start_attitude;
  VectorXd step(3);
  step << 1e-5, 1e-5, 1e-5;
  const LeastSquares fit = minimise(residuals, start, step);
  if (lines.size() < 2 || !fit.converged || !settled(fit.information)) {
    return make_fault("--line", messages::mount_lines_unsettled);
  }
  const double spare = std::max(1.0, 2.0 * static_cast<double>(lines.size()) - 3);
  const double sigma_px =
      std::max(fit.rms * std::sqrt(2.0 * static_cast<double>(lines.size()) / spare), kLineClick_px);
  const Vector3d sigma = (fit.information.ldlt().solve(Eigen::Matrix3d::Identity()) * sigma_px * sigma_px)
                             .diagonal()
                             .cwiseSqrt();
  FloorSight out{fit.x[0], fit.x[1], fit.x[2], sigma[0], sigma[1], sigma[2], fit.rms, 0};
  add_what_is_not_seen(camera, out);
  return out;
}

std::optional<FloorSight> sight_from_horizon(const CameraModel& camera, const Vector2d& left_px,
                                             const Vector2d& right_px) {
  const auto left = camera.unproject(left_px);
  const auto right = camera.unproject(right_px);
  if (!left || !right) return std::nullopt;
  const Vector3d up_C = right->cross(*left);
  if (up_C.norm() < 1e-6) return std::nullopt;
  const Vector3d found = attitude(up_C.normalized() * (up_C.y() > 0 ? -1 : 1), 0);
  const double click_rad = kHorizonClick_px / camera.fy_px;
  const double apart_rad = std::acos(std::clamp(left->normalized().dot(right->normalized()), -1.0, 1.0));
  FloorSight out{NAN, found[1], found[2], NAN, click_rad, click_rad * std::sqrt(2.0) / apart_rad,
                 0,   INFINITY};
  add_what_is_not_seen(camera, out);
  return out;
}

}  // namespace mirada::vision
