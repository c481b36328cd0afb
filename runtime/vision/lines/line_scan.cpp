#include "vision/lines/line_scan.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace mirada::vision {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kLeastRise = 24;       // of 255, from the floor to the band
constexpr int kLeastStep = 2 * 16;   // the same at an edge, in the sums of two samples that steps are told in
constexpr double kSidesAlike = 0.5;  // of the rise
constexpr double kLeastSamples = 1.4;

/// Where between two samples the steepest place of three steps lies: the top of a parabola.
double steepest(int before, int here, int after) {
  const int bend = before - 2 * here + after;
  return bend == 0 ? 0 : std::clamp(0.5 * (before - after) / bend, -0.5, 0.5);
}

}  // namespace

LineScans::Scan LineScans::scan_of(const CameraModel& camera, cv::Point first_px, cv::Point step_px) {
  Scan scan{first_px, step_px, {}};
  const cv::Rect picture(0, 0, camera.width_px, camera.height_px);
  for (cv::Point at = first_px; picture.contains(at); at += step_px)
    scan.rays_C.push_back(camera.unproject({at.x, at.y}).value_or(Vector3d::Zero()));
  return scan;
}

void LineScans::resize(const CameraModel& camera) {
  const int stride = std::max(1, (camera.width_px + 160) / 320);
  down_.clear();
  across_.clear();
  const int apart = kBetweenScans * stride;
  for (int u = apart / 2; u < camera.width_px; u += apart)
    down_.push_back(scan_of(camera, {u, camera.height_px - 1}, {0, -stride}));
  for (int v = camera.height_px - 1 - apart / 2; v >= 0; v -= apart)
    across_.push_back(scan_of(camera, {0, v}, {stride, 0}));
}

const std::vector<BandCrossing>& LineScans::down(const cv::Mat& bgr, const GroundProjection& ground,
                                                 const BandLimits& limits) {
  return all(down_, bgr, ground, limits);
}

const std::vector<BandCrossing>& LineScans::across(const cv::Mat& bgr, const GroundProjection& ground,
                                                   const BandLimits& limits) {
  return all(across_, bgr, ground, limits);
}

const std::vector<BandCrossing>& LineScans::all(const std::vector<Scan>& scans, const cv::Mat& bgr,
                                                const GroundProjection& ground, const BandLimits& limits) {
  found_.clear();
  const double least_sine = ground.height_m() / std::hypot(ground.height_m(), limits.farthest_m);
  for (scan_ = 0; scan_ < static_cast<int>(scans.size()); ++scan_) {
    const Scan& scan = scans[static_cast<std::size_t>(scan_)];
    read(scan, bgr, ground, least_sine);
    find_bands(scan, ground, limits);
  }
  return found_;
}

void LineScans::read(const Scan& scan, const cv::Mat& bgr, const GroundProjection& ground,
                     double least_sine) {
  white_.clear();
  begin_ = 0;
  cv::Point at = scan.first_px;
  for (const Vector3d& ray_C : scan.rays_C) {
    const double drop = ground.drop(ray_C);
    const bool floor = drop > 0 && drop * drop >= least_sine * least_sine * ray_C.squaredNorm();
    if (floor) {
      const std::uint8_t* pixel = bgr.ptr(at.y) + 3 * at.x;
      white_.push_back(std::min({pixel[0], pixel[1], pixel[2]}));
    } else if (white_.empty()) {
      ++begin_;
    } else {
      break;
    }
    at += scan.step_px;
  }
}

void LineScans::find_bands(const Scan& scan, const GroundProjection& ground, const BandLimits& limits) {
  const int n = static_cast<int>(white_.size());
  const auto step = [&](int i) {
    const int* y = white_.data() + i;
    return y[0] + y[1] - y[-1] - y[-2];
  };
  Edge rise{0, 0, 0};
  for (int i = 3; i + 2 < n; ++i) {
    const int here = step(i);
    if (std::abs(here) < kLeastStep) continue;
    const int before = step(i - 1), after = step(i + 1);
    if (here > 0 && here > before && here >= after) {
      if (here > rise.step) rise = {i - 0.5 + steepest(before, here, after), i, here};
    } else if (here < 0 && here < before && here <= after) {
      if (rise.step > 0)
        add_band(scan, rise, {i - 0.5 + steepest(before, here, after), i, here}, ground, limits);
      rise.step = 0;
    }
  }
}

void LineScans::add_band(const Scan& scan, const Edge& rise, const Edge& fall, const GroundProjection& ground,
                         const BandLimits& limits) {
  const double samples = fall.at - rise.at;
  if (samples < kLeastSamples) return;
  const auto white = [&](int i) { return white_[static_cast<std::size_t>(i)]; };
  const int before = white(rise.sample - 2), after = white(fall.sample + 1);
  int top = 0;
  for (int i = rise.sample; i < fall.sample; ++i) top = std::max(top, white(i));
  const int height = top - std::max(before, after);
  if (height < kLeastRise || std::abs(before - after) > kSidesAlike * height) return;
  const auto floor_at = [&](double at) {
    const auto i = static_cast<std::size_t>(at + begin_);
    const double share = at + begin_ - static_cast<double>(i);
    return ground.floor_point_of_ray((1 - share) * scan.rays_C[i] + share * scan.rays_C[i + 1]);
  };
  const auto near = floor_at(rise.at), far = floor_at(fall.at);
  if (!near || !far) return;
  const double width_m = (*far - *near).norm();
  if (width_m < limits.narrowest_m || width_m > limits.widest_m) return;
  found_.push_back(
      {scan_, begin_ + (rise.at + fall.at) / 2, (*near + *far) / 2, *far - *near, width_m / samples});
}

}  // namespace mirada::vision
