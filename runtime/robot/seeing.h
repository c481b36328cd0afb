#pragma once
#include <optional>

#include "model/percepts.h"

namespace mirada::robot {

/// An answer older than this says nothing about now.
constexpr Micros kPerceptLife = 500 * kMillisecond;

/// Questions to one sonar percept, asked from where the robot is now (odometry): what was seen has moved in
/// the robot's frame since the exposure. Pure functions; everything answers `not seen` when the percept is
/// too old.
class SonarView {
 public:
  SonarView(const SonarPercept& sonar, const Pose2& X_OR_now, Micros now);

  bool fresh() const { return fresh_; }
  /// Whether the picture looks in this direction at all (whatever it could tell there).
  bool in_view(double bearing_rad) const;
  /// The reading nearest to this bearing (rad, left positive), from the robot's origin; not_seen when none is
  /// near.
  SonarReading at(double bearing_rad) const;
  /// Whether a robot this wide can roll straight until `ahead_m` from its origin: all of that strip that the
  /// picture holds was seen as floor. What was not seen is not clear.
  bool way_clear(double width_m, double ahead_m) const;
  /// The nearest boundary in view.
  std::optional<SonarReading> nearest_obstacle() const;

 private:
  SonarReading moved(const SonarReading& reading) const;

  const SonarPercept* sonar_;
  Pose2 X_RS_;  ///< the robot's frame at the exposure, seen from the robot now
  bool fresh_;
};

}  // namespace mirada::robot
