#pragma once
#include <array>

#include "memory/free_floor.h"
#include "memory/obstacle_points.h"

namespace mirada::memory {

/// What is remembered of one direction, from the robot's origin.
struct Direction {
  Answer answer = Answer::not_seen;  ///< blocked, clear or not_seen
  double distance_m = 0;             ///< to the obstacle, or how far floor was seen; 0 when not_seen
  double sigma_m = 0;
  double free_m = 0;   ///< how far floor is known to be free, whatever comes after
  Micros seen_at = 0;  ///< the oldest look that the answer rests on
};

/// All round, one direction a degree: index 0 is ahead, then to the left. Never `clear` where nothing was
/// looked at.
class Surroundings {
 public:
  static constexpr int kDirections = 360;

  Surroundings() = default;
  Surroundings(const ObstaclePoints& points, const FreeFloor& floor, const DriftLedger& drift,
               const Pose2& X_OR);

  const Direction& at(double bearing_rad) const { return all_[index(bearing_rad)]; }
  const std::array<Direction, kDirections>& all() const { return all_; }
  /// The bearing of all()[i], in (-pi, pi].
  static double bearing_rad(int i) { return wrap_rad(rad(i)); }

 private:
  static std::size_t index(double bearing_rad);
  void put_points(const ObstaclePoints& points, const DriftLedger& drift, const Pose2& X_OR);
  void walk(int i, const FreeFloor& floor, const Pose2& X_OR);

  std::array<Direction, kDirections> all_{};
};

}  // namespace mirada::memory
