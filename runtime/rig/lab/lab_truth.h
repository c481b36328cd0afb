#pragma once
#include <vector>

#include "model/geometry.h"
#include "world/world_config.h"

namespace mirada::rig {

/// How far it is from a pose's origin to the first wall, box or cylinder in a direction (rad, left of the
/// pose's heading), along the floor; infinity when nothing is there. Exact.
class LabTruth {
 public:
  explicit LabTruth(const world::WorldConfig& room);
  double distance_m(const Pose2& X_WR, double bearing_rad) const;

 private:
  struct Edge {
    Eigen::Vector2d a, b;
  };
  struct Circle {
    Eigen::Vector2d middle;
    double radius_m;
  };
  std::vector<Edge> edges_;
  std::vector<Circle> circles_;
};

}  // namespace mirada::rig
