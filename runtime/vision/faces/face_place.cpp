#include "vision/faces/face_place.h"

#include <algorithm>
#include <cmath>

namespace mirada::vision {
namespace {

constexpr double kEdge_px = 0.7;     // how far a box's edge may be off, one sigma
constexpr double kEdgeShare = 0.04;  // the same, of the box's size
constexpr double kSmallBox_px = 19;  // in a picture kFaceWorkWidth_px wide
constexpr double kSmallBoxShare = 0.07;
constexpr double kFaceWorkWidth_px = 320;
constexpr double kForeshortened = 0.4;  // power of the cosine
constexpr double kLargest_rad = 1.2;    // a box as wide as the picture

std::optional<Eigen::Vector3d> ray(const CameraModel& camera, double x_px, double y_px) {
  const auto out = camera.unproject({x_px - 0.5, y_px - 0.5});
  return out ? std::optional(out->normalized()) : std::nullopt;
}

/// The angle between two pixels' rays; 0 where the lens has none.
double angle_between(const CameraModel& camera, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const auto from = ray(camera, a.x(), a.y());
  const auto to = ray(camera, b.x(), b.y());
  return from && to ? std::acos(std::clamp(from->dot(*to), -1.0, 1.0)) : 0;
}

}  // namespace

double seen_size_rad(const cv::Rect2d& box, const CameraModel& camera) {
  const double middle_x = box.x + box.width / 2;
  const double middle_y = box.y + box.height / 2;
  const double across = angle_between(camera, {box.x, middle_y}, {box.x + box.width, middle_y});
  const double down = angle_between(camera, {middle_x, box.y}, {middle_x, box.y + box.height});
  const double side_px = std::sqrt(box.area()) * kFaceWorkWidth_px / camera.width_px;
  const double small = std::clamp((kSmallBox_px - side_px) / 3, 0.0, 1.0);
  return std::pow(across, 0.35) * std::pow(down, 0.65) * (1 + kSmallBoxShare * small);
}

FacePercept place_face(const FaceBox& found, const CameraModel& camera, const Eigen::Isometry3d& X_RC) {
  const cv::Rect2d& box = found.box_px;
  FacePercept face{box.x, box.y, box.width, box.height};
  face.score = found.score;
  const auto ray_C = ray(camera, box.x + box.width / 2, box.y + box.height / 2);
  const double size_rad = std::min(seen_size_rad(box, camera), kLargest_rad);
  if (!ray_C || size_rad <= 0) return face;
  // A face looked up at is foreshortened, less when its owner looks down at the robot.
  const double up = std::max(0.0, (X_RC.linear() * *ray_C).z());
  const double upright = std::pow(1 - up * up, -kForeshortened / 2);
  const double away_m = kFaceSize_m / (2 * std::tan(upright * size_rad / 2));
  set_face_point_R(face, X_RC * (away_m * *ray_C), X_RC);
  const double edge = std::hypot(kEdgeShare, kEdge_px / std::sqrt(box.width * box.height));
  face.sigma_m = away_m * std::hypot(kFaceSizeShare, edge);
  return face;
}

Eigen::Vector3d face_point_R(const FacePercept& face, const Eigen::Isometry3d& X_RC) {
  const Eigen::Vector2d flat(face.distance_m * std::cos(face.bearing_rad),
                             face.distance_m * std::sin(face.bearing_rad));
  const Eigen::Vector3d lens = X_RC.translation();
  const double away_m = (flat - lens.head<2>()).norm();
  return {flat.x(), flat.y(), lens.z() + away_m * std::tan(face.elevation_rad)};
}

void set_face_point_R(FacePercept& face, const Eigen::Vector3d& p_RF, const Eigen::Isometry3d& X_RC) {
  const Eigen::Vector3d from_lens = p_RF - X_RC.translation();
  face.bearing_rad = std::atan2(p_RF.y(), p_RF.x());
  face.distance_m = p_RF.head<2>().norm();
  face.elevation_rad = std::atan2(from_lens.z(), from_lens.head<2>().norm());
}

}  // namespace mirada::vision
