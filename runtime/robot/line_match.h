#pragma once
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "model/geometry.h"
#include "model/percepts.h"
#include "model/place.h"

namespace mirada::robot {

/// How a piece of line that was seen lies to a line of the map, for a robot that stands at X_PR.
struct LineError {
  int line = 0;                   ///< of the place: its straight lines, then its circles
  Eigen::Vector2d off;            ///< across the map's line (m) and in direction (rad): zero where it is true
  Eigen::Vector2d noise2;         ///< variances of `off`, by what the sight of the piece leaves uncertain
  Eigen::Matrix<double, 2, 3> h;  ///< how `off` changes with the robot's x, y and heading
};

/// To every line that runs where the piece lies, give or take `slack_m` along it. `seen` in the robot's frame
/// at X_PR.
std::vector<LineError> line_errors(const Place& place, const Pose2& X_PR, const LineSeen& seen,
                                   double slack_m);

/// The same to one line, however far it is.
LineError line_error(const Place& place, int line, const Pose2& X_PR, const LineSeen& seen);

/// Whether all of the piece lies on what was seen as floor from the same picture: a stripe on a post or a
/// board's edge, taken for paint, lies beyond.
bool on_seen_floor(const LineSeen& seen, const SonarPercept& sonar);

/// The one line of the map that the piece can be: near enough by Mahalanobis' distance while every other is
/// far. `strange`: it can be none.
struct LineMatch {
  std::optional<int> line;
  bool strange = false;
};
LineMatch match_line(const Place& place, const Pose2& X_PR, const Eigen::Matrix3d& covariance,
                     const LineSeen& seen);

}  // namespace mirada::robot
