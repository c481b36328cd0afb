#include "vision/calibration/view_collector.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "vision/calibration/guide_messages.h"

namespace mirada::vision {
namespace {

constexpr double kStillShift = 0.004;  ///< of the picture
constexpr double kStillSize = 0.015;
constexpr double kStillTurn_rad = rad(4);
constexpr double kNewShift = 0.08;
constexpr double kNewSize = 0.2;
constexpr double kNewTurn_rad = rad(9);
constexpr double kThereShift = 0.14;
constexpr double kThereSize = 0.35;
constexpr double kThereTurn_rad = rad(16);
constexpr int kPatience = 80;  ///< pictures
constexpr double kGoodCoverage = 0.5;
constexpr double kGoodTilt_rad = rad(25);

double turn_rad(const BoardHold& a, const BoardHold& b) {
  return std::acos(std::clamp(a.normal_C.dot(b.normal_C), -1.0, 1.0));
}

bool alike(const BoardHold& a, const BoardHold& b, double shift, double size, double most_turn_rad) {
  return (a.middle - b.middle).norm() < shift && std::abs(std::log(a.size / b.size)) < size &&
         turn_rad(a, b) < most_turn_rad;
}

struct Wish {
  HoldWish hold;
  const Message* words;
};

/// Middle, corners, tilts, near and far: what lens, focal length and distortion each need.
std::vector<Wish> tour() {
  const double t = rad(28);
  const double s = rad(18);
  return {{{0.5, 0.5, 0.6, 0, 0}, &messages::hold_middle},
          {{0.0, 0.0, 0.5, s, 0}, &messages::hold_top_left},
          {{1.0, 0.0, 0.5, 0, s}, &messages::hold_top_right},
          {{1.0, 1.0, 0.5, -s, 0}, &messages::hold_bottom_right},
          {{0.0, 1.0, 0.5, 0, -s}, &messages::hold_bottom_left},
          {{0.5, 0.5, 0.65, t, 0}, &messages::hold_top_near},
          {{0.5, 0.5, 0.65, -t, 0}, &messages::hold_bottom_near},
          {{0.5, 0.5, 0.65, 0, t}, &messages::hold_right_near},
          {{0.5, 0.5, 0.65, 0, -t}, &messages::hold_left_near},
          {{0.5, 0.5, 0.92, 0, 0}, &messages::hold_near},
          {{0.0, 0.5, 0.5, t, s}, &messages::hold_left_edge},
          {{1.0, 0.5, 0.5, -t, s}, &messages::hold_right_edge},
          {{0.5, 0.0, 0.45, -s, -s}, &messages::hold_top_edge},
          {{0.5, 1.0, 0.45, s, -s}, &messages::hold_bottom_edge}};
}

}  // namespace

ViewCollector::ViewCollector(const BoardSpec& board, const CameraModel& guess)
    : board_(board), camera_(guess) {
  for (const Wish& wish : tour()) {
    const auto X_CB = pose_for(wish.hold, board, camera_);
    const auto hold = X_CB ? hold_at(*X_CB, board, camera_) : std::nullopt;
    if (hold) tour_.push_back({wish.words, *hold, false});
  }
}

ViewCollector::Verdict ViewCollector::look(const BoardView& view, bool now) {
  const auto hold = hold_of(view, board_, camera_);
  if (!hold) {
    last_.reset();
    return Verdict::unclear;
  }
  const bool still = last_ && alike(*hold, *last_, kStillShift, kStillSize, kStillTurn_rad);
  last_ = hold;
  if (views_.size() >= kMost) return Verdict::full;
  if (++tries_ > kPatience) {
    const auto stop = std::find_if(tour_.begin(), tour_.end(), [](const Stop& s) { return !s.done; });
    if (stop != tour_.end()) stop->done = true;
    tries_ = 0;
  }
  if (!is_new(*hold)) return Verdict::known;
  if (!still && !now) return Verdict::moving;
  take(view, *hold);
  return Verdict::taken;
}

bool ViewCollector::is_new(const BoardHold& hold) const {
  return std::none_of(holds_.begin(), holds_.end(), [&](const BoardHold& kept) {
    return alike(hold, kept, kNewShift, kNewSize, kNewTurn_rad);
  });
}

void ViewCollector::take(const BoardView& view, const BoardHold& hold) {
  for (const BoardHold& kept : holds_) tilt_spread_rad_ = std::max(tilt_spread_rad_, turn_rad(hold, kept));
  views_.push_back(view);
  holds_.push_back(hold);
  coverage_ = coverage_of(views_);
  for (Stop& stop : tour_) {
    if (stop.done || !alike(hold, stop.hold, kThereShift, kThereSize, kThereTurn_rad)) continue;
    stop.done = true;
    tries_ = 0;
  }
}

bool ViewCollector::enough() const {
  if (views_.size() >= kMost) return true;
  // A lens or board for which the tour has no more places: whether it can be trusted the judge will say.
  const bool toured = !next();
  if (views_.size() < (toured ? kFew : kGood) || tilt_spread_rad_ < kGoodTilt_rad) return false;
  return toured || coverage_.share >= kGoodCoverage;
}

std::optional<NextHold> ViewCollector::next() const {
  for (const Stop& stop : tour_) {
    if (!stop.done) return NextHold{stop.words, stop.hold.X_CB};
  }
  return std::nullopt;
}

}  // namespace mirada::vision
