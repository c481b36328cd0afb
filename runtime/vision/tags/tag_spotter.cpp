#include "vision/tags/tag_spotter.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "vision/tags/tag_pose.h"

namespace mirada::vision {
namespace {

constexpr double kAmbiguous = 0.5;
constexpr double kSameShape = 0.01;

/// How far a tag is from standing upright or lying flat, in rad.
double lean_rad(const Eigen::Isometry3d& X_RT) {
  const double up = std::clamp(std::abs(X_RT.linear()(2, 2)), 0.0, 1.0);
  return std::min(std::acos(up), std::asin(up));
}

}  // namespace

TagSpotter::TagSpotter(const RobotConfig& robot, double size_m) : robot_(robot), size_m_(size_m) {}

std::vector<TagSpot> TagSpotter::look(const Frame& frame, const NeckAngles& neck) {
  if (frame.bgr.empty()) return {};
  const CameraModel& calibrated = robot_.camera;
  const double shape =
      static_cast<double>(frame.bgr.cols) * calibrated.height_px / frame.bgr.rows / calibrated.width_px;
  if (std::abs(shape - 1) > kSameShape) return {};
  const CameraModel camera = calibrated.scaled_to(frame.bgr.cols, frame.bgr.rows);
  cv::cvtColor(frame.bgr, gray_, cv::COLOR_BGR2GRAY);
  const Eigen::Isometry3d X_RC = robot_.X_RC(neck);
  std::vector<TagSpot> out;
  for (const TagSighting& sighting : finder_.find(gray_)) {
    const auto pose = tag_pose(sighting.corners_px, camera, size_m_);
    if (!pose) continue;
    TagSpot spot;
    spot.id = sighting.id;
    spot.corners_px = sighting.corners_px;
    spot.error_px = pose->error_px;
    spot.ambiguity = pose->ambiguity;
    spot.X_CT = pose->X_CT;
    if (pose->other_X_CT && pose->ambiguity > kAmbiguous &&
        lean_rad(X_RC * *pose->other_X_CT) < lean_rad(X_RC * pose->X_CT)) {
      spot.X_CT = *pose->other_X_CT;
      spot.chosen_by_gravity = true;
    }
    spot.X_RT = X_RC * spot.X_CT;
    const Eigen::Vector3d p_RT_m = spot.X_RT.translation();
    spot.bearing_rad = std::atan2(p_RT_m.y(), p_RT_m.x());
    spot.distance_m = std::hypot(p_RT_m.x(), p_RT_m.y());
    out.push_back(spot);
  }
  return out;
}

}  // namespace mirada::vision
