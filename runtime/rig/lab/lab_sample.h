#pragma once
#include <string>
#include <vector>

#include "model/percepts.h"
#include "model/robot_config.h"

namespace mirada::rig {

/// One bearing of one picture: what is true and what vision said. Distances from the robot's origin along the
/// floor.
struct LabSample {
  std::string picture;  ///< its name
  std::string floor;
  std::string light;
  double off_axis_rad = 0;  ///< bearing minus pan
  double truth_m = 0;       ///< to the first obstacle; infinity: none within `free_m`
  double free_m = 0;        ///< how far the way is surely free (= truth_m where there is an obstacle)
  bool foot_seen = true;    ///< the obstacle's foot lies in the picture
  SonarReading reading;
  double paper_m = 0;  ///< the paper's geometry on the same boundary; NaN where it gives none
};

/// A reading that says an obstacle is there when the way is free to well beyond, or the other way round.
struct LabLimits {
  double obstacle_to_m = 1.5;  ///< obstacles nearer than this are scored
  double missed = 1.2;         ///< seen free beyond this share of the truth: an obstacle reported as clear
  double imagined =
      0.8;  ///< blocked before this share of the free way and before obstacle_to_m: clear reported as blocked
};

}  // namespace mirada::rig
