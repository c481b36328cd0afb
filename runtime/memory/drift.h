#pragma once
#include <Eigen/Core>

#include "model/robot_config.h"

namespace mirada::memory {

/// How odometry errs, 1-sigma.
struct DriftRates {
  double track_m = 0.15;
  double heading_per_m = 0.028;       ///< rad a metre, always to the same side: wheels of unequal size
  double heading_per_root_m = 0.019;  ///< rad a root of a metre of tyre: slip
  double turn_share = 0.003;          ///< of every turn
  double length_share = 0.003;        ///< of every way
};
/// For a robot with good small wheels (0.3 % unlike, 2 mm of slip after a metre).
DriftRates drift_rates(const DriveConfig& drive);

/// What has gone by since the start: sums over the way, so that the difference of two marks tells how badly a
/// place that was seen at one is known at the other. Odometry frame O.
struct DriftMark {
  Eigen::Vector2d p_OR_m = Eigen::Vector2d::Zero();
  double way_m = 0;                                      ///< signed: backward driving takes back
  double tyre_m = 0;                                     ///< mean way of the tyres, never taken back
  double turned_rad = 0;                                 ///< signed
  Eigen::Vector2d way_moment = Eigen::Vector2d::Zero();  ///< sum of p_OR over way_m
  Eigen::Vector2d turn_moment = Eigen::Vector2d::Zero();
  Eigen::Vector2d tyre_moment = Eigen::Vector2d::Zero();
  Eigen::Matrix2d tyre_square = Eigen::Matrix2d::Zero();
};

/// Keeps the sums. One thread.
class DriftLedger {
 public:
  explicit DriftLedger(const DriftRates& rates) : rates_(rates) {}

  /// The next pose of the odometry, at most a few centimetres from the last.
  void moved(const Pose2& X_OR);
  const DriftMark& now() const { return now_; }
  /// Covariance (m², axes of O) of where a place p_O, fixed in the world, lies from the robot now, because of
  /// what the odometry did wrong since `then`.
  Eigen::Matrix2d covariance(const DriftMark& then, const Eigen::Vector2d& p_O_m) const;

 private:
  DriftRates rates_;
  DriftMark now_;
  bool started_ = false;
  double heading_rad_ = 0;
};

}  // namespace mirada::memory
