#pragma once
#include <string>

#include "model/robot_config.h"
#include "world/simulation.h"
#include "world/world_config.h"

namespace mirada::world {

/// Writes docs/protocol.md's `scene`: the parts that stand still once, the rest on each call.
class SceneWriter {
 public:
  SceneWriter(const WorldConfig& placed, const RobotConfig& robot);
  std::string write(const Truth& truth, const std::vector<Pose2>& people) const;

 private:
  std::string fixed_;  ///< opening brace to the last fixed member, without a comma after it
  std::vector<double> person_radius_m_;
  std::vector<std::string> person_colour_;
  std::string footprint_;
  double hfov_deg_ = 0;
};

}  // namespace mirada::world
