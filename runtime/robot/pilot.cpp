#include "robot/pilot.h"

#include <algorithm>
#include <cmath>

namespace mirada::robot {
namespace {

using Eigen::Vector2d;

constexpr double kMargin_m = 0.035;
constexpr double kLookAhead_m = 2.0;
constexpr double kSpinFrom_rad = rad(35);
constexpr double kTurnGain_per_s = 2.4;
constexpr double kMostTurn_radps = 1.2;
constexpr double kBrakeShare = 0.4;  // of the allowed deceleration
constexpr double kReaction_s = 0.2;  // from what is seen to what the wheels do
constexpr double kKeepOff_m = 0.03;
constexpr double kCreepSpeed_mps = 0.06;
constexpr Micros kStaleLook = 900 * kMillisecond;
constexpr Micros kBlindLook = 1'500 * kMillisecond;

double reach_of(const RobotConfig& robot) {
  double reach_m = 0;
  for (const Vector2d& corner : robot.footprint_R_m) reach_m = std::max(reach_m, corner.norm());
  return reach_m;
}

}  // namespace

Pilot::Pilot(Motion& motion, Watch& watch, const RobotConfig& robot)
    : motion_(&motion),
      watch_(&watch),
      drive_(robot.drive),
      can_pan_(robot.neck.pan.max_rad > robot.neck.pan.min_rad),
      radius_m_(reach_of(robot) + kMargin_m) {}

MotionTicket Pilot::begin(Course course, MotionOwner owner) {
  const bool same = course == course_ && owner.script == owner_.script && owner.block == owner_.block &&
                    motion_->state(ticket_) == MotionState::going;
  if (same && course != Course::go_to) return ticket_;
  course_ = course;
  owner_ = owner;
  ticket_ = motion_->steered(std::move(owner));
  heading_O_rad_.reset();
  fresh_O_m_.reset();
  side_ = 0;
  chosen_at_ = routed_at_ = nearest_at_ = 0;
  if (can_pan_ && watch_->keeping() == memory::Watching::nothing) {
    watch_->keep(memory::Watching::ahead);
    watches_ = true;
  }
  return ticket_;
}

MotionTicket Pilot::roam(MotionOwner owner) { return begin(Course::roam, std::move(owner)); }
MotionTicket Pilot::follow_wall(MotionOwner owner) { return begin(Course::wall, std::move(owner)); }
MotionTicket Pilot::go_to(const Vector2d& goal_O_m, MotionOwner owner) {
  const MotionTicket ticket = begin(Course::go_to, std::move(owner));
  goal_O_m_ = goal_O_m;
  return ticket;
}

void Pilot::leave() {
  course_ = Course::none;
  visited_.clear();
  if (watches_ && watch_->keeping() == memory::Watching::ahead) watch_->rest_ahead();
  watches_ = false;
}

WheelSpeeds Pilot::speeds(const Wish& wish, const memory::VisualMemory& memory,
                          const memory::Corridors& ways) const {
  const double turn_limit = std::min(kMostTurn_radps, drive_.turn_radps);
  const double turn = std::clamp(kTurnGain_per_s * wish.bearing_rad, -turn_limit, turn_limit);
  const double half_m = drive_.track_m / 2;
  if (std::abs(wish.bearing_rad) > kSpinFrom_rad) return {-turn * half_m, turn * half_m};
  // On the arc to the wish the robot passes the directions between.
  const double room_m =
      std::min({ways.free_m(0), ways.free_m(wish.bearing_rad / 2), ways.free_m(wish.bearing_rad)});
  const double brake = kBrakeShare * drive_.max_accel_mps2;
  const double stop_m = std::max(0.0, room_m - kKeepOff_m);
  // From this speed it stops within the room, reaction included.
  const double safe =
      -brake * kReaction_s + std::sqrt(brake * brake * kReaction_s * kReaction_s + 2 * brake * stop_m);
  double forward = std::min({drive_.cruise_mps, wish.most_mps, safe}) * std::cos(wish.bearing_rad);
  const Micros age = memory.look_age(0);
  if (age > kBlindLook) forward = 0;
  if (age > kStaleLook) forward = std::min(forward, kCreepSpeed_mps);
  if (room_m <= kKeepOff_m) forward = 0;
  return {forward - turn * half_m, forward + turn * half_m};
}

void Pilot::step(Micros now, const memory::VisualMemory& memory) {
  if (course_ == Course::none) return;
  if (motion_->state(ticket_) != MotionState::going) {
    leave();
    return;
  }
  if (motion_->paused()) {
    nearest_at_ = 0;  // its patience begins anew
    return;
  }
  const memory::Corridors ways(memory, radius_m_, kLookAhead_m);
  Wish wish;
  if (course_ == Course::roam) wish = roam_wish(now, memory, ways);
  if (course_ == Course::wall) wish = wall_wish(memory, ways);
  if (course_ == Course::go_to) wish = goal_wish(now, memory, ways);
  if (wish.arrived || wish.hopeless) {
    motion_->finish_steered(ticket_, wish.arrived ? MotionState::done : MotionState::stalled);
    leave();
    return;
  }
  motion_->steer(ticket_, speeds(wish, memory, ways));
}

}  // namespace mirada::robot
