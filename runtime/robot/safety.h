#pragma once
#include <atomic>
#include <cstdint>

#include "base/clock.h"
#include "hal/drive.h"
#include "model/robot_config.h"

namespace mirada::robot {

/// The only holder of the Drive: every command passes here. Disarmed after construction, and the wheels are
/// stopped.
///
/// Threads: arm(), command(), heartbeat() and frame_seen() on the control thread; everything else on any, at
/// once and without waiting.
class Safety {
 public:
  /// A promise of the future: arm() takes it if nobody has stopped the robot since it was given.
  using Permit = std::uint64_t;
  /// One run's right to drive. 0 is never valid.
  using Epoch = std::uint64_t;
  enum class Verdict { obeyed, over, not_finite, too_fast };
  enum class Trip { none, late, stuck, blind };

  static constexpr Micros kHeartbeatLimit = 200 * kMillisecond;
  static constexpr Micros kStuckLimit = 2 * kSecond;
  static constexpr Micros kFrameLimit = 500 * kMillisecond;

  /// `drive` may be null: a robot without wheels. `clock` must go on when the control thread does not.
  Safety(hal::Drive* drive, const DriveConfig& limits, const Clock& clock);

  /// Wheels to zero at once. Latched: no run armed or permitted before this moves the robot again.
  void stop();
  /// stop(), and leave for one run to be armed later.
  Permit stop_and_permit();
  /// The run may drive from now on; 0 when somebody has stopped the robot since. `uses_camera`: it must see
  /// to drive.
  Epoch arm(Permit permit, bool uses_camera);
  /// The run is over: as stop(), but touches nothing when this epoch is over already.
  void end(Epoch epoch);
  bool armed() const { return (state_.load() & 1) != 0; }

  /// Hands speeds to the wheels. Anything but `obeyed` has put them, or left them, at zero.
  Verdict command(Epoch epoch, const WheelSpeeds& speeds);
  /// What was last handed to the wheels. Control thread.
  WheelSpeeds commanded() const { return armed() ? commanded_ : WheelSpeeds{}; }
  bool has_drive() const { return drive_ != nullptr; }

  /// The VM has ticked: the wheels may go on for kHeartbeatLimit.
  void heartbeat();
  /// A picture of this age has arrived.
  void frame_seen(Micros age) { blind_for_.store(age); }

  /// Looks at the heartbeat and at how long no picture came while it beat. `late`: the wheels were put to
  /// zero, and the next command moves them again. `stuck` and `blind` are latched as stop() is.
  Trip check();
  /// Why the newest run lost its right, when check() took it; none otherwise.
  Trip tripped() const { return tripped_.load(); }

 private:
  void zero();

  hal::Drive* drive_;
  DriveConfig limits_;
  const Clock* clock_;
  WheelSpeeds commanded_;
  std::atomic<std::uint64_t> state_{2};  ///< even: disarmed, a permit; odd: armed, an epoch; only ever grows
  std::atomic<Trip> tripped_{Trip::none};
  std::atomic<bool> uses_camera_{false};
  std::atomic<Micros> last_heartbeat_{0};
  std::atomic<Micros> blind_for_{0};
};

}  // namespace mirada::robot
