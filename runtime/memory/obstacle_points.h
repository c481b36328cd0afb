#pragma once
#include <vector>

#include "memory/drift.h"
#include "memory/near_edge.h"
#include "model/percepts.h"

namespace mirada::memory {

/// A place where an obstacle's foot was seen. Odometry frame O.
struct ObstaclePoint {
  Eigen::Vector2d p_O_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d sight_O = Eigen::Vector2d::UnitX();  ///< the direction that it was seen in
  double sigma_m = 0;                                  ///< along the sight, when it was seen
  DriftMark seen;                                      ///< where the odometry was then
  Micros seen_at = 0;                                  ///< when it was last seen there
  int misses = 0;                                      ///< looks in a row that passed through it

  /// Of its place from the robot now (m², axes of O).
  Eigen::Matrix2d covariance(const DriftLedger& drift) const;
};

/// The obstacles' places: new looks refine, add and clear. At most kMost; the oldest go first. One thread.
class ObstaclePoints {
 public:
  static constexpr std::size_t kMost = 2'000;
  static constexpr Micros kLife = 300 * kSecond;
  static constexpr int kLooksToClear = 2;

  /// One picture's answers; `drift` is where the robot was at its exposure.
  void observe(const SonarPercept& sonar, const NearEdge& near, const DriftLedger& drift);
  void prune(Micros now, const DriftLedger& drift);
  void forget() { points_.clear(); }
  const std::vector<ObstaclePoint>& all() const { return points_; }

 private:
  struct Look;
  void confront(ObstaclePoint& point, Look& look);
  void add_unexplained(const Look& look);

  std::vector<ObstaclePoint> points_;
  std::vector<unsigned char> explained_;
};

}  // namespace mirada::memory
