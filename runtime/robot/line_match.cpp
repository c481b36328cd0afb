#include "robot/line_match.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>

namespace mirada::robot {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr double kLineGate2 = 9.2;  // of a 2-dimensional error: 1 % of true ones lie outside
constexpr double kOthers2 = 25;     // nothing else may be nearer, or it is not told apart
constexpr double kStrange2 = 25;    // 1 of 250,000 true ones
constexpr double kSlack_m = 0.1;
constexpr double kFloorSlack_m = 0.03;
constexpr double kBetweenReadings_rad = rad(1);
constexpr int kFloorChecks = 5;  // along a piece

Vector2d left_of(const Vector2d& v) { return {-v.y(), v.x()}; }

/// A line has no front: directions half a turn apart are one.
double line_angle(double angle_rad) {
  const double wrapped = wrap_rad(angle_rad);
  if (wrapped > std::numbers::pi / 2) return wrapped - std::numbers::pi;
  if (wrapped <= -std::numbers::pi / 2) return wrapped + std::numbers::pi;
  return wrapped;
}

/// The piece as it lies on the map when the robot stands at X_PR.
struct Placed {
  Vector2d p_PA_m, p_PB_m, middle_m;
  Vector2d swing_m;  ///< how the middle moves with the robot's heading
  double angle_rad;
  Vector2d noise2;

  Placed(const Pose2& X_PR, const LineSeen& seen) {
    const Eigen::Rotation2Dd turn(X_PR.heading_rad);
    const Vector2d p_PR_m(X_PR.x_m, X_PR.y_m);
    p_PA_m = p_PR_m + turn * seen.p_RA_m;
    p_PB_m = p_PR_m + turn * seen.p_RB_m;
    middle_m = (p_PA_m + p_PB_m) / 2;
    swing_m = left_of(middle_m - p_PR_m);
    angle_rad = std::atan2(p_PB_m.y() - p_PA_m.y(), p_PB_m.x() - p_PA_m.x());
    noise2 = Vector2d(seen.across_sigma_m, seen.angle_sigma_rad).cwiseAbs2();
  }
  double length_m() const { return (p_PB_m - p_PA_m).norm(); }
};

LineError error_to(const PlaceLine& line, int index, const Placed& seen) {
  const Vector2d way = (line.p_PB_m - line.p_PA_m).normalized();
  const Vector2d normal = left_of(way);
  LineError out{index, {}, seen.noise2, {}};
  out.off = {normal.dot(seen.middle_m - line.p_PA_m),
             line_angle(seen.angle_rad - std::atan2(way.y(), way.x()))};
  out.h << normal.x(), normal.y(), normal.dot(seen.swing_m), 0, 0, 1;
  return out;
}

LineError error_to(const PlaceCircle& circle, int index, const Placed& seen) {
  const Vector2d from_middle = seen.middle_m - circle.p_PC_m;
  const double radius_m = std::max(from_middle.norm(), 1e-3);
  const Vector2d normal = from_middle / radius_m;
  const Vector2d tangent = left_of(normal);
  // A straight line fitted to an arc of length l lies l^2 / 24 r inside of it.
  const double inside_m = seen.length_m() * seen.length_m() / (24 * circle.radius_m);
  LineError out{index, {}, seen.noise2, {}};
  out.off = {radius_m + inside_m - circle.radius_m,
             line_angle(seen.angle_rad - std::atan2(tangent.y(), tangent.x()))};
  // The piece leans to where its arc is seen best, up to half of what it bends from its middle to an end.
  const double lean_rad = seen.length_m() / (4 * circle.radius_m);
  out.noise2 += Vector2d(inside_m, lean_rad).cwiseAbs2();
  // Where the robot moves, another tangent is the nearest.
  const Vector2d turning = tangent / radius_m;
  out.h << normal.x(), normal.y(), normal.dot(seen.swing_m), -turning.x(), -turning.y(),
      1 - turning.dot(seen.swing_m);
  return out;
}

bool runs_there(const PlaceLine& line, const Placed& seen, double slack_m) {
  const Vector2d way = line.p_PB_m - line.p_PA_m;
  const double length_m = way.norm();
  const double a_m = way.dot(seen.p_PA_m - line.p_PA_m) / length_m;
  const double b_m = way.dot(seen.p_PB_m - line.p_PA_m) / length_m;
  return std::min(a_m, b_m) >= -slack_m && std::max(a_m, b_m) <= length_m + slack_m;
}

bool runs_there(const PlaceCircle& circle, const Placed& seen, double) {
  return (seen.middle_m - circle.p_PC_m).norm() > circle.radius_m / 2;
}

}  // namespace

std::vector<LineError> line_errors(const Place& place, const Pose2& X_PR, const LineSeen& seen,
                                   double slack_m) {
  const Placed placed(X_PR, seen);
  std::vector<LineError> out;
  int index = 0;
  const auto add = [&](const auto& line) {
    if (runs_there(line, placed, slack_m)) out.push_back(error_to(line, index, placed));
    ++index;
  };
  for (const PlaceLine& line : place.lines) add(line);
  for (const PlaceCircle& circle : place.circles) add(circle);
  return out;
}

bool on_seen_floor(const LineSeen& seen, const SonarPercept& sonar) {
  for (int i = 0; i < kFloorChecks; ++i) {
    const Vector2d p_R_m = seen.p_RA_m + (seen.p_RB_m - seen.p_RA_m) * i / (kFloorChecks - 1);
    const double bearing_rad = std::atan2(p_R_m.y(), p_R_m.x());
    const auto nearest = std::ranges::min_element(
        sonar.readings, {}, [&](const SonarReading& r) { return std::abs(r.bearing_rad - bearing_rad); });
    if (nearest == sonar.readings.end()) return false;
    if (std::abs(nearest->bearing_rad - bearing_rad) > kBetweenReadings_rad) continue;
    const bool floor = nearest->answer == Answer::clear || nearest->answer == Answer::blocked;
    if (!floor || p_R_m.norm() > nearest->distance_m + kFloorSlack_m) return false;
  }
  return true;
}

LineError line_error(const Place& place, int line, const Pose2& X_PR, const LineSeen& seen) {
  const Placed placed(X_PR, seen);
  const auto i = static_cast<std::size_t>(line);
  if (i < place.lines.size()) return error_to(place.lines[i], line, placed);
  return error_to(place.circles[i - place.lines.size()], line, placed);
}

LineMatch match_line(const Place& place, const Pose2& X_PR, const Eigen::Matrix3d& covariance,
                     const LineSeen& seen) {
  const double slack_m = kSlack_m + 2 * std::sqrt(covariance.topLeftCorner<2, 2>().trace());
  double nearest2 = HUGE_VAL, second2 = HUGE_VAL;
  LineMatch out;
  for (const LineError& error : line_errors(place, X_PR, seen, slack_m)) {
    Matrix2d spread = error.h * covariance * error.h.transpose();
    spread.diagonal() += error.noise2;
    const double away2 = error.off.dot(spread.ldlt().solve(error.off));
    second2 = std::min(second2, std::max(nearest2, away2));
    if (away2 >= nearest2) continue;
    nearest2 = away2;
    out.line = error.line;
  }
  out.strange = nearest2 > kStrange2;
  if (nearest2 > kLineGate2 || second2 < kOthers2) out.line.reset();
  return out;
}

}  // namespace mirada::robot
