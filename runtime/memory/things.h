#pragma once
#include <optional>
#include <vector>

#include "memory/drift.h"
#include "model/percepts.h"

namespace mirada::memory {

/// Something with a name that was seen: the newest sighting of each kind and id. Odometry frame O.
struct Thing {
  ThingKind kind = ThingKind::face;
  int id = 0;  ///< of a tag; 0 for others
  Eigen::Vector2d p_O_m = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< when it was seen, axes of O
  DriftMark seen;
  Micros seen_at = 0;
};

/// Remembers things for kLife; at most kMost, the oldest go first. One thread.
class Things {
 public:
  static constexpr std::size_t kMost = 64;
  static constexpr Micros kLife = 600 * kSecond;

  /// Seen from X_OR at `t`.
  void observe(const ThingSeen& thing, const Pose2& X_OR, Micros t, const DriftLedger& drift);
  void prune(Micros now);
  void forget() { all_.clear(); }
  const std::vector<Thing>& all() const { return all_; }
  /// Null when it was never seen or is forgotten.
  const Thing* find(ThingKind kind, int id = 0) const;

 private:
  std::vector<Thing> all_;
};

}  // namespace mirada::memory
