#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "hal/drive.h"
#include "model/robot_config.h"
#include "robot/safety.h"

namespace mirada::robot {

/// Who started a motion: the script's id and the block's.
struct MotionOwner {
  std::uint64_t script = 0;
  std::string block;
};

/// One motion that was asked for; never given twice.
using MotionTicket = std::uint64_t;

enum class MotionState {
  going,
  done,       ///< arrived and at rest
  overtaken,  ///< a newer command or a stop has taken its place
  stalled,    ///< given up: the robot did not get there
};

/// What moves the wheels: one motion at a time, the newest wins. Distances by the wheels' odometry, speeds
/// ramped by the robot's own limits, no overshoot. Everything goes through Safety. Control thread.
class Motion {
 public:
  Motion(const DriveConfig& drive, Safety& safety);

  /// The run that may move from now on (0: none may). Ends what was going on.
  void begin_run(Safety::Epoch epoch);
  bool may_move() const { return epoch_ != 0 && safety_->armed(); }
  Safety::Epoch run() const { return epoch_; }

  MotionTicket drive(double distance_m, MotionOwner owner);  ///< positive forward
  MotionTicket turn(double angle_rad, MotionOwner owner);    ///< positive left
  /// Goes on until something else is asked for.
  MotionTicket set_speeds(const WheelSpeeds& target, MotionOwner owner);
  /// A motion whose speeds somebody gives step by step, until finish_steered() or something else is asked
  /// for.
  MotionTicket steered(MotionOwner owner);
  void steer(MotionTicket ticket, const WheelSpeeds& target);
  void finish_steered(MotionTicket ticket, MotionState how);
  /// Brakes now, without a ramp.
  void halt();
  /// halt(), if this script started the motion that is going on.
  void script_ended(std::uint64_t script);
  /// halt(), if it is set speeds or a steered motion that is going on; who asked for it.
  std::optional<MotionOwner> end_set_speeds();
  /// Zero while paused; afterwards a drive or a turn goes on to where it wanted to go.
  void pause(bool on) { paused_ = on; }
  bool paused() const { return paused_; }

  MotionState state(MotionTicket ticket) const;
  const MotionOwner& owner() const { return owner_; }

  /// One control step, after the scripts of a tick. What Safety refused (`over` when the run is over).
  Safety::Verdict step(Micros now, const hal::Odometry& odometry);

 private:
  enum class Kind { none, drive, turn, speeds, steered };
  struct Stall {
    Micros since = 0;
    double remaining = 0;
  };

  MotionTicket begin(Kind kind, double goal, MotionOwner owner);
  void finish(MotionState how);
  WheelSpeeds drive_speeds(const hal::Odometry& odometry, double dt_s);
  WheelSpeeds turn_speeds(const hal::Odometry& odometry, double dt_s);
  void follow(Micros now, const hal::Odometry& odometry);
  void watch_progress(Micros now, const hal::Odometry& odometry);

  DriveConfig drive_;
  Safety* safety_;
  Safety::Epoch epoch_ = 0;
  Kind kind_ = Kind::none;
  MotionOwner owner_;
  MotionTicket ticket_ = 0;
  MotionState last_state_ = MotionState::done;
  bool paused_ = false;
  bool started_ = false;   ///< the odometry at the start is known
  bool arrived_ = false;   ///< at the goal, waiting for rest
  double goal_ = 0;        ///< m or rad, signed
  double remaining_ = 0;   ///< m or rad, in the goal's direction
  double speed_ = 0;       ///< m/s or rad/s, in the goal's direction
  Pose2 X_OS_;             ///< odometry at the start
  double turned_rad_ = 0;  ///< since the start, unwrapped
  double last_heading_rad_ = 0;
  WheelSpeeds target_;
  WheelSpeeds command_;
  Micros last_step_ = 0;
  Stall stall_;
};

}  // namespace mirada::robot
