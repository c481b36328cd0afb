#pragma once
#include <vector>

#include "base/units.h"
#include "world/shapes.h"
#include "world/world_config.h"

namespace mirada::world {

/// The people of a room: those with a path walk it for ever and wait while the robot is in their way.
class Walkers {
 public:
  explicit Walkers(const std::vector<PersonConfig>& people);

  /// `robot_reach_m`: radius about the robot's origin that they keep out of.
  void step(Micros dt, const Pose2& X_WR, double robot_reach_m);
  void reset();

  const std::vector<Pose2>& poses() const { return poses_; }
  std::vector<Shape> shapes() const;

 private:
  struct Walk {
    std::size_t next = 0;
  };
  std::vector<PersonConfig> people_;
  std::vector<Pose2> poses_;
  std::vector<Walk> walks_;
};

}  // namespace mirada::world
