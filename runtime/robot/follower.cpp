#include "robot/follower.h"

#include <algorithm>
#include <cmath>

namespace mirada::robot {
namespace {

using Eigen::Vector2d;

constexpr Micros kSeenLife = 450 * kMillisecond;
constexpr Micros kSearchFor = 14 * kSecond;
constexpr double kWalkFades_s = 2.0;       // of somebody who is not seen
constexpr double kLead_s = 0.08;           // from the command to the wheels and the neck
constexpr double kTurnFrom_rad = rad(22);  // following the face only: the neck does the rest
constexpr double kTurnTo_rad = rad(6);
constexpr double kFollowTurn_per_s = 2.6;
constexpr double kSearchTurn_per_s = 1.5;
constexpr double kSearchTurn_radps = 1.2;
constexpr double kSamePerson_m = 0.7;  // a new number this near to where they should be is still them
constexpr double kReachGrows_mps = 0.4;
constexpr double kFastestBody_mps = 0.7;  // faster, the clothes were taken for something else
constexpr double kCrumb_m = 0.12;
constexpr std::size_t kMostCrumbs = 80;
constexpr Micros kFirstLook = 800 * kMillisecond;
// Heads differ in size by so much: beyond it the feet are the ones in doubt.
constexpr double kFaceScaleLeast = 0.9;
constexpr double kFaceScaleMost = 1.12;
// Clothes are less sure, but were learnt of the same person.
constexpr double kBodyScaleLeast = 0.85;
constexpr double kBodyScaleMost = 1.18;

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
  own_way_.clear();
  range_scale_ = 1;
  measured_ = 0;
  state_ = FollowState::searching;
  glance_since_ = glance_settled_ = glanced_at_ = begun_at_ = 0;
  glance_at_ = Glance::ahead;
  behind_side_ = behind_last_ = 0;
  behind_since_ = 0;
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

/// What the distance told by a face or by clothes is to be taken for.
double Follower::scale(bool by_face) const {
  return by_face ? std::clamp(range_scale_, kFaceScaleLeast, kFaceScaleMost)
                 : std::clamp(range_scale_, kBodyScaleLeast, kBodyScaleMost);
}

void Follower::take(const FacePercept& face, const Sight& sight, bool by_face) {
  const Micros t = sight.faces->t_exposure;
  const Vector2d here(sight.X_OR.x_m, sight.X_OR.y_m);
  Target next;
  next.id = face.id;
  next.p_O_m = here + scale(by_face) * (face.p_O_m - here);
  next.v_O_mps = face.v_O_mps;
  next.t = t;
  next.by_face = by_face;
  next.height_m = face.distance_m * std::tan(face.elevation_rad);
  next.name = face.name;
  if (target_ && next.name.empty() && face.id == target_->id) next.name = target_->name;
  if (target_ && !by_face) next.height_m = target_->height_m;
  target_ = next;
  if (crumbs_.empty() || (crumbs_.back().p_O_m - next.p_O_m).norm() > kCrumb_m)
    crumbs_.push_back({next.p_O_m, t, t, by_face});
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
    if (target_ && face.id == target_->id) return take(face, sight, true);
    const double reach_m =
        target_ ? kSamePerson_m + kReachGrows_mps * std::min(seconds(t - target_->t), 6.0) : 0;
    const bool near = target_ && (face.p_O_m - place_at(t)).norm() < reach_m;
    const bool free_to_choose = !target_ || state_ == FollowState::gone;
    const bool known_one = target_ && !target_->name.empty();
    if (best == nullptr && (near || known_one || free_to_choose)) best = &face;
  }
  for (const FacePercept& body : sight.faces->bodies)
    if (target_ && body.id == target_->id && body.v_O_mps.norm() < kFastestBody_mps)
      return take(body, sight, false);
  if (best != nullptr && state_ != FollowState::following) take(*best, sight, true);
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
  if (begun_at_ == 0) {
    begun_at_ = sight.now;
    begun_heading_rad_ = sight.X_OR.heading_rad;
  }
  const Vector2d here(sight.X_OR.x_m, sight.X_OR.y_m);
  note_own_way(sight);
  look_for_target(sight);
  state_ = state_at(sight.now);
  double bearing_rad = wrap_rad(begun_heading_rad_ - sight.X_OR.heading_rad);
  double away_m = keep_m_;
  if (target_) {
    const Vector2d p = place_at(sight.now + micros(kLead_s));
    const Vector2d to(p.x() - sight.X_OR.x_m, p.y() - sight.X_OR.y_m);
    bearing_rad = wrap_rad(std::atan2(to.y(), to.x()) - sight.X_OR.heading_rad);
    away_m = to.norm();
    if (state_ != FollowState::searching && std::abs(bearing_rad) > rad(3))
      search_side_ = bearing_rad > 0 ? 1 : -1;
  }
  mind_behind(sight, bearing_rad, away_m, memory);
  move_neck(sight, bearing_rad, away_m, memory);
  motion_->steer(ticket_, wheels(sight, bearing_rad, away_m, memory));
}

WheelSpeeds Follower::wheels(const Sight& sight, double bearing_rad, double away_m,
                             const memory::VisualMemory& memory) {
  const double half_m = robot_.drive.track_m / 2;
  const double turn_limit = robot_.drive.turn_radps;
  const auto spin = [&](double radps) { return WheelSpeeds{-radps * half_m, radps * half_m}; };
  if (state_ == FollowState::gone) return {};
  if (!target_ && sight.now - begun_at_ < kFirstLook) return {};
  if (state_ == FollowState::searching) {
    const double turn = kSearchTurn_per_s * search_rad(sight.now, bearing_rad);
    const double most = std::min(turn_limit, kSearchTurn_radps);
    return spin(std::clamp(turn, -most, most));
  }
  if (mode_ == Mode::face) {
    const bool beyond = std::abs(bearing_rad) > kTurnFrom_rad || !gaze_->can_pan();
    turning_ = beyond || (turning_ && std::abs(bearing_rad) > kTurnTo_rad);
    return turning_ ? spin(std::clamp(kFollowTurn_per_s * bearing_rad, -turn_limit, turn_limit)) : spin(0);
  }
  if (behind_side_ != 0) {
    const double off_rad = bearing_rad + behind_side_ * kBackAside_rad;
    return spin(std::clamp(2 * kFollowTurn_per_s * off_rad, -turn_limit, turn_limit));
  }
  constexpr double kKeepGain_per_s = 2.0;
  constexpr double kBackMost_mps = 0.35;
  constexpr double kSlack_m = 0.02;
  constexpr double kBehind_s = 0.15, kBefore_s = 0.35, kHeadwayMost = 0.12;
  const Vector2d away(std::cos(sight.X_OR.heading_rad + bearing_rad),
                      std::sin(sight.X_OR.heading_rad + bearing_rad));
  // What they were doing when they were last seen.
  const double theirs =
      target_ ? target_->v_O_mps.dot(away) * std::exp(-seconds(sight.now - target_->t) / kWalkFades_s) : 0;
  // Who walks may turn round: behind somebody who goes it keeps a little farther off, before somebody who
  // comes nearer, for it falls back no faster than they come.
  const double most_m = kHeadwayMost * keep_m_;
  const double off_m =
      away_m - keep_m_ - std::clamp((theirs > 0 ? kBehind_s : kBefore_s) * theirs, -most_m, most_m);
  double forward = theirs + kKeepGain_per_s * (std::abs(off_m) > kSlack_m ? off_m : 0);
  wants_to_drive_ = forward > 0.03;
  const double way_rad =
      forward > 0 ? way_to(memory, bearing_rad, away_m) : way_back(memory, bearing_rad, away_m);
  const double turn = std::clamp(kFollowTurn_per_s * way_rad, -turn_limit, turn_limit);
  forward *= std::max(0.0, std::cos(way_rad));
  // Who is not seen may have turned and be coming.
  if (state_ == FollowState::predicted) forward = std::min(forward, 0.0);
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

}  // namespace mirada::robot
