#include "vision/faces/face_track.h"

#include <algorithm>
#include <cmath>

namespace mirada::vision {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kPush_mps2 = 1.2;          // how hard people start, stop and turn, one sigma
constexpr double kGrows_m_per_s05 = 0.004;  // what a walk and a bent head do to a height
constexpr double kOffRobot_m = 0.4;
constexpr double kMostOff_rad = 0.15;  // beyond it that was no edge of theirs
constexpr double kFastest_mps = 1.6;
constexpr double kSpeedFades_s = 1.0;  // of a face that is not seen

}  // namespace

Micros FaceTrack::unseen(Micros now) const { return now - std::max(last_seen, last_body); }

void FaceTrack::predict(Micros to) {
  const double dt = std::clamp(seconds(to - t), 0.0, 5.0);
  t = to;
  if (dt == 0) return;
  Covariance step = Covariance::Identity();
  const double fade = unseen(t) > kHold ? std::exp(-dt / kSpeedFades_s) : 1;
  step(0, 2) = step(1, 3) = dt;
  step(2, 2) = step(3, 3) = fade;
  state = step * state;
  cov = step * cov * step.transpose();
  const double q = kPush_mps2 * kPush_mps2;
  for (const int axis : {0, 1}) {
    cov(axis, axis) += q * dt * dt * dt * dt / 4;
    cov(axis, axis + 2) += q * dt * dt * dt / 2;
    cov(axis + 2, axis) += q * dt * dt * dt / 2;
    cov(axis + 2, axis + 2) += q * dt * dt;
  }
  cov(4, 4) += kGrows_m_per_s05 * kGrows_m_per_s05 * dt;
}

/// Who is not seen has not walked into the robot, however they came.
void FaceTrack::keep_off(const Pose2& X_OR) {
  const Vector2d here(X_OR.x_m, X_OR.y_m);
  const Vector2d to = state.head<2>() - here;
  const double away_m = to.norm();
  if (away_m >= kOffRobot_m) return;
  const Vector2d away =
      away_m > 0 ? Vector2d(to / away_m) : Vector2d(std::cos(X_OR.heading_rad), std::sin(X_OR.heading_rad));
  state.head<2>() = here + kOffRobot_m * away;
  state.segment<2>(2).setZero();
}

/// After a loss: where they went in between nobody knows.
void FaceTrack::place_again(const Vector2d& p_O, double spread_m) {
  const double height_sigma = cov(4, 4);
  state.head<2>() = p_O;
  state.segment<2>(2).setZero();
  const double speed = kStartSpeed_mps * kStartSpeed_mps;
  cov.setZero();
  cov.diagonal() << spread_m * spread_m, spread_m * spread_m, speed, speed, height_sigma;
}

/// One look at a place on the floor, with its noise along and across the line
/// of sight.
void FaceTrack::observe(const Vector2d& p_O, const Vector2d& away, double along_m, double across_m) {
  const Vector2d side(-away.y(), away.x());
  const Eigen::Matrix2d noise =
      along_m * along_m * away * away.transpose() + across_m * across_m * side * side.transpose();
  const Eigen::Matrix2d sum = cov.topLeftCorner<2, 2>() + noise;
  const Eigen::Matrix<double, 5, 2> gain = cov.leftCols<2>() * sum.inverse();
  state += gain * (p_O - state.head<2>());
  cov -= (gain * cov.topRows<2>()).eval();
  const double speed = state.segment<2>(2).norm();
  if (speed > kFastest_mps) state.segment<2>(2) *= kFastest_mps / speed;
}

/// How high in the picture somebody's face is tells how they come and go, quicker and more evenly than its
/// size: a face keeps its height. The size tells which height, in the long run.
void FaceTrack::observe_elevation(double elevation_rad, double sigma_rad, double below_face_m,
                                  const Vector3d& p_OC) {
  const Vector2d flat = state.head<2>() - p_OC.head<2>();
  const double away_m = std::max(flat.norm(), kNearest_m);
  const double up_m = state[4] - below_face_m - p_OC.z();
  const double off_rad = elevation_rad - std::atan2(up_m, away_m);
  if (std::abs(off_rad) > kMostOff_rad) return;
  const double square = away_m * away_m + up_m * up_m;
  Eigen::Matrix<double, 1, 5> slope = Eigen::Matrix<double, 1, 5>::Zero();
  slope.head<2>() = -up_m / square * flat.transpose() / away_m;
  slope[4] = away_m / square;
  const State weight = cov * slope.transpose();
  const State gain = weight / (slope.dot(weight) + sigma_rad * sigma_rad);
  state += gain * off_rad;
  cov -= (gain * weight.transpose()).eval();
}

}  // namespace mirada::vision
