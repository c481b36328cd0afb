#include "vision/ball_finder.h"

#include <cmath>

#include <opencv2/imgproc.hpp>

#include "vision/ground_projection.h"

namespace mirada::vision {
namespace {

// Red lies at both ends of the hue.
const cv::Scalar kLowMin(0, 150, 70), kLowMax(8, 255, 255);
const cv::Scalar kHighMin(172, 150, 70), kHighMax(180, 255, 255);
constexpr double kLeastArea_px = 30;  // of a picture 320 wide
constexpr double kLeastFill = 0.6;    // of its box; a disc fills 0.79
constexpr double kMostStretch = 1.6;
constexpr double kFootSigma_px = 2;

}  // namespace

std::optional<ThingSeen> BallFinder::find(const Frame& frame, const NeckAngles& neck) {
  const CameraModel& calibrated = robot_.camera;
  if (frame.bgr.empty() || frame.bgr.cols * calibrated.height_px != frame.bgr.rows * calibrated.width_px)
    return std::nullopt;
  cv::cvtColor(frame.bgr, hsv_, cv::COLOR_BGR2HSV);
  cv::inRange(hsv_, kLowMin, kLowMax, mask_);
  cv::inRange(hsv_, kHighMin, kHighMax, other_);
  cv::bitwise_or(mask_, other_, mask_);
  cv::Mat labels, stats, middles;
  const int count = cv::connectedComponentsWithStats(mask_, labels, stats, middles);
  const double scale = frame.bgr.cols / 320.0;
  int best = 0;
  double most = kLeastArea_px * scale * scale;
  for (int i = 1; i < count; ++i) {
    const double area = stats.at<int>(i, cv::CC_STAT_AREA);
    const double w = stats.at<int>(i, cv::CC_STAT_WIDTH);
    const double h = stats.at<int>(i, cv::CC_STAT_HEIGHT);
    if (area < most || area < kLeastFill * w * h || std::max(w, h) > kMostStretch * std::min(w, h)) continue;
    best = i;
    most = area;
  }
  if (best == 0) return std::nullopt;
  const double foot_v = stats.at<int>(best, cv::CC_STAT_TOP) + stats.at<int>(best, cv::CC_STAT_HEIGHT) - 1;
  if (foot_v >= frame.bgr.rows - 2) return std::nullopt;
  const CameraModel camera = calibrated.scaled_to(frame.bgr.cols, frame.bgr.rows);
  const GroundProjection ground(robot_, camera, neck);
  const auto p_R = ground.floor_point({middles.at<double>(best, 0), foot_v});
  if (!p_R) return std::nullopt;
  ThingSeen out;
  out.kind = ThingKind::red_ball;
  out.bearing_rad = std::atan2(p_R->y(), p_R->x());
  out.distance_m = p_R->norm();
  const double tilt_rad = robot_.mount.tilt_rad + neck.tilt_rad;
  out.sigma_m =
      ground_sigma_m(out.distance_m, ground.height_m(), tilt_rad, camera.fy_px, kFootSigma_px, robot_.mount);
  return out;
}

}  // namespace mirada::vision
