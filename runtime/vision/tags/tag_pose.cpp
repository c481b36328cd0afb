#include "vision/tags/tag_pose.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <opencv2/calib3d.hpp>

namespace mirada::vision {
namespace {

/// Corners that are known to a few hundredths of a pixel say nothing by errors below this.
constexpr double kCornerNoise_px = 0.05;

std::array<Eigen::Vector3d, 4> corners_T_m(double size_m) {
  const double h = size_m / 2;
  return {Eigen::Vector3d(-h, h, 0), {h, h, 0}, {h, -h, 0}, {-h, -h, 0}};
}

Eigen::Isometry3d isometry(const cv::Mat& rotation, const cv::Mat& translation) {
  cv::Mat R;
  cv::Rodrigues(rotation, R);
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) X.linear()(i, j) = R.at<double>(i, j);
    X.translation()[i] = translation.at<double>(i);
  }
  return X;
}

double error_px(const Eigen::Isometry3d& X_CT, const std::array<cv::Point2d, 4>& corners_px,
                const CameraModel& camera, double size_m) {
  const auto points = corners_T_m(size_m);
  double sum = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto seen = camera.project(X_CT * points[i]);
    if (!seen) return INFINITY;
    sum += (*seen - Eigen::Vector2d(corners_px[i].x, corners_px[i].y)).squaredNorm();
  }
  return std::sqrt(sum / 4);
}

}  // namespace

std::optional<TagPose> tag_pose(const std::array<cv::Point2d, 4>& corners_px, const CameraModel& camera,
                                double size_m) {
  std::vector<cv::Point2d> rays;
  std::vector<cv::Point3d> points;
  for (const Eigen::Vector3d& p : corners_T_m(size_m)) points.emplace_back(p.x(), p.y(), p.z());
  for (const cv::Point2d& corner : corners_px) {
    const auto ray = camera.unproject({corner.x, corner.y});
    if (!ray) return std::nullopt;
    rays.emplace_back(ray->x(), ray->y());
  }
  std::vector<cv::Mat> rotations;
  std::vector<cv::Mat> translations;
  try {
    cv::solvePnPGeneric(points, rays, cv::Matx33d::eye(), cv::noArray(), rotations, translations, false,
                        cv::SOLVEPNP_IPPE_SQUARE);
  } catch (const cv::Exception&) {
    return std::nullopt;
  }
  std::vector<std::pair<double, Eigen::Isometry3d>> found;
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    const Eigen::Isometry3d X_CT = isometry(rotations[i], translations[i]);
    const double error = error_px(X_CT, corners_px, camera, size_m);
    if (std::isfinite(error)) found.emplace_back(error, X_CT);
  }
  if (found.empty()) return std::nullopt;
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  TagPose out{found[0].second, found[0].first, std::nullopt, 0};
  if (found.size() > 1) {
    out.other_X_CT = found[1].second;
    out.ambiguity = std::max(found[0].first, kCornerNoise_px) / std::max(found[1].first, kCornerNoise_px);
  }
  return out;
}

}  // namespace mirada::vision
