#pragma once
#include <Eigen/Geometry>

#include "base/units.h"

namespace mirada {

/// A pose on the floor: where frame B stands in frame A. Heading positive to the left.
struct Pose2 {
  double x_m = 0;
  double y_m = 0;
  double heading_rad = 0;
};

/// X_AC from X_AB and X_BC.
Pose2 compose(const Pose2& X_AB, const Pose2& X_BC);
/// X_BA from X_AB.
Pose2 inverse(const Pose2& X_AB);

/// Where the neck points, and when: pan positive to the left, tilt positive down.
struct NeckAngles {
  double pan_rad = 0;
  double tilt_rad = 0;
};

}  // namespace mirada
