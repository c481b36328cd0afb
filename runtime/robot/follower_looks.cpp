#include <algorithm>
#include <array>
#include <cmath>

#include "robot/follower.h"

// Where the follower looks: at them, at the floor now and then, behind, and all round after a loss.
namespace mirada::robot {
namespace {

using Eigen::Vector2d;

constexpr double kFaceAbove_rad = rad(9);  // the face's place above the picture's middle, so that the trunk
                                           // is in it
constexpr double kNeckDeadband_rad = rad(1.2);
// Looks off where they should be, in degrees, positive the way they went, each held: a face is found in a
// picture that is still.
constexpr std::array kSearchLooks_deg{0, 40, -40, 80, 120, 160, -160, -120, -80};
constexpr Micros kSearchHold = 800 * kMillisecond;
constexpr double kSearchHigher_rad = rad(12);  // every other round: somebody nearer than expected

}  // namespace

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

}  // namespace mirada::robot
