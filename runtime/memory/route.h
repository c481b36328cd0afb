#pragma once
#include <functional>
#include <vector>

#include "memory/visual_memory.h"

namespace mirada::memory {

/// A way over the floor from the robot to (or as near as can be to) a goal, in O, a few centimetres a step,
/// around what is remembered. Floor that nobody looked at costs three times as much. Empty when the robot is
/// there.
struct Route {
  std::vector<Eigen::Vector2d> steps_O_m;
  double misses_by_m = 0;  ///< from its end to the goal
};

Route route_to(const VisualMemory& memory, const Eigen::Vector2d& goal_O_m, double radius_m);

/// The way to where going pays most: what a place (in O) is worth less the way there, both in metres of seen
/// floor. Only places are asked about whose floor was looked at. Empty when none of them is worth its way.
Route route_to_best(const VisualMemory& memory, double radius_m,
                    const std::function<double(const Eigen::Vector2d&)>& worth_m);

}  // namespace mirada::memory
