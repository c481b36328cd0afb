#pragma once
#include <Eigen/Geometry>
#include <opencv2/core.hpp>

namespace mirada::world {

/// A flat print before the simulated camera, as somebody would hold it: nearer than everything else, in no
/// robot's way. Board frame B: x right, y down the print, z into the paper.
struct HeldBoard {
  cv::Mat gray;  ///< CV_8UC1, what is printed, without a white edge that matters
  double px_per_m = 1000;
  /// Where the origin of B lies in `gray`, in pixels from its upper left corner's outer edge.
  cv::Point2d origin_px;
  Eigen::Isometry3d X_CB = Eigen::Isometry3d::Identity();  ///< seen from the camera
};

}  // namespace mirada::world
