#pragma once
#include "base/units.h"

namespace mirada {

// The one place where a child's angles meet ours. Inside: radians, positive to the left, tilt positive down.
// In blocks: degrees, positive to the right (90 = right), tilt positive up.
constexpr double bearing_from_block(double right_deg) { return -rad(right_deg); }
constexpr double bearing_to_block(double bearing_rad) { return -deg(bearing_rad); }
constexpr double tilt_from_block(double up_deg) { return -rad(up_deg); }
constexpr double tilt_to_block(double tilt_rad) { return -deg(tilt_rad); }

}  // namespace mirada
