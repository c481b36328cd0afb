#pragma once
#include <vector>

#include <Eigen/Core>

#include "base/units.h"
#include "model/geometry.h"
#include "world/world_config.h"

namespace mirada::world {

/// Counts how often the robot crosses a painted line: its footprint reaches more than 30 mm beyond the paint
/// on both sides. A line counts again when the footprint has left it for 1.0 s.
class LineWatch {
 public:
  LineWatch(const std::vector<Eigen::Vector2d>& footprint_R_m, const std::vector<LineConfig>& lines);

  void look(const Pose2& X_WR, Micros now);
  void reset();
  int crossings() const { return crossings_; }

 private:
  struct Watched {
    LineConfig line;
    Eigen::Vector2d low_m, high_m;  ///< bounding rectangle
    bool counted = false;
    Micros last_on = 0;
  };
  std::vector<Eigen::Vector2d> footprint_R_m_;
  std::vector<Watched> lines_;
  double reach_m_ = 0;
  int crossings_ = 0;
};

}  // namespace mirada::world
