#pragma once
#include <atomic>
#include <cstdint>

#include "base/clock.h"
#include "hal/drive.h"
#include "model/robot_config.h"

namespace mirada::robot {

/// The only holder of the Drive: every command passes here. Disarmed after construction (and the wheels are
/// stopped).
///
/// Threads: command(), arm(), heartbeat() and frame_seen() on the control thread; stop() from any, at once
/// and without waiting; check() on any one other thread (the watchdog's) or, in lockstep, on the control
/// thread.
class Safety {
 public:
  /// One permission to drive, given to one run. 0 is never valid.
  using Epoch = std::uint64_t;
  enum class Verdict { obeyed, over, not_finite, too_fast };
  enum class Trip { none, late, stuck, blind };

  static constexpr Micros kHeartbeatLimit = 200 * kMillisecond;
  static constexpr Micros kStuckLimit = 2 * kSecond;
  static constexpr Micros kFrameLimit = 500 * kMillisecond;

  /// `drive` may be null: a robot without wheels.
  Safety(hal::Drive* drive, const DriveConfig& limits, const Clock& clock);

  /// A new run may drive; whatever held an older epoch may not any more. `uses_camera`: it must see to drive.
  Epoch arm(bool uses_camera);
  /// Wheels to zero at once. Latched: no command of a run armed before this moves the robot again.
  void stop();
  bool armed() const { return epoch_.load() != 0; }

  /// Hands speeds to the wheels. Anything but `obeyed` has put them to zero (`over`: left them at zero).
  Verdict command(Epoch epoch, const WheelSpeeds& speeds);
  /// What was last handed to the wheels. Control thread.
  WheelSpeeds commanded() const { return armed() ? commanded_ : WheelSpeeds{}; }
  bool has_drive() const { return drive_ != nullptr; }

  /// The VM has ticked: the wheels may go on for kHeartbeatLimit.
  void heartbeat() { last_heartbeat_.store(clock_->now()); }
  /// A picture exposed at `t` has arrived.
  void frame_seen(Micros t) { last_frame_.store(t); }

  /// Looks at the heartbeat and the newest picture's age. `late`: the wheels were put to zero, and the next
  /// command moves them again. `stuck` and `blind` are latched as stop() is.
  Trip check();
  /// Why the newest armed run lost its permission, when check() took it; none otherwise. Any thread.
  Trip tripped() const { return tripped_.load(); }

 private:
  void zero();

  hal::Drive* drive_;
  DriveConfig limits_;
  const Clock* clock_;
  WheelSpeeds commanded_;
  std::atomic<Epoch> epoch_{0};
  std::atomic<Epoch> next_epoch_{1};
  std::atomic<Trip> tripped_{Trip::none};
  std::atomic<bool> uses_camera_{false};
  std::atomic<Micros> last_heartbeat_{0};
  std::atomic<Micros> last_frame_{0};
};

}  // namespace mirada::robot
