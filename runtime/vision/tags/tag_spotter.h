#pragma once
#include <array>
#include <vector>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "model/frame.h"
#include "model/robot_config.h"
#include "vision/tags/tag_finder.h"

namespace mirada::vision {

/// One AprilTag 36h11 as the robot sees it. Tag frame T as in TagPose.
struct TagSpot {
  int id = 0;
  std::array<cv::Point2d, 4> corners_px;  ///< top left, top right, bottom right, bottom left as printed
  Eigen::Isometry3d X_CT = Eigen::Isometry3d::Identity();  ///< in the camera's optical frame
  Eigen::Isometry3d X_RT = Eigen::Isometry3d::Identity();  ///< in the robot's frame
  double bearing_rad = 0;                                  ///< of its middle, from the robot's origin, left +
  double distance_m = 0;                                   ///< along the floor, from the robot's origin
  double error_px = 0;
  double ambiguity = 0;            ///< see TagPose; above 0.6 the tag's tilt is a guess
  bool chosen_by_gravity = false;  ///< the corners alone could not tell; tags stand upright or lie flat
};

/// Finds AprilTags and where they stand. Of two poses that fit about equally well it takes the one in which
/// the tag stands upright or lies flat. One thread.
class TagSpotter {
 public:
  /// `size_m`: side of the tags' black square.
  TagSpotter(const RobotConfig& robot, double size_m);

  /// `neck` at the frame's exposure. A frame of the calibrated shape but another size is scaled; any other,
  /// or an empty one, shows no tags. Sorted by id.
  std::vector<TagSpot> look(const Frame& frame, const NeckAngles& neck);

 private:
  RobotConfig robot_;
  double size_m_;
  TagFinder finder_;
  cv::Mat gray_;
};

}  // namespace mirada::vision
