#pragma once
#include <cstdint>
#include <vector>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "model/camera_model.h"
#include "vision/ground_projection.h"

namespace mirada::vision {

/// Where one scan crosses a bright band of the floor, in the robot's frame.
struct BandCrossing {
  int scan = 0;              ///< which of its family, in order
  double at = 0;             ///< of the band's middle, in samples from the scan's first
  Eigen::Vector2d p_R_m;     ///< the middle
  Eigen::Vector2d across_m;  ///< from edge to edge, along the scan
  double per_sample_m = 0;   ///< floor from one sample to the next
};

/// How wide on the floor, along a scan, a band may be, and how far away.
struct BandLimits {
  double narrowest_m = 0.025;
  double widest_m = 0.2;
  double farthest_m = 2.5;
};

/// Straight scans down and across the picture, about 40 of each and 320 x 240 samples whatever its size, and
/// the bright bands that they cross: a rise and a fall of the least of the three channels, between two sides
/// that look alike. White is bright in each channel and a coloured floor is not, whatever its colour. One
/// thread; allocates only for a new camera.
class LineScans {
 public:
  /// Prepares for pictures of this camera's size.
  void resize(const CameraModel& camera);

  double samples_between_scans() const { return kBetweenScans; }
  /// From left to right, each from the bottom up: crosses what lies across the view.
  const std::vector<BandCrossing>& down(const cv::Mat& bgr, const GroundProjection& ground,
                                        const BandLimits& limits);
  /// From the bottom up, each from left to right: crosses what runs ahead.
  const std::vector<BandCrossing>& across(const cv::Mat& bgr, const GroundProjection& ground,
                                          const BandLimits& limits);

 private:
  static constexpr int kBetweenScans = 8;
  struct Scan {
    cv::Point first_px, step_px;
    std::vector<Eigen::Vector3d> rays_C;  ///< zero where the lens shows nothing
  };
  struct Edge {
    double at;
    int sample;
    int step;
  };

  static Scan scan_of(const CameraModel& camera, cv::Point first_px, cv::Point step_px);
  const std::vector<BandCrossing>& all(const std::vector<Scan>& scans, const cv::Mat& bgr,
                                       const GroundProjection& ground, const BandLimits& limits);
  void read(const Scan& scan, const cv::Mat& bgr, const GroundProjection& ground, double least_sine);
  void find_bands(const Scan& scan, const GroundProjection& ground, const BandLimits& limits);
  void add_band(const Scan& scan, const Edge& rise, const Edge& fall, const GroundProjection& ground,
                const BandLimits& limits);

  std::vector<Scan> down_, across_;
  int begin_ = 0;           ///< first sample of `white_` that shows floor
  std::vector<int> white_;  ///< of the scan that is read: the least channel, 0..255
  int scan_ = 0;
  std::vector<BandCrossing> found_;
};

}  // namespace mirada::vision
