#include "robot/gaze.h"

#include <algorithm>

namespace mirada::robot {

double Gaze::pan_to(double pan_rad) {
  target_.pan_rad = std::clamp(pan_rad, config_.pan.min_rad, config_.pan.max_rad);
  if (neck_ != nullptr) neck_->aim(target_);
  return target_.pan_rad;
}

double Gaze::tilt_to(double tilt_rad) {
  target_.tilt_rad = std::clamp(tilt_rad, config_.tilt.min_rad, config_.tilt.max_rad);
  if (neck_ != nullptr) neck_->aim(target_);
  return target_.tilt_rad;
}

void Gaze::look_ahead() {
  pan_to(0);
  tilt_to(0);
}

void Gaze::hold() {
  if (neck_ == nullptr) return;
  neck_->hold();
  target_ = neck_->state().angles;
}

void Gaze::pause(bool on) {
  if (neck_ == nullptr) return;
  if (on)
    neck_->hold();
  else
    neck_->aim(target_);
}

hal::NeckState Gaze::state(Micros now) const {
  if (neck_ != nullptr) return neck_->state();
  return {now, {}, true};
}

}  // namespace mirada::robot
