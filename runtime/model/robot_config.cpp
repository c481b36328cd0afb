#include "model/robot_config.h"

#include <algorithm>

namespace mirada {

double RobotConfig::width_m() const {
  if (footprint_R_m.empty()) return 0;
  double low = footprint_R_m.front().y();
  double high = low;
  for (const Eigen::Vector2d& corner : footprint_R_m) {
    low = std::min(low, corner.y());
    high = std::max(high, corner.y());
  }
  return high - low;
}

Eigen::Isometry3d RobotConfig::X_RC(const NeckAngles& angles) const {
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translate(neck.p_RN_m).rotate(AngleAxisd(angles.pan_rad, Vector3d::UnitZ()));
  X.translate(neck.p_PT_m).rotate(AngleAxisd(angles.tilt_rad, Vector3d::UnitY()));
  X.translate(mount.p_TM_m).rotate(AngleAxisd(mount.yaw_rad, Vector3d::UnitZ()));
  X.rotate(AngleAxisd(mount.tilt_rad, Vector3d::UnitY()))
      .rotate(AngleAxisd(mount.roll_rad, Vector3d::UnitX()));
  // Mount M (x forward, y left, z up) to optical C (x right, y down, z forward).
  Eigen::Matrix3d R_MC;
  R_MC << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  X.rotate(R_MC);
  return X;
}

}  // namespace mirada
