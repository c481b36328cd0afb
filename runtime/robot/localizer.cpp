#include "robot/localizer.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Dense>

#include "robot/line_match.h"

namespace mirada::robot {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector4d;

constexpr double kStart_m = 0.10;  // how well a robot is put down by hand
constexpr double kStart_rad = rad(10);
constexpr double kBearing_rad = rad(0.7);
constexpr double kFacing_rad = rad(15);  // a small tag's tilt is a rough guess
constexpr double kGate2 = 16;            // of a 2-dimensional error: 0.03 % of true ones lie outside
constexpr int kDoubts = 3;
constexpr int kAgreements = 3;
constexpr double kUnknown_m = 0.6;
constexpr double kUnknown_rad = rad(40);
constexpr double kSlide_per_root_m = 0.01;
constexpr double kWorseWheels = 2;         // than most robots have
constexpr double kBendWalk_radpm = 0.003;  // in one metre: floors differ
constexpr double kSureLine_m = 0.3;        // a shorter piece may be anything that is white
constexpr int kStrangeLooks = 6;
constexpr double kNewLook_m = 0.1;  // a look from nearly the same place tells nothing new
constexpr double kNewLook_rad = rad(10);

Matrix2d turn(double angle_rad) {
  const double c = std::cos(angle_rad);
  const double s = std::sin(angle_rad);
  return (Matrix2d() << c, -s, s, c).finished();
}

/// Of a place seen at p in the robot's frame: its distance is worse known than its bearing.
Matrix2d seen_covariance(const Vector2d& p_m, double sigma_m) {
  const double distance_m = std::max(p_m.norm(), 0.05);
  const Vector2d away = p_m / distance_m;
  const Vector2d across(-away.y(), away.x());
  const double across_m = kBearing_rad * distance_m + 0.004;
  return sigma_m * sigma_m * away * away.transpose() + across_m * across_m * across * across.transpose();
}

}  // namespace

Localizer::Localizer(const DriveConfig& drive) : rates_(memory::drift_rates(drive)) {
  const double bend_radpm = kWorseWheels * rates_.heading_per_m;
  covariance_(3, 3) = bend_radpm * bend_radpm;
}

void Localizer::know(std::optional<Place> place) {
  place_ = std::move(place);
  put_down(X_OR_);
}

void Localizer::put_down(const Pose2& X_OR) {
  X_OR_ = X_OR;
  begun_ = true;
  known_ = place_ && place_->X_PR_start;
  lost_ = false;
  agreed_ = disagreed_ = strange_ = 0;
  stand_at(known_ ? *place_->X_PR_start : Pose2{},
           Vector3d(kStart_m, kStart_m, kStart_rad).cwiseAbs2().asDiagonal());
}

void Localizer::stand_at(const Pose2& X_PR, const Matrix3d& covariance) {
  X_PR_ = X_PR;
  const double bend2 = covariance_(3, 3);
  covariance_.setZero();
  covariance_.topLeftCorner<3, 3>() = covariance;
  covariance_(3, 3) = bend2;
}

void Localizer::change_by(const Vector4d& change) {
  X_PR_ = {X_PR_.x_m + change.x(), X_PR_.y_m + change.y(), wrap_rad(X_PR_.heading_rad + change.z())};
  bend_radpm_ += change(3);
}

void Localizer::moved(const Pose2& X_OR) {
  if (!begun_) return put_down(X_OR);
  const Pose2 step = compose(inverse(X_OR_), X_OR);
  X_OR_ = X_OR;
  const double way_m = std::hypot(step.x_m, step.y_m);
  const double turned_rad = std::abs(wrap_rad(step.heading_rad));
  if (!known_ || (way_m == 0 && turned_rad == 0)) return;
  const double c = std::cos(X_PR_.heading_rad);
  const double s = std::sin(X_PR_.heading_rad);
  Matrix4d move = Matrix4d::Identity();
  move(0, 2) = -s * step.x_m - c * step.y_m;
  move(1, 2) = c * step.x_m - s * step.y_m;
  move(2, 3) = step.x_m;
  const double tyre_m = way_m + turned_rad * rates_.track_m / 2;
  const double turn2 = rates_.heading_per_root_m * rates_.heading_per_root_m * tyre_m +
                       2 * rates_.turn_share * turned_rad * turned_rad;
  const double slide2 = kSlide_per_root_m * kSlide_per_root_m * tyre_m;
  covariance_ = move * covariance_ * move.transpose();
  covariance_.diagonal() += Vector4d(slide2, slide2, turn2, kBendWalk_radpm * kBendWalk_radpm * way_m);
  X_PR_ = compose(X_PR_, {step.x_m, step.y_m, step.heading_rad + bend_radpm_ * step.x_m});
}

std::optional<Localizer::Sighting> Localizer::sighting_of(const ThingSeen& thing, const Pose2& X_RS) const {
  if (thing.kind != ThingKind::tag || !place_) return std::nullopt;
  const PlaceTag* tag = place_->tag(thing.id);
  if (tag == nullptr) return std::nullopt;
  // Distances are told for a tag of 10 cm; another size is as many times as far.
  const double distance_m = thing.distance_m * tag->size_m / kTagSide_m;
  const Pose2 p = compose(X_RS, {distance_m * std::cos(thing.bearing_rad),
                                 distance_m * std::sin(thing.bearing_rad), thing.facing_rad});
  return Sighting{tag,           {p.x_m, p.y_m},    distance_m, thing.sigma_m * tag->size_m / kTagSide_m,
                  p.heading_rad, thing.facing_known};
}

void Localizer::see(const ThingsPercept& things) {
  const Pose2 X_RS = compose(inverse(X_OR_), things.X_OR);
  for (const ThingSeen& thing : things.things) {
    const std::optional<Sighting> seen = sighting_of(thing, X_RS);
    if (!seen) continue;
    if (!known_) {
      start_from(*seen);
    } else if (correct(*seen)) {
      disagreed_ = strange_ = 0;
      if (++agreed_ >= kAgreements) lost_ = false;
    } else {
      doubt(*seen);
    }
  }
}

bool Localizer::correct(const Sighting& seen) {
  const Matrix2d to_R = turn(-X_PR_.heading_rad);
  const Vector2d expected = to_R * Vector2d(seen.tag->X_PT.x_m - X_PR_.x_m, seen.tag->X_PT.y_m - X_PR_.y_m);
  Eigen::Matrix<double, 2, 4> h = Eigen::Matrix<double, 2, 4>::Zero();
  h.leftCols<2>() = -to_R;
  h.col(2) = Vector2d(expected.y(), -expected.x());
  const Vector2d off = seen.p_RT_m - expected;
  const Matrix2d spread = h * covariance_ * h.transpose() + seen_covariance(seen.p_RT_m, seen.sigma_m);
  if (off.dot(spread.ldlt().solve(off)) > kGate2) return false;
  const Eigen::Matrix<double, 4, 2> gain = covariance_ * h.transpose() * spread.inverse();
  change_by(gain * off);
  covariance_ = (Matrix4d::Identity() - gain * h) * covariance_;
  covariance_ = (covariance_ + covariance_.transpose()).eval() / 2;
  return true;
}

void Localizer::doubt(const Sighting& seen) {
  agreed_ = 0;
  if (++disagreed_ < kDoubts) return;
  lost_ = true;
  start_from(seen);
}

void Localizer::see(const LinesPercept& lines) {
  if (!known_) return;
  const Pose2 X_RS = compose(inverse(X_OR_), lines.X_OR);
  const Eigen::Rotation2Dd turned(X_RS.heading_rad);
  const Vector2d p_RS_m(X_RS.x_m, X_RS.y_m);
  std::map<int, LineSeen> longest;
  const auto length_m = [](const LineSeen& line) { return (line.p_RB_m - line.p_RA_m).norm(); };
  double fitting_m = 0, strange_m = 0;
  for (LineSeen line : lines.lines) {
    line.p_RA_m = p_RS_m + turned * line.p_RA_m;
    line.p_RB_m = p_RS_m + turned * line.p_RB_m;
    const LineMatch match = match_line(*place_, X_PR_, covariance_.topLeftCorner<3, 3>(), line);
    if (match.strange && length_m(line) >= kSureLine_m) strange_m += length_m(line);
    if (!match.line) continue;
    fitting_m += length_m(line);
    const auto [it, first] = longest.emplace(*match.line, line);
    if (!first && length_m(line) > length_m(it->second)) it->second = line;
  }
  judge_lines(fitting_m, strange_m);
  if (lost_) return;
  for (const auto& [line, seen] : longest) correct(line, seen);
}

void Localizer::judge_lines(double fitting_m, double strange_m) {
  if (fitting_m == 0 && strange_m == 0) return;
  const Pose2 way = compose(inverse(X_OR_judged_), X_OR_);
  if (std::hypot(way.x_m, way.y_m) < kNewLook_m && std::abs(wrap_rad(way.heading_rad)) < kNewLook_rad) return;
  X_OR_judged_ = X_OR_;
  strange_ = std::max(strange_ + (strange_m > fitting_m ? 1 : -1), 0);
  if (strange_ < kStrangeLooks) return;
  lost_ = true;
  agreed_ = strange_ = 0;
}

void Localizer::correct(int line, const LineSeen& seen) {
  const LineError error = line_error(*place_, line, X_PR_, seen);
  Vector4d change = Vector4d::Zero();
  for (const int row : {1, 0}) {
    Eigen::RowVector4d h;
    h << error.h.row(row), 0;
    const double belief2 = h.dot(covariance_ * h.transpose());
    // Tilt and pan err alike in picture after picture: what is no better than the belief is no news.
    if (belief2 <= error.noise2(row)) continue;
    const Vector4d gain = covariance_ * h.transpose() / (belief2 + error.noise2(row));
    change -= gain * (error.off(row) + h.dot(change));
    covariance_ = (Matrix4d::Identity() - gain * h) * covariance_;
    covariance_ = (covariance_ + covariance_.transpose()).eval() / 2;
  }
  change_by(change);
}

void Localizer::start_from(const Sighting& seen) {
  if (!seen.facing_known) return;
  // The tag's own heading says from which side it is seen.
  const double heading_rad = wrap_rad(seen.tag->X_PT.heading_rad - seen.facing_rad);
  const Matrix2d to_P = turn(heading_rad);
  const Vector2d p = Vector2d(seen.tag->X_PT.x_m, seen.tag->X_PT.y_m) - to_P * seen.p_RT_m;
  const Matrix2d place = to_P * seen_covariance(seen.p_RT_m, seen.sigma_m) * to_P.transpose();
  // A wrong heading swings the robot about the tag.
  const Vector3d swing(-(p.y() - seen.tag->X_PT.y_m), p.x() - seen.tag->X_PT.x_m, 1);
  Matrix3d covariance = kFacing_rad * kFacing_rad * swing * swing.transpose();
  covariance.topLeftCorner<2, 2>() += place;
  covariance(2, 2) += kBearing_rad * kBearing_rad;
  stand_at({p.x(), p.y(), heading_rad}, covariance);
  known_ = true;
  agreed_ = disagreed_ = strange_ = 0;
}

Localizer::Estimate Localizer::estimate() const {
  Estimate out;
  if (!known_) return out;
  const Eigen::SelfAdjointEigenSolver<Matrix2d> axes(covariance_.topLeftCorner<2, 2>());
  out.X_PR = X_PR_;
  out.sigma_m = std::sqrt(std::max(axes.eigenvalues().maxCoeff(), 0.0));
  out.sigma_rad = std::sqrt(std::max(covariance_(2, 2), 0.0));
  out.lost = lost_;
  out.known = !lost_ && out.sigma_m < kUnknown_m && out.sigma_rad < kUnknown_rad;
  return out;
}

}  // namespace mirada::robot
