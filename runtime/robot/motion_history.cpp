#include "robot/motion_history.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace mirada::robot {
namespace {

constexpr Micros kKept = 2 * kSecond;

constexpr Micros kAround = 15 * kMillisecond;
constexpr double kNeckRate_radps = 0.35;  // at 10 ms of exposure: a pixel
constexpr double kBodyRate_radps = 1.8;

double mix(double a, double b, double part) { return a + (b - a) * part; }

MotionHistory::State between(const MotionHistory::State& a, const MotionHistory::State& b, double part) {
  MotionHistory::State out;
  out.X_OR.x_m = mix(a.X_OR.x_m, b.X_OR.x_m, part);
  out.X_OR.y_m = mix(a.X_OR.y_m, b.X_OR.y_m, part);
  out.X_OR.heading_rad =
      wrap_rad(a.X_OR.heading_rad + part * wrap_rad(b.X_OR.heading_rad - a.X_OR.heading_rad));
  out.neck.pan_rad = mix(a.neck.pan_rad, b.neck.pan_rad, part);
  out.neck.tilt_rad = mix(a.neck.tilt_rad, b.neck.tilt_rad, part);
  return out;
}

}  // namespace

void MotionHistory::record(Micros t, const State& state) {
  assert(samples_.empty() || t >= samples_.back().t);
  if (!samples_.empty() && samples_.back().t == t) {
    samples_.back().state = state;
    return;
  }
  samples_.push_back({t, state});
  while (samples_.size() > 2 && samples_.front().t < t - kKept) samples_.pop_front();
}

MotionHistory::State MotionHistory::at(Micros t) const {
  if (samples_.empty()) return {};
  const auto after = std::lower_bound(samples_.begin(), samples_.end(), t,
                                      [](const Sample& sample, Micros when) { return sample.t < when; });
  if (after == samples_.end()) return samples_.back().state;
  if (after == samples_.begin() || after->t == t) return after->state;
  const Sample& before = *std::prev(after);
  const double part = static_cast<double>(t - before.t) / static_cast<double>(after->t - before.t);
  return between(before.state, after->state, part);
}

bool MotionHistory::steady(Micros t) const {
  const State before = at(t - kAround);
  const State after = at(t + kAround);
  const double span_s = seconds(2 * kAround);
  const double pan_rad = std::abs(after.neck.pan_rad - before.neck.pan_rad);
  const double tilt_rad = std::abs(after.neck.tilt_rad - before.neck.tilt_rad);
  const double turn_rad = std::abs(wrap_rad(after.X_OR.heading_rad - before.X_OR.heading_rad));
  return std::max(pan_rad, tilt_rad) <= kNeckRate_radps * span_s && turn_rad <= kBodyRate_radps * span_s;
}

}  // namespace mirada::robot
