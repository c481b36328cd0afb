#include "robot/follower.h"

#include <algorithm>
#include <array>
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
// Looks off where they should be, in degrees, positive the way they went, each held: a face is found in a
// picture that is still.
constexpr std::array kSearchLooks_deg{0, 40, -40, 80, 120, 160, -160, -120, -80};
constexpr Micros kSearchHold = 800 * kMillisecond;
constexpr double kSearchHigher_rad = rad(12);  // every other round: somebody nearer than expected
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

/// Somebody comes nearer and there is no floor to back off on: it turns aside until the neck reaches behind,
/// has a look there, one side after the other, and turns back.
void Follower::mind_behind(const Sight& sight, double bearing_rad, double away_m,
                           const memory::VisualMemory& memory) {
  constexpr Micros kEvery = 4 * kSecond;
  constexpr Micros kMost = 3 * kSecond;
  constexpr double kTooNear_m = 0.18;
  constexpr double kCornered_m = 0.2;
  if (behind_side_ != 0) {
    if (sight.now - behind_since_ > kMost || away_m > keep_m_ || state_ == FollowState::searching)
      behind_side_ = 0;
    return;
  }
  const bool sees = state_ == FollowState::following && gaze_->can_pan();
  const bool again = behind_since_ == 0 || sight.now - behind_since_ > kEvery;
  if (mode_ != Mode::person || !sees || !again || away_m > keep_m_ - kTooNear_m) return;
  const double way_rad = way_back(memory, bearing_rad, away_m);
  if (room_m(memory, wrap_rad(way_rad + M_PI)) > kCornered_m) return;
  behind_last_ = behind_last_ != 0 ? -behind_last_ : bearing_rad > 0 ? -1 : 1;
  behind_side_ = behind_last_;
  behind_since_ = sight.now;
}

/// A look at the floor where it drives, now and then: with the face in view
/// there is none.
bool Follower::glance(const Sight& sight, double bearing_rad, const memory::VisualMemory& memory) {
  constexpr Micros kEvery = 2 * kSecond;
  constexpr Micros kSoon = 900 * kMillisecond;
  constexpr double kShort_m = 0.3, kKnown_m = 0.5;
  constexpr int kMeasured = 3;
  constexpr double kLow_rad = rad(20);
  constexpr double kAside_rad = rad(20);
  constexpr double kTurned_rad = rad(12);
  if (mode_ != Mode::person || !gaze_->can_tilt()) return false;
  if (glance_since_ == 0) {
    const bool turned = std::abs(bearing_rad + behind_side_ * kBackAside_rad) < kTurned_rad;
    const bool behind = behind_side_ != 0 && turned;
    const bool blocked = room_m(memory, 0) < kShort_m;
    const Micros since = sight.now - glanced_at_;
    // Each look costs the sight of them: seldom where the way is known.
    const bool known = measured_ >= kMeasured && room_m(memory, 0) > kKnown_m;
    const bool due = since > (known ? 2 * kEvery : kEvery) ||
                     (since > kSoon && (blocked || state_ == FollowState::predicted));
    const bool wanted = behind || (due && (wants_to_drive_ || since > 2 * kEvery));
    if (!wanted || state_ == FollowState::searching) return false;
    glance_since_ = sight.now;
    glance_settled_ = 0;
    // What blocks the way close by is below a level picture: only a lower one can tell that it has gone.
    const bool low = !behind && blocked && glance_at_ != Glance::low;
    glance_at_ = behind ? Glance::behind : low ? Glance::low : Glance::ahead;
    gaze_->tilt_to(low ? kLow_rad : 0);
    gaze_->pan_to(behind ? behind_side_ * M_PI
                         : std::clamp(gaze_->state(sight.now).angles.pan_rad, -kAside_rad, kAside_rad));
  }
  const Micros patience = (glance_at_ == Glance::behind ? 800 : 500) * kMillisecond;
  if (glance_settled_ == 0 && (gaze_->state(sight.now).settled || sight.now - glance_since_ > patience))
    glance_settled_ = sight.now;
  const bool seen = glance_settled_ != 0 && memory.last_look() >= glance_settled_;
  if (!seen && sight.now - glance_since_ < 2 * patience) return true;
  glance_since_ = 0;
  glanced_at_ = sight.now;
  if (seen && glance_at_ == Glance::ahead) measure_range(sight, memory);
  if (glance_at_ == Glance::behind) behind_side_ = 0;
  return false;
}

/// The person's feet stand on the floor, where distance is measured better than by a face's size or by the
/// width of clothes.
void Follower::measure_range(const Sight& sight, const memory::VisualMemory& memory) {
  constexpr double kBeside_rad = rad(14);
  constexpr double kFeet_m = 0.12;  // from where they are seen to the person's middle
  // What stands farther off from where they should be is something else.
  constexpr double kFarthest = 1.35, kNearest = 0.7;
  constexpr double kTrust = 0.5;
  constexpr double kReach_m = 1.6;  // beyond it the floor tells less than face and clothes
  if (!target_) return;
  const Vector2d here(sight.X_OR.x_m, sight.X_OR.y_m);
  const Vector2d to = place_at(glance_settled_) - here;
  const double expected_m = std::max(to.norm() / scale(target_->by_face), 0.2);
  if (expected_m > kReach_m) return;
  double feet_m = kFarthest * expected_m;
  for (const memory::ObstaclePoint& point : memory.points().all()) {
    if (point.seen_at < glance_settled_) continue;
    const Vector2d at = point.p_O_m - here;
    const double off = wrap_rad(std::atan2(at.y(), at.x()) - std::atan2(to.y(), to.x()));
    const double away_m = at.norm() + kFeet_m;
    if (std::abs(off) < kBeside_rad && away_m > kNearest * expected_m) feet_m = std::min(feet_m, away_m);
  }
  const double scale = feet_m / expected_m;
  if (scale >= kFarthest) return;
  range_scale_ += kTrust * (scale - range_scale_);
  ++measured_;
}

/// How many looks of the search are over.
std::size_t Follower::search_look(Micros now) const {
  const Micros since = target_ ? target_->t + kPredictFor : begun_at_;
  return static_cast<std::size_t>(std::max<Micros>(0, now - since) / kSearchHold);
}

double Follower::search_rad(Micros now, double bearing_rad) const {
  const double off = rad(kSearchLooks_deg[search_look(now) % kSearchLooks_deg.size()]);
  return wrap_rad(bearing_rad + search_side_ * off);
}

void Follower::move_neck(const Sight& sight, double bearing_rad, double away_m,
                         const memory::VisualMemory& memory) {
  if (!gaze_->can_pan() && !gaze_->can_tilt()) return;
  if (glance(sight, bearing_rad, memory)) return;
  double pan = bearing_rad;
  if (state_ == FollowState::searching) pan = search_rad(sight.now, bearing_rad);
  if (state_ == FollowState::gone) pan = 0;
  const NeckAngles now = gaze_->state(sight.now).angles;
  if (std::abs(pan - now.pan_rad) > kNeckDeadband_rad) gaze_->pan_to(pan);
  if (!gaze_->can_tilt()) return;
  const double up = target_ ? std::atan2(target_->height_m, std::max(away_m, 0.3)) : rad(20);
  const bool higher =
      state_ == FollowState::searching && search_look(sight.now) / kSearchLooks_deg.size() % 2;
  const double tilt = -(up - kFaceAbove_rad + (higher ? kSearchHigher_rad : 0)) - robot_.mount.tilt_rad;
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
  constexpr double kHeadway_s = 0.35, kHeadwayMost = 0.12;
  const Vector2d away(std::cos(sight.X_OR.heading_rad + bearing_rad),
                      std::sin(sight.X_OR.heading_rad + bearing_rad));
  // What they were doing when they were last seen.
  const double theirs =
      target_ ? target_->v_O_mps.dot(away) * std::exp(-seconds(sight.now - target_->t) / kWalkFades_s) : 0;
  // Who walks may turn round: behind somebody who goes it keeps farther off, before somebody who comes
  // nearer.
  const double most_m = kHeadwayMost * keep_m_;
  const double off_m = away_m - keep_m_ - std::clamp(kHeadway_s * theirs, -most_m, most_m);
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
