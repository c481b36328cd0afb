#include "robot/safety.h"

#include <algorithm>
#include <cmath>

namespace mirada::robot {

Safety::Safety(hal::Drive* drive, const DriveConfig& limits, const Clock& clock)
    : drive_(drive), limits_(limits), clock_(&clock) {
  zero();
}

Safety::Epoch Safety::arm(bool uses_camera) {
  stop();
  commanded_ = {};
  tripped_.store(Trip::none);
  uses_camera_.store(uses_camera);
  last_heartbeat_.store(clock_->now());
  // The picture's age counts from the start: an old picture from before it is no reason to refuse.
  last_frame_.store(std::max(last_frame_.load(), clock_->now()));
  const Epoch mine = next_epoch_.fetch_add(1);
  epoch_.store(mine);
  return mine;
}

void Safety::stop() {
  epoch_.store(0);
  zero();
}

void Safety::zero() {
  if (drive_ != nullptr) drive_->stop();
}

Safety::Verdict Safety::command(Epoch epoch, const WheelSpeeds& speeds) {
  if (epoch == 0 || epoch_.load() != epoch) return Verdict::over;
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
  if (epoch_.load() != epoch) {
    zero();
    return Verdict::over;
  }
  return Verdict::obeyed;
}

Safety::Trip Safety::check() {
  // The epoch is read first and taken back only if it is still the same: a run armed meanwhile is not
  // touched.
  Epoch epoch = epoch_.load();
  if (epoch == 0) return Trip::none;
  const Micros now = clock_->now();
  const Micros silence = now - last_heartbeat_.load();
  const bool blind = uses_camera_.load() && now - last_frame_.load() > kFrameLimit;
  if (silence > kStuckLimit || blind) {
    const Trip trip = silence > kStuckLimit ? Trip::stuck : Trip::blind;
    if (!epoch_.compare_exchange_strong(epoch, 0)) return Trip::none;
    tripped_.store(trip);
    zero();
    return trip;
  }
  if (silence <= kHeartbeatLimit) return Trip::none;
  zero();
  return Trip::late;
}

}  // namespace mirada::robot
