#include "robot/motion.h"

#include <algorithm>
#include <cmath>

namespace mirada::robot {
namespace {

constexpr double kUsualStep_s = 0.02;
constexpr double kNear_m = 0.0015;
constexpr double kNear_rad = rad(0.4);
constexpr double kCreep_mps = 0.02;       // slower does not overcome the wheels' friction
constexpr double kBrakePart = 0.6;        // of the allowed deceleration, so that the wheels can always follow
constexpr double kApproach_s = 0.12;      // the last centimetres: speed in proportion to what remains
constexpr double kHoldHeading_per_s = 3;  // rad/s a rad off the line
constexpr Micros kStallTime = 1'500 * kMillisecond;
constexpr double kStallPart = 0.02;  // of a metre or radian: less progress than this in kStallTime is none

double toward(double from, double to, double most) { return from + std::clamp(to - from, -most, most); }

/// The speed (not negative) on the way to rest at `remaining`, one step after `now`.
double approach(double remaining, double now, double cruise, double accel, double creep, double dt_s) {
  if (remaining <= 0) return 0;
  const double braking = std::sqrt(2 * kBrakePart * accel * remaining);
  const double close = remaining / kApproach_s;
  const double wanted = std::max(std::min({cruise, braking, close}), creep);
  // Never so fast that the next step alone passes the goal.
  return std::min({wanted, now + accel * dt_s, std::max(remaining / dt_s, 0.0)});
}

}  // namespace

Motion::Motion(const DriveConfig& drive, Safety& safety) : drive_(drive), safety_(&safety) {}

void Motion::begin_run(Safety::Epoch epoch) {
  halt();
  epoch_ = epoch;
  paused_ = false;
}

MotionTicket Motion::begin(Kind kind, double goal, MotionOwner owner) {
  finish(MotionState::overtaken);
  // A drive begins from rest or rolls on from set speeds: the ramp starts at what the wheels do now.
  const double rolling = (command_.left_mps + command_.right_mps) / 2;
  const double spinning = (command_.right_mps - command_.left_mps) / drive_.track_m;
  const double now = kind == Kind::drive ? rolling : spinning;
  const double sign = goal < 0 ? -1 : 1;
  kind_ = kind;
  goal_ = goal;
  remaining_ = std::abs(goal);
  speed_ = std::max(0.0, sign * now);
  started_ = arrived_ = false;
  turned_rad_ = 0;
  owner_ = std::move(owner);
  stall_ = {};
  return ++ticket_;
}

MotionTicket Motion::drive(double distance_m, MotionOwner owner) {
  return begin(Kind::drive, distance_m, std::move(owner));
}

MotionTicket Motion::turn(double angle_rad, MotionOwner owner) {
  return begin(Kind::turn, angle_rad, std::move(owner));
}

MotionTicket Motion::set_speeds(const WheelSpeeds& target, MotionOwner owner) {
  target_ = target;
  return begin(Kind::speeds, 0, std::move(owner));
}

MotionTicket Motion::steered(MotionOwner owner) {
  target_ = {};
  return begin(Kind::steered, 0, std::move(owner));
}

void Motion::steer(MotionTicket ticket, const WheelSpeeds& target) {
  if (ticket != ticket_ || kind_ != Kind::steered) return;
  const double most = std::max(std::abs(target.left_mps), std::abs(target.right_mps));
  const double scale = most > drive_.max_wheel_mps ? drive_.max_wheel_mps / most : 1;
  target_ = {scale * target.left_mps, scale * target.right_mps};
}

void Motion::finish_steered(MotionTicket ticket, MotionState how) {
  if (ticket != ticket_ || kind_ != Kind::steered) return;
  finish(how);
  command_ = {};
}

void Motion::halt() {
  finish(MotionState::overtaken);
  command_ = {};
  safety_->command(epoch_, {});
}

void Motion::finish(MotionState how) {
  if (kind_ == Kind::none) return;
  kind_ = Kind::none;
  last_state_ = how;
}

void Motion::script_ended(std::uint64_t script) {
  if (kind_ != Kind::none && owner_.script == script) halt();
}

std::optional<MotionOwner> Motion::end_set_speeds() {
  if (kind_ != Kind::speeds && kind_ != Kind::steered) return std::nullopt;
  const bool moving = kind_ == Kind::steered || target_.left_mps != 0 || target_.right_mps != 0;
  halt();
  return moving ? std::optional(owner_) : std::nullopt;
}

MotionState Motion::state(MotionTicket ticket) const {
  if (ticket != ticket_) return MotionState::overtaken;
  return kind_ == Kind::none ? last_state_ : MotionState::going;
}

WheelSpeeds Motion::drive_speeds(const hal::Odometry& odometry, double dt_s) {
  const double sign = goal_ < 0 ? -1 : 1;
  const double dx = odometry.X_OR.x_m - X_OS_.x_m;
  const double dy = odometry.X_OR.y_m - X_OS_.y_m;
  const double along = dx * std::cos(X_OS_.heading_rad) + dy * std::sin(X_OS_.heading_rad);
  remaining_ = sign * (goal_ - along);
  arrived_ = arrived_ || remaining_ <= kNear_m;
  if (arrived_) return {};
  speed_ = approach(remaining_, speed_, drive_.cruise_mps, drive_.max_accel_mps2, kCreep_mps, dt_s);
  const double off_rad = wrap_rad(X_OS_.heading_rad - odometry.X_OR.heading_rad);
  const double most = speed_ / 2;  // the line is held by slowing a wheel, not by spinning on the spot
  const double differ = std::clamp(kHoldHeading_per_s * off_rad * drive_.track_m / 2, -most, most);
  return {sign * speed_ - differ, sign * speed_ + differ};
}

WheelSpeeds Motion::turn_speeds(const hal::Odometry& odometry, double dt_s) {
  const double sign = goal_ < 0 ? -1 : 1;
  turned_rad_ += wrap_rad(odometry.X_OR.heading_rad - last_heading_rad_);
  remaining_ = sign * (goal_ - turned_rad_);
  arrived_ = arrived_ || remaining_ <= kNear_rad;
  if (arrived_) return {};
  const double per_rad_m = drive_.track_m / 2;
  speed_ = approach(remaining_, speed_, drive_.turn_radps, drive_.max_accel_mps2 / per_rad_m,
                    kCreep_mps / per_rad_m, dt_s);
  return {-sign * speed_ * per_rad_m, sign * speed_ * per_rad_m};
}

void Motion::watch_progress(Micros now, const hal::Odometry& odometry) {
  const bool at_rest =
      std::abs(odometry.speed.left_mps) < 0.005 && std::abs(odometry.speed.right_mps) < 0.005;
  if (arrived_ && at_rest) finish(MotionState::done);
  if (stall_.since == 0 || stall_.remaining - remaining_ > kStallPart) stall_ = {now, remaining_};
  if (now - stall_.since <= kStallTime || kind_ == Kind::none) return;
  finish(arrived_ ? MotionState::done : MotionState::stalled);
  command_ = {};
}

void Motion::follow(Micros now, const hal::Odometry& odometry) {
  const double dt_s = last_step_ == 0 ? kUsualStep_s : std::clamp(seconds(now - last_step_), 0.001, 0.1);
  if (!started_) {
    X_OS_ = odometry.X_OR;
    last_heading_rad_ = odometry.X_OR.heading_rad;
    started_ = true;
  }
  WheelSpeeds wanted = target_;
  if (kind_ == Kind::drive) wanted = drive_speeds(odometry, dt_s);
  if (kind_ == Kind::turn) wanted = turn_speeds(odometry, dt_s);
  const double most = drive_.max_accel_mps2 * dt_s;
  command_ = {toward(command_.left_mps, wanted.left_mps, most),
              toward(command_.right_mps, wanted.right_mps, most)};
  last_heading_rad_ = odometry.X_OR.heading_rad;
  if (kind_ == Kind::drive || kind_ == Kind::turn) watch_progress(now, odometry);
}

Safety::Verdict Motion::step(Micros now, const hal::Odometry& odometry) {
  if (paused_) {
    speed_ = 0;
    command_ = {};
    stall_ = {};
  } else if (kind_ == Kind::none) {
    command_ = {};
  } else {
    follow(now, odometry);
  }
  last_step_ = now;
  if (epoch_ == 0) return Safety::Verdict::over;
  const Safety::Verdict verdict = safety_->command(epoch_, command_);
  if (verdict == Safety::Verdict::not_finite || verdict == Safety::Verdict::too_fast) halt();
  return verdict;
}

}  // namespace mirada::robot
