#pragma once
#include <Eigen/Core>

#include "base/units.h"
#include "model/geometry.h"

namespace mirada::vision {

/// Somebody's face as a point above the floor of the odometry frame O with a speed: a Kalman filter whose
/// walker starts, stops and turns by chance (constant velocity, white acceleration; Bar-Shalom, Li and
/// Kirubarajan 2001, section 6.2). A value.
struct FaceTrack {
  using State = Eigen::Matrix<double, 5, 1>;
  using Covariance = Eigen::Matrix<double, 5, 5>;

  /// How long a face that is no longer seen counts as being there.
  static constexpr Micros kHold = 400 * kMillisecond;
  static constexpr double kStartSpeed_mps = 0.3;  ///< of somebody just met, one sigma
  static constexpr double kNearest_m = 0.1;

  /// Moves the state on to the time `to`.
  void predict(Micros to);
  /// One look at a place on the floor, with its noise along and across the line of sight (`away`).
  void observe(const Eigen::Vector2d& p_O, const Eigen::Vector2d& away, double along_m, double across_m);
  /// One look at how high something stands in the picture that is `below_face_m` below the face, from a lens
  /// at p_OC.
  void observe_elevation(double elevation_rad, double sigma_rad, double below_face_m,
                         const Eigen::Vector3d& p_OC);
  /// After a loss: there, as unsure as this; how fast, nobody knows.
  void place_again(const Eigen::Vector2d& p_O, double spread_m);
  /// Not in the robot itself.
  void keep_off(const Pose2& X_OR);
  /// Since its face or its body was seen.
  Micros unseen(Micros now) const;

  int id = 0;
  State state = State::Zero();  ///< x, y, their speeds, height above the floor; O, m and m/s
  Covariance cov = Covariance::Identity();
  double size_px_m = 0;    ///< box size (root of the area) times distance from the lens
  double shape = 1.2;      ///< box height by width
  double top_below_m = 0;  ///< from the face's middle down to where the clothes end; 0 = not known
  double score = 0;
  Micros t = 0;
  Micros last_seen = 0;  ///< its face
  Micros last_body = 0;
  int looks = 0;
};

}  // namespace mirada::vision
