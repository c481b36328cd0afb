#pragma once
#include <vector>

#include <Eigen/Core>

#include "model/percepts.h"

namespace mirada::vision {

/// What one picture column found, as a place on the floor in the robot's frame.
struct ColumnEnd {
  Answer answer = Answer::not_seen;
  Eigen::Vector2d foot_R_m = Eigen::Vector2d::Zero();  ///< the lowest floor that the column can see
  Eigen::Vector2d end_R_m = Eigen::Vector2d::Zero();   ///< blocked: the boundary; clear: the last floor seen;
                                                       ///< otherwise any place in the column's direction
  double sigma_m = 0;
  double edge = 0.5;  ///< where, on the way to the next column, what this one found gives way to what that
                      ///< one found, when they are two things: 0 here, 1 there; when all the way is the
                      ///< nearer one's, so is what only the robot's origin sees beside it
};

/// Two neighbouring ends that lie too far apart to be one thing.
bool is_jump(const ColumnEnd& a, const ColumnEnd& b);

/// Turns the ends of columns, seen from the lens, into readings for every whole degree within `heading_rad`
/// +- `half_view_rad` as seen from the robot's origin. `columns` go left to right; `out` is overwritten. The
/// nearest boundary that crosses a bearing wins; what leaves the picture at its side is clear up to there.
/// `sigma_heading_rad` widens the sigma where the boundary runs along the line of sight.
void sweep(const std::vector<ColumnEnd>& columns, double heading_rad, double half_view_rad,
           double sigma_heading_rad, std::vector<SonarReading>& out);

}  // namespace mirada::vision
