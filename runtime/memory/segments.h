#pragma once
#include <vector>

#include "memory/obstacle_points.h"

namespace mirada::memory {

/// A straight piece of something's foot. Odometry frame O.
struct Segment {
  Eigen::Vector2d from_O_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d to_O_m = Eigen::Vector2d::Zero();
  double sigma_m = 0;  ///< across it, from the robot now
  Micros seen_at = 0;  ///< its oldest place's last look
  int points = 0;

  double length_m() const { return (to_O_m - from_O_m).norm(); }
};

/// The places as straight pieces: neighbours are chained, chains split where they bend, and pieces that go on
/// in the same line (0.3 rad) are one. A place alone is a piece without length. Seen from `X_OR`.
std::vector<Segment> segments_of(const ObstaclePoints& points, const DriftLedger& drift, const Pose2& X_OR);

}  // namespace mirada::memory
