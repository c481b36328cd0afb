#pragma once
#include <array>
#include <optional>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "model/camera_model.h"

namespace mirada::vision {

/// Where a tag of known size stands before the camera. Tag frame T: origin in its middle, x right and y up as
/// printed, z out of the paper.
struct TagPose {
  Eigen::Isometry3d X_CT = Eigen::Isometry3d::Identity();
  double error_px = 0;  ///< rms over the four corners
  /// A small or far tag fits two poses. The other one, and how well it fits compared with this one: error_px
  /// / other's error, 0 = this one for sure, 1 = the corners cannot tell.
  std::optional<Eigen::Isometry3d> other_X_CT;
  double ambiguity = 0;
};

/// From a tag's corners (TagSighting's order) and the side of its black square in metres. Nothing when a
/// corner lies where the lens sees nothing, or no pose before the camera fits.
std::optional<TagPose> tag_pose(const std::array<cv::Point2d, 4>& corners_px, const CameraModel& camera,
                                double size_m);

}  // namespace mirada::vision
