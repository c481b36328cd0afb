#pragma once
#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "base/result.h"
#include "model/camera_model.h"
#include "model/robot_config.h"

namespace mirada::vision {

/// How the lens stands over the floor, measured from one picture. Tilt positive down, roll positive clockwise
/// seen from behind, both of the whole lens (neck and mount together).
struct FloorSight {
  double height_m = 0;  ///< NaN when only the horizon was seen
  double tilt_rad = 0;
  double roll_rad = 0;
  double sigma_height_m = 0;
  double sigma_tilt_rad = 0;
  double sigma_roll_rad = 0;
  double rms_px = 0;      ///< of what was seen against what the answer foretells
  double distance_m = 0;  ///< from the lens to the middle of what was seen
};

/// From points of a flat thing that lies on the floor: a board's corners or a tag's. `points_m` are in the
/// thing's own frame, z = 0; `thickness_m` is how high its face lies above the floor; `corner_sigma_px` is
/// the least error that the corners are believed to have. Faults when no pose fits.
Result<FloorSight> sight_from_points(const CameraModel& camera, const std::vector<cv::Point2d>& points_px,
                                     const std::vector<Eigen::Vector2d>& points_m, double thickness_m,
                                     double corner_sigma_px);

/// A straight line on the floor whose place before the robot is known, and two points of it in the picture.
struct KnownLine {
  std::array<Eigen::Vector2d, 2> seen_px;
  std::array<Eigen::Vector2d, 2> points_R_m;
};

/// From two or more known lines: height, tilt and roll, with the lens's place over the floor and its yaw
/// taken from the robot's file. `camera` has the picture's size. Faults when the lines do not settle it.
Result<FloorSight> sight_from_lines(const RobotConfig& robot, const CameraModel& camera,
                                    const NeckAngles& neck, const std::vector<KnownLine>& lines);

/// From two points of the true horizon: tilt and roll only. Nothing where the lens sees nothing.
std::optional<FloorSight> sight_from_horizon(const CameraModel& camera, const Eigen::Vector2d& left_px,
                                             const Eigen::Vector2d& right_px);

}  // namespace mirada::vision
