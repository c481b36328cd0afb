#include "robot/safety.h"

#include <algorithm>
#include <cmath>

namespace mirada::robot {
namespace {
// A heartbeat that comes late says little about the camera: a hiccup of the machine delays both.
constexpr Micros kLongestBeat = 100 * kMillisecond;
}  // namespace

Safety::Safety(hal::Drive* drive, const DriveConfig& limits, const Clock& clock)
    : drive_(drive), limits_(limits), clock_(&clock) {
  zero();
}

void Safety::zero() {
  if (drive_ != nullptr) drive_->stop();
}

void Safety::stop() { stop_and_permit(); }

Safety::Permit Safety::stop_and_permit() {
  std::uint64_t old = state_.load();
  while (!state_.compare_exchange_weak(old, (old | 1) + 1)) {
  }
  zero();
  return (old | 1) + 1;
}

Safety::Epoch Safety::arm(Permit permit, bool uses_camera) {
  commanded_ = {};
  tripped_.store(Trip::none);
  uses_camera_.store(uses_camera);
  blind_for_.store(0);
  last_heartbeat_.store(clock_->now());
  return state_.compare_exchange_strong(permit, permit + 1) ? permit + 1 : 0;
}

void Safety::end(Epoch epoch) {
  if (epoch != 0 && state_.compare_exchange_strong(epoch, epoch + 1)) zero();
}

Safety::Verdict Safety::command(Epoch epoch, const WheelSpeeds& speeds) {
  if (epoch == 0 || state_.load() != epoch) return Verdict::over;
  const bool finite = std::isfinite(speeds.left_mps) && std::isfinite(speeds.right_mps);
  const double fastest = std::max(std::abs(speeds.left_mps), std::abs(speeds.right_mps));
  if (!finite || fastest > limits_.max_wheel_mps * (1 + 1e-9)) {
    commanded_ = {};
    zero();
    return finite ? Verdict::too_fast : Verdict::not_finite;
  }
  commanded_ = speeds;
  if (drive_ != nullptr) drive_->set(speeds);
  // A stop that came between the look above and set() has been overtaken by it: stop again.
  if (state_.load() == epoch) return Verdict::obeyed;
  zero();
  return Verdict::over;
}

void Safety::heartbeat() {
  const Micros now = clock_->now();
  const Micros beat = now - last_heartbeat_.exchange(now);
  blind_for_.fetch_add(std::clamp<Micros>(beat, 0, kLongestBeat));
}

Safety::Trip Safety::check() {
  // The state is read first and changed only if it is still the same: a run armed meanwhile is not touched.
  std::uint64_t epoch = state_.load();
  if ((epoch & 1) == 0) return Trip::none;
  const Micros silence = clock_->now() - last_heartbeat_.load();
  const bool blind = uses_camera_.load() && blind_for_.load() > kFrameLimit;
  if (silence > kStuckLimit || blind) {
    const Trip trip = blind ? Trip::blind : Trip::stuck;
    tripped_.store(trip);
    if (!state_.compare_exchange_strong(epoch, epoch + 1)) return Trip::none;
    zero();
    return trip;
  }
  if (silence <= kHeartbeatLimit) return Trip::none;
  zero();
  return Trip::late;
}

}  // namespace mirada::robot
