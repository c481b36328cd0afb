#include "robot/follower.h"

#include <algorithm>
#include <cmath>

namespace mirada::robot {
namespace {

using Eigen::Vector2d;

constexpr Micros kSeenLife = 450 * kMillisecond;
constexpr Micros kPredictFor = 2'200 * kMillisecond;
constexpr Micros kSearchFor = 14 * kSecond;
constexpr double kWalkFades_s = 2.0;       // of somebody who is not seen
constexpr double kLead_s = 0.08;           // from the command to the wheels and the neck
constexpr double kFaceAbove_rad = rad(9);  // the face's place above the picture's middle, so that the trunk
                                           // is in it
constexpr double kNeckDeadband_rad = rad(1.2);
constexpr double kTurnFrom_rad = rad(22);  // following the face only: the neck does the rest
constexpr double kTurnTo_rad = rad(6);
constexpr double kFollowTurn_per_s = 2.6;
constexpr double kSearchSweep_rad = rad(40);
constexpr double kSearchPeriod_s = 2.4;
constexpr double kSearchTurn_radps = 0.6;
constexpr double kSamePerson_m = 0.7;  // a new number this near to where they should be is still them
constexpr double kReachGrows_mps = 0.4;
constexpr double kCrumb_m = 0.12;
constexpr std::size_t kMostCrumbs = 80;
constexpr double kWalked_m = 0.3;   // floor, this near to where they walked
constexpr double kPerson_m = 0.24;  // an obstacle this near to where they were then was they
constexpr Micros kPersonTime = 1'200 * kMillisecond;
constexpr Micros kFirstLook = 800 * kMillisecond;
// Heads differ in size by so much: beyond it the feet are the ones in doubt.
constexpr double kFaceScaleLeast = 0.9;
constexpr double kFaceScaleMost = 1.12;

double reach_of_body(const RobotConfig& robot) {
  double reach_m = 0;
  for (const Vector2d& corner : robot.footprint_R_m) reach_m = std::max(reach_m, corner.norm());
  return reach_m + 0.03;
}

}  // namespace

const char* to_string(FollowState state) {
  switch (state) {
    case FollowState::idle:
      return "";
    case FollowState::following:
      return "following";
    case FollowState::predicted:
      return "predicted";
    case FollowState::searching:
      return "searching";
    case FollowState::gone:
      return "gone";
  }
  return "";
}

Follower::Follower(Motion& motion, Gaze& gaze, Watch& watch, const RobotConfig& robot)
    : motion_(&motion),
      gaze_(&gaze),
      watch_(&watch),
      robot_(robot),
      radius_m_(reach_of_body(robot)),
      lens_m_(robot.X_RC({}).translation().z()) {}

MotionTicket Follower::begin(Mode mode, double distance_m, MotionOwner owner) {
  keep_m_ = distance_m;
  const bool same = mode == mode_ && owner.script == owner_.script && owner.block == owner_.block &&
                    motion_->state(ticket_) == MotionState::going;
  if (same) return ticket_;
  mode_ = mode;
  owner_ = owner;
  watch_->rest();
  ticket_ = motion_->steered(std::move(owner));
  target_.reset();
  crumbs_.clear();
  own_way_O_m_.clear();
  range_scale_ = 1;
  state_ = FollowState::searching;
  glance_since_ = glance_settled_ = glanced_at_ = begun_at_ = 0;
  wants_to_drive_ = false;
  turning_ = false;
  return ticket_;
}

MotionTicket Follower::face(MotionOwner owner) { return begin(Mode::face, 0, std::move(owner)); }
MotionTicket Follower::person(double distance_m, MotionOwner owner) {
  return begin(Mode::person, distance_m, std::move(owner));
}

void Follower::stop() {
  if (mode_ == Mode::none) return;
  motion_->finish_steered(ticket_, MotionState::done);
  leave();
}

void Follower::leave() {
  mode_ = Mode::none;
  state_ = FollowState::idle;
  target_.reset();
  crumbs_.clear();
}

void Follower::take(const FacePercept& face, Micros t, bool by_face) {
  Target next;
  next.id = face.id;
  next.p_O_m = face.p_O_m;
  next.v_O_mps = face.v_O_mps;
  next.t = t;
  next.by_face = by_face;
  next.height_m = face.distance_m * std::tan(face.elevation_rad);
  next.name = face.name;
  if (target_ && next.name.empty() && face.id == target_->id) next.name = target_->name;
  if (target_ && !by_face) next.height_m = target_->height_m;
  target_ = next;
  if (crumbs_.empty() || (crumbs_.back().p_O_m - next.p_O_m).norm() > kCrumb_m)
    crumbs_.push_back({next.p_O_m, t, t});
  crumbs_.back().until = t;
  if (crumbs_.size() > kMostCrumbs) crumbs_.pop_front();
}

/// Somebody who is known is only followed in their own face: not in a stranger's, and not in one that nobody
/// has looked at closely yet.
bool Follower::may_be_target(const FacePercept& face) const {
  if (!target_ || target_->name.empty()) return true;
  if (face.id == target_->id && face.familiar == Familiar::unsure) return true;
  return face.name == target_->name;
}

/// The same number; else, after a loss, a face near where they should be; else
/// any, when nobody is followed.
void Follower::look_for_target(const Sight& sight) {
  if (sight.faces == nullptr || sight.faces->frame == seen_frame_) return;
  seen_frame_ = sight.faces->frame;
  const Micros t = sight.faces->t_exposure;
  const FacePercept* best = nullptr;
  for (const FacePercept& face : sight.faces->faces) {
    if (face.predicted || !may_be_target(face)) continue;
    if (target_ && face.id == target_->id) return take(face, t, true);
    const double reach_m =
        target_ ? kSamePerson_m + kReachGrows_mps * std::min(seconds(t - target_->t), 6.0) : 0;
    const bool near = target_ && (face.p_O_m - place_at(t)).norm() < reach_m;
    const bool free_to_choose = !target_ || state_ == FollowState::gone;
    const bool known_one = target_ && !target_->name.empty();
    if (best == nullptr && (near || known_one || free_to_choose)) best = &face;
  }
  for (const FacePercept& body : sight.faces->bodies)
    if (target_ && body.id == target_->id) return take(body, t, false);
  if (best != nullptr && state_ != FollowState::following) take(*best, t, true);
}

Vector2d Follower::place_at(Micros t) const {
  const double dt = std::max(0.0, seconds(t - target_->t));
  return target_->p_O_m + target_->v_O_mps * kWalkFades_s * (1 - std::exp(-dt / kWalkFades_s));
}

FollowState Follower::state_at(Micros now) const {
  const Micros age = target_ ? now - target_->t : kPredictFor + now - begun_at_;
  if (age <= kSeenLife) return FollowState::following;
  if (target_ && age <= kPredictFor) return FollowState::predicted;
  return age <= kPredictFor + kSearchFor ? FollowState::searching : FollowState::gone;
}

void Follower::step(const Sight& sight, const memory::VisualMemory& memory) {
  if (mode_ == Mode::none) return;
  if (motion_->state(ticket_) != MotionState::going) {
    leave();
    return;
  }
  if (motion_->paused()) return;
  // The neck was given to something else.
  if (watch_->keeping() != memory::Watching::nothing || watch_->looking_around()) return stop();
  if (begun_at_ == 0) begun_at_ = sight.now;
  const Vector2d here(sight.X_OR.x_m, sight.X_OR.y_m);
  if (own_way_O_m_.empty() || (own_way_O_m_.back() - here).norm() > kCrumb_m) own_way_O_m_.push_back(here);
  if (own_way_O_m_.size() > kMostCrumbs) own_way_O_m_.pop_front();
  look_for_target(sight);
  state_ = state_at(sight.now);
  double bearing_rad = 0;
  double away_m = keep_m_;
  if (target_) {
    const Vector2d p = place_at(sight.now + micros(kLead_s));
    const Vector2d to(p.x() - sight.X_OR.x_m, p.y() - sight.X_OR.y_m);
    bearing_rad = wrap_rad(std::atan2(to.y(), to.x()) - sight.X_OR.heading_rad);
    away_m = (target_->by_face ? std::clamp(range_scale_, kFaceScaleLeast, kFaceScaleMost) : range_scale_) *
             to.norm();
    if (state_ != FollowState::searching && std::abs(bearing_rad) > rad(3))
      search_side_ = bearing_rad > 0 ? 1 : -1;
  }
  move_neck(sight, bearing_rad, away_m, memory);
  motion_->steer(ticket_, wheels(sight, bearing_rad, away_m, memory));
}

/// A look at the floor where it drives, now and then: with the face in view
/// there is none.
bool Follower::glance(const Sight& sight, const memory::VisualMemory& memory) {
  constexpr Micros kEvery = 2 * kSecond;
  constexpr Micros kSoon = 900 * kMillisecond;
  constexpr double kShort_m = 0.3;
  constexpr Micros kPatience = 500 * kMillisecond;
  if (mode_ != Mode::person || !gaze_->can_tilt()) return false;
  if (glance_since_ == 0) {
    const Micros since = sight.now - glanced_at_;
    const bool due = since > kEvery || (since > kSoon && room_m(memory, 0) < kShort_m);
    if (!due || !(wants_to_drive_ || since > 2 * kEvery) || state_ == FollowState::searching) return false;
    glance_since_ = sight.now;
    glance_settled_ = 0;
    gaze_->tilt_to(0);
    gaze_->pan_to(std::clamp(gaze_->state(sight.now).angles.pan_rad, -rad(20), rad(20)));
  }
  if (glance_settled_ == 0 && (gaze_->state(sight.now).settled || sight.now - glance_since_ > kPatience))
    glance_settled_ = sight.now;
  const bool seen = glance_settled_ != 0 && memory.last_look() >= glance_settled_;
  if (!seen && sight.now - glance_since_ < 2 * kPatience) return true;
  glance_since_ = 0;
  glanced_at_ = sight.now;
  if (seen) measure_range(sight, memory);
  return false;
}

/// The person's feet stand on the floor, where distance is measured better than by a face's size or by the
/// width of clothes.
void Follower::measure_range(const Sight& sight, const memory::VisualMemory& memory) {
  constexpr double kBeside_rad = rad(14);
  constexpr double kFeet_m = 0.12;  // from where they are seen to the person's middle
  constexpr double kFarthest = 1.35, kNearest = 0.4;
  constexpr double kTrust = 0.6;
  if (!target_) return;
  const Vector2d here(sight.X_OR.x_m, sight.X_OR.y_m);
  const Vector2d to = place_at(glance_settled_) - here;
  double feet_m = kFarthest * to.norm();
  for (const memory::ObstaclePoint& point : memory.points().all()) {
    if (point.seen_at < glance_settled_) continue;
    const Vector2d at = point.p_O_m - here;
    const double off = wrap_rad(std::atan2(at.y(), at.x()) - std::atan2(to.y(), to.x()));
    if (std::abs(off) < kBeside_rad) feet_m = std::min(feet_m, at.norm() + kFeet_m);
  }
  const double scale = feet_m / std::max(to.norm(), 0.2);
  if (scale > kNearest && scale < kFarthest) range_scale_ += kTrust * (scale - range_scale_);
}

void Follower::move_neck(const Sight& sight, double bearing_rad, double away_m,
                         const memory::VisualMemory& memory) {
  if (!gaze_->can_pan() && !gaze_->can_tilt()) return;
  if (glance(sight, memory)) return;
  double pan = bearing_rad;
  if (state_ == FollowState::searching)
    pan += kSearchSweep_rad * std::sin(2 * M_PI * seconds(sight.now) / kSearchPeriod_s);
  if (state_ == FollowState::gone) pan = 0;
  const NeckAngles now = gaze_->state(sight.now).angles;
  if (std::abs(pan - now.pan_rad) > kNeckDeadband_rad) gaze_->pan_to(pan);
  if (!gaze_->can_tilt()) return;
  const double up = target_ ? std::atan2(target_->height_m, std::max(away_m, 0.3)) : rad(20);
  const double tilt = -(up - kFaceAbove_rad) - robot_.mount.tilt_rad;
  if (std::abs(tilt - now.tilt_rad) > kNeckDeadband_rad) gaze_->tilt_to(tilt);
}

WheelSpeeds Follower::wheels(const Sight& sight, double bearing_rad, double away_m,
                             const memory::VisualMemory& memory) {
  const double half_m = robot_.drive.track_m / 2;
  const double turn_limit = robot_.drive.turn_radps;
  const auto spin = [&](double radps) { return WheelSpeeds{-radps * half_m, radps * half_m}; };
  if (state_ == FollowState::gone) return {};
  if (!target_ && sight.now - begun_at_ < kFirstLook) return {};
  if (state_ == FollowState::searching) {
    // Round once, the way they went.
    return spin(std::min(turn_limit, kSearchTurn_radps) * search_side_);
  }
  if (mode_ == Mode::face) {
    const bool beyond = std::abs(bearing_rad) > kTurnFrom_rad || !gaze_->can_pan();
    turning_ = beyond || (turning_ && std::abs(bearing_rad) > kTurnTo_rad);
    return turning_ ? spin(std::clamp(kFollowTurn_per_s * bearing_rad, -turn_limit, turn_limit)) : spin(0);
  }
  constexpr double kKeepGain_per_s = 1.4;
  constexpr double kBackMost_mps = 0.35;
  constexpr double kSlack_m = 0.02;
  const Vector2d away(std::cos(sight.X_OR.heading_rad + bearing_rad),
                      std::sin(sight.X_OR.heading_rad + bearing_rad));
  const double off_m = away_m - keep_m_;
  // What they were doing when they were last seen.
  const double theirs =
      target_ ? target_->v_O_mps.dot(away) * std::exp(-seconds(sight.now - target_->t) / kWalkFades_s) : 0;
  double forward = theirs + kKeepGain_per_s * (std::abs(off_m) > kSlack_m ? off_m : 0);
  wants_to_drive_ = std::abs(forward) > 0.03;
  const double way_rad = forward > 0 ? way_to(memory, bearing_rad, away_m) : bearing_rad;
  const double turn = std::clamp(kFollowTurn_per_s * way_rad, -turn_limit, turn_limit);
  forward *= std::max(0.0, std::cos(way_rad));
  const double ahead_m =
      forward > 0 ? std::min(room_m(memory, 0), room_m(memory, way_rad)) : room_m(memory, M_PI);
  // From this speed it stops within the room, reaction included.
  constexpr double kReaction_s = 0.2;
  constexpr double kKeepOff_m = 0.05;
  const double brake = 0.5 * robot_.drive.max_accel_mps2;
  const double stop_m = std::max(0.0, ahead_m - kKeepOff_m);
  const double safe = std::max(
      0.0, -brake * kReaction_s + std::sqrt(brake * brake * kReaction_s * kReaction_s + 2 * brake * stop_m));
  forward = std::clamp(forward, -std::min(kBackMost_mps, safe), std::min(robot_.drive.max_wheel_mps, safe));
  return {forward - turn * half_m, forward + turn * half_m};
}

bool Follower::walked_on(const Vector2d& p_O_m) const {
  for (const Vector2d& mine : own_way_O_m_)
    if ((mine - p_O_m).squaredNorm() < kWalked_m * kWalked_m) return true;
  return std::any_of(crumbs_.begin(), crumbs_.end(), [&](const Crumb& crumb) {
    return (crumb.p_O_m - p_O_m).squaredNorm() < kWalked_m * kWalked_m;
  });
}

/// Whether what was seen there was the person, who has gone on since.
bool Follower::was_the_person(const memory::ObstaclePoint& point) const {
  return std::any_of(crumbs_.begin(), crumbs_.end(), [&](const Crumb& crumb) {
    return (crumb.p_O_m - point.p_O_m).squaredNorm() < kPerson_m * kPerson_m &&
           point.seen_at > crumb.since - kPersonTime && point.seen_at < crumb.until + kPersonTime;
  });
}

/// How far the robot can roll in this direction: until something remembered, or
/// floor that nobody looked at. Where the person walked there is floor, and
/// what was seen there was the person.
double Follower::room_m(const memory::VisualMemory& memory, double bearing_rad) const {
  constexpr double kMost_m = 1.2;
  constexpr double kStep_m = 0.05;
  constexpr double kUnseen_m = 0.13;
  const Pose2& X_OR = memory.X_OR();
  const Vector2d here(X_OR.x_m, X_OR.y_m);
  const double angle = X_OR.heading_rad + bearing_rad;
  const Vector2d along(std::cos(angle), std::sin(angle));
  const Vector2d side(-along.y(), along.x());
  double room_m = kMost_m;
  for (const memory::ObstaclePoint& point : memory.points().all()) {
    const Vector2d to = point.p_O_m - here;
    const double ahead = to.dot(along);
    const double off = to.dot(side);
    if (ahead <= 0 || ahead > room_m + radius_m_ || std::abs(off) >= radius_m_) continue;
    if (was_the_person(point)) continue;
    room_m = std::min(room_m, std::max(0.0, ahead - std::sqrt(radius_m_ * radius_m_ - off * off)));
  }
  double seen_m = 1.4 * radius_m_;
  for (double at = seen_m; at < room_m + radius_m_; at += kStep_m) {
    const Vector2d p = here + at * along;
    if (memory.floor().seen_at(p.x(), p.y()) >= 0 || walked_on(p))
      seen_m = at + kStep_m;
    else if (at - seen_m > kUnseen_m)
      break;
  }
  room_m = std::min(room_m, std::max(0.0, seen_m - radius_m_));
  // The person is no floor.
  if (target_) {
    const Vector2d to = target_->p_O_m - here;
    const double ahead = to.dot(along);
    const double reach = radius_m_ + 0.15;
    const double off = std::abs(to.dot(side));
    if (ahead > 0 && off < reach)
      room_m = std::min(room_m, std::max(0.0, ahead - std::sqrt(reach * reach - off * off)));
  }
  return room_m;
}

/// Straight to them where there is room, else round what is in between.
double Follower::way_to(const memory::VisualMemory& memory, double bearing_rad, double away_m) const {
  const double need_m = std::clamp(away_m - keep_m_ * 0.6, 0.15, 0.6);
  for (int i = 0; i <= 14; ++i) {
    for (const double side : {search_side_, -search_side_}) {
      const double way = bearing_rad + side * rad(6) * i;
      if (room_m(memory, way) >= need_m) return wrap_rad(way);
      if (i == 0) break;
    }
  }
  return bearing_rad;
}

}  // namespace mirada::robot
