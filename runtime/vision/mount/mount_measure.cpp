#include "vision/mount/mount_measure.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "vision/mount/messages.h"

namespace mirada::vision {
namespace {

constexpr double kLowest_m = 0.015;
constexpr double kHighest_m = 2;
constexpr double kLeastTilt_rad = rad(-20);
constexpr double kMostTilt_rad = rad(80);
constexpr double kMostRoll_rad = rad(15);
constexpr double kMostSigmaTilt_rad = rad(0.75);
constexpr double kMostSigmaHeight = 0.04;
constexpr double kMostHeightChange = 0.25;
constexpr double kMostTiltChange_rad = rad(20);
constexpr double kAlwaysAllowedTilt_rad = rad(0.5);
constexpr double kAlwaysAllowedHeight = 0.03;
constexpr double kSigmas = 3;

struct Attitude {
  double height_m;
  double tilt_rad;
  double roll_rad;
};

Attitude attitude_of(const RobotConfig& robot, const NeckAngles& neck) {
  const Eigen::Isometry3d X_RC = robot.X_RC(neck);
  const Eigen::Vector3d up_C = X_RC.linear().row(2).transpose();
  return {X_RC.translation().z(), std::asin(std::clamp(-up_C.z(), -1.0, 1.0)),
          std::atan2(-up_C.x(), -up_C.y())};
}

std::string cm(double value_m) { return number_text(100 * value_m, 1); }
std::string degrees(double angle_rad) { return number_text(deg(angle_rad), 1); }

void doubt_place(const FloorSight& sight, Faults& faults) {
  if (sight.tilt_rad < kLeastTilt_rad || sight.tilt_rad > kMostTilt_rad) {
    faults.push_back(make_fault("mount", messages::mount_not_on_floor,
                                {{"value", degrees(sight.tilt_rad)},
                                 {"min", degrees(kLeastTilt_rad)},
                                 {"max", degrees(kMostTilt_rad)}}));
  }
  if (std::abs(sight.roll_rad) > kMostRoll_rad) {
    faults.push_back(make_fault("mount", messages::mount_rolled,
                                {{"value", degrees(sight.roll_rad)}, {"max", degrees(kMostRoll_rad)}}));
  }
  if (sight.height_m < kLowest_m || sight.height_m > kHighest_m) {
    faults.push_back(
        make_fault("mount", messages::mount_height_range,
                   {{"value", cm(sight.height_m)}, {"min", cm(kLowest_m)}, {"max", cm(kHighest_m)}}));
  }
}

void doubt_certainty(const FloorSight& sight, Faults& faults) {
  if (sight.sigma_tilt_rad <= kMostSigmaTilt_rad && sight.sigma_height_m <= kMostSigmaHeight * sight.height_m)
    return;
  faults.push_back(make_fault("mount", messages::mount_unsure,
                              {{"tilt", number_text(deg(sight.sigma_tilt_rad), 2)},
                               {"height", number_text(1000 * sight.sigma_height_m, 1)},
                               {"max_tilt", number_text(deg(kMostSigmaTilt_rad), 2)},
                               {"max_height", number_text(1000 * kMostSigmaHeight * sight.height_m, 1)}}));
}

void doubt_change(const FloorSight& sight, const Attitude& told, Faults& faults) {
  if (std::abs(sight.height_m / told.height_m - 1) > kMostHeightChange) {
    faults.push_back(make_fault("mount", messages::mount_height_differs,
                                {{"value", cm(sight.height_m)}, {"told", cm(told.height_m)}}));
  }
  if (std::abs(sight.tilt_rad - told.tilt_rad) > kMostTiltChange_rad) {
    faults.push_back(make_fault("mount", messages::mount_tilt_differs,
                                {{"value", degrees(sight.tilt_rad)}, {"told", degrees(told.tilt_rad)}}));
  }
}

}  // namespace

Faults doubt(const FloorSight& sight, const RobotConfig& robot, const NeckAngles& neck) {
  Faults faults;
  doubt_place(sight, faults);
  if (!faults.empty()) return faults;
  doubt_certainty(sight, faults);
  doubt_change(sight, attitude_of(robot, neck), faults);
  return faults;
}

MountConfig measured_mount(const RobotConfig& robot, const NeckAngles& neck, const FloorSight& sight) {
  RobotConfig out = robot;
  // The chain from mount to floor has no closed inverse once yaw and neck tilt meet; it contracts quickly.
  for (int i = 0; i < 50; ++i) {
    const Attitude now = attitude_of(out, neck);
    out.mount.tilt_rad += sight.tilt_rad - now.tilt_rad;
    out.mount.roll_rad += sight.roll_rad - now.roll_rad;
    out.mount.p_TM_m.z() += sight.height_m - now.height_m;
  }
  out.mount.sigma_tilt_rad = sight.sigma_tilt_rad;
  out.mount.sigma_height_m = sight.sigma_height_m;
  return out.mount;
}

MountCheck check_mount(const RobotConfig& robot, const NeckAngles& neck, const FloorSight& sight) {
  MountCheck out;
  const Attitude told = attitude_of(robot, neck);
  const bool has_height = std::isfinite(sight.height_m);
  out.height_off_m = sight.height_m - told.height_m;
  out.tilt_off_rad = sight.tilt_rad - told.tilt_rad;
  out.roll_off_rad = sight.roll_rad - told.roll_rad;
  if (sight.sigma_tilt_rad > kMostSigmaTilt_rad) {
    out.words.push_back(make_fault("mount", messages::mount_cannot_tell, {}, Severity::warning));
    return out;
  }
  const auto limit_rad = [&](double sigma_rad) {
    return kAlwaysAllowedTilt_rad + kSigmas * std::hypot(sigma_rad, robot.mount.sigma_tilt_rad);
  };
  const auto warn = [&](const Message& message, const std::string& value, const std::string& wanted) {
    out.words.push_back(
        make_fault("mount", message, {{"value", value}, {"told", wanted}}, Severity::warning));
  };
  if (std::abs(out.tilt_off_rad) > limit_rad(sight.sigma_tilt_rad)) {
    warn(messages::mount_knocked_tilt, degrees(sight.tilt_rad), degrees(told.tilt_rad));
  }
  if (std::abs(out.roll_off_rad) > limit_rad(sight.sigma_roll_rad)) {
    warn(messages::mount_knocked_roll, degrees(sight.roll_rad), degrees(told.roll_rad));
  }
  const double allowed_m = kAlwaysAllowedHeight * told.height_m +
                           kSigmas * std::hypot(sight.sigma_height_m, robot.mount.sigma_height_m);
  if (has_height && std::abs(out.height_off_m) > allowed_m) {
    warn(messages::mount_knocked_height, cm(sight.height_m), cm(told.height_m));
  }
  out.verdict = out.words.empty() ? MountCheck::Verdict::fine : MountCheck::Verdict::knocked;
  return out;
}

}  // namespace mirada::vision
