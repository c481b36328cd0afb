#include "robot/gaze.h"

#include <algorithm>

namespace mirada::robot {

double Gaze::pan_to(double pan_rad) {
  const double aim_rad = std::clamp(pan_rad, config_.pan.min_rad, config_.pan.max_rad);
  if (neck_ != nullptr) neck_->aim({aim_rad, neck_->state().angles.tilt_rad});
  return aim_rad;
}

void Gaze::hold() {
  if (neck_ != nullptr) neck_->hold();
}

hal::NeckState Gaze::state(Micros now) const {
  if (neck_ != nullptr) return neck_->state();
  return {now, {}, true};
}

}  // namespace mirada::robot
