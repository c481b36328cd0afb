#pragma once
#include <atomic>
#include <deque>
#include <mutex>

#include "base/clock.h"
#include "hal/camera.h"

namespace mirada::world {

/// The simulated camera's end of the wire: pictures ripen for the robot's latency, the newest ripe one can be
/// polled once. poll() on one thread, expose() on the simulation's, enable() and health() on any.
class SimCamera final : public hal::Camera {
 public:
  SimCamera(Micros latency, const Clock& clock) : latency_(latency), clock_(clock) {}

  std::optional<Frame> poll() override;
  Status health() const override { return Ok{}; }
  void enable(bool on) override;

  bool enabled() const { return enabled_.load(); }
  /// A picture that was just taken; gets the next number.
  void expose(cv::Mat bgr, Micros t_exposure);
  /// Pictures on their way are lost (the robot was put elsewhere).
  void drop();

 private:
  static constexpr std::size_t kMostPending = 16;

  Micros latency_;
  const Clock& clock_;
  std::atomic<bool> enabled_{false};
  std::mutex mutex_;
  std::deque<Frame> pending_;
  std::uint64_t number_ = 0;
};

}  // namespace mirada::world
