#include "robot/watch.h"

#include <cmath>

namespace mirada::robot {
namespace {

constexpr double kSweepReach_rad = rad(80);
constexpr Micros kSettlePatience = 2 * kSecond;
constexpr Micros kLookPatience = 500 * kMillisecond;
constexpr double kFaceDeadband_rad = rad(3);

}  // namespace

void Watch::keep(memory::Watching what) {
  if (what == attention_.watching()) return;
  if (what == memory::Watching::nothing) {
    rest();
    return;
  }
  attention_.watch(what);
  aimed_ = false;
  if (what != memory::Watching::face) level();
}

void Watch::look_around() {
  sweep_asked_ = true;
  stops_.assign(1, 0.0);  // until step() knows the way
  level();
}

/// A camera that was left looking up shows no floor.
void Watch::level() {
  if (gaze_->can_tilt()) gaze_->tilt_to(0);
}

void Watch::rest() {
  attention_.watch(memory::Watching::nothing);
  stops_.clear();
  sweep_asked_ = aimed_ = false;
  next_ = {};
}

void Watch::rest_ahead() {
  rest();
  gaze_->pan_to(0);
}

memory::GazeRange Watch::range(const Sight& sight) const {
  memory::GazeRange out;
  out.pan = gaze_->pan_joint();
  out.half_view_rad = half_view_rad_;
  out.pan_now_rad = gaze_->state(sight.now).angles.pan_rad;
  out.speed_mps = sight.speed_mps;
  out.turn_radps = sight.turn_radps;
  out.face_rad = sight.face_rad;
  return out;
}

bool Watch::look_is_over(const memory::VisualMemory& memory, Micros now) {
  if (settled_ == 0) {
    if (gaze_->state(now).settled || now - since_ > kSettlePatience) settled_ = now;
    return false;
  }
  if (now - settled_ < attention_.dwell()) return false;
  return memory.last_look() >= settled_ || now - settled_ > kLookPatience;
}

void Watch::aim(const memory::NextLook& look, Micros now) {
  next_ = look;
  const double off_rad = std::abs(look.pan_rad - gaze_->state(now).angles.pan_rad);
  if (look.why != "the_face" || off_rad > kFaceDeadband_rad) gaze_->pan_to(look.pan_rad);
  aimed_ = true;
  since_ = now;
  settled_ = 0;
}

void Watch::step(const memory::VisualMemory& memory, const Sight& sight) {
  if (sweep_asked_) {
    const std::vector<double> stops = memory::sweep_stops(range(sight), kSweepReach_rad);
    stops_.assign(stops.begin(), stops.end());
    sweep_asked_ = aimed_ = false;
  }
  if (stops_.empty() && attention_.watching() == memory::Watching::nothing) return;
  next_.moving = aimed_ && settled_ == 0;
  if (aimed_ && !look_is_over(memory, sight.now)) return;
  if (!stops_.empty()) {
    if (aimed_) stops_.pop_front();
    memory::NextLook look;
    look.watching = "around";
    look.why = "old";
    if (!stops_.empty()) {
      look.pan_rad = stops_.front();
      aim(look, sight.now);
      return;
    }
    aimed_ = false;
    if (attention_.watching() == memory::Watching::nothing) {
      gaze_->pan_to(0);
      next_ = {};
      return;
    }
  }
  aim(attention_.next(memory, range(sight)), sight.now);
}

}  // namespace mirada::robot
