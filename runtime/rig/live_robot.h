#pragma once
#include <memory>
#include <string>

#include "base/clock.h"
#include "hal/camera.h"
#include "rig/picture_encoder.h"
#include "rig/shipped_packs.h"
#include "session/session.h"
#include "session/telemetry_board.h"
#include "world/simulation.h"

namespace mirada::rig {

/// What one live robot is built from.
struct LiveParts {
  session::Setup setup;
  world::WorldConfig world;
  RobotConfig robot;
  std::string camera;  ///< "" = the simulated one
  std::uint64_t runs_before = 0;
};

/// One robot with its room, its session and what is shown of it. step() and session() on the control thread;
/// safety(), board() and interrupting the session from any. Wall time drives the simulated room.
class LiveRobot {
 public:
  static Result<std::unique_ptr<LiveRobot>> build(const LiveParts& parts);
  ~LiveRobot();

  /// The world up to the wall clock (never more than a few steps at once), what is seen, and a VM tick when
  /// one is due.
  void step(PictureEncoder& encoder);
  /// How long step() has nothing to do from now on.
  Micros idle_for() const;
  void put_back();
  void want(const session::Wanted& wanted);

  session::Session& session() { return session_; }
  robot::Safety& safety() { return robot_.safety(); }
  const session::TelemetryBoard& board() const { return board_; }
  const packs::PackSet& packs() const { return packs_; }
  const session::Setup& setup() const { return setup_; }

 private:
  LiveRobot(const LiveParts& parts, std::unique_ptr<hal::Camera> camera, std::unique_ptr<ManualClock> clock);
  void publish();
  void wake_scripts();

  session::Setup setup_;
  std::unique_ptr<ManualClock>
      clock_;  ///< the robot's: the simulation's time, and between its steps a waking script's
  SteadyClock wall_;
  world::Simulation simulation_;
  std::unique_ptr<hal::Camera> camera_;  ///< null: the simulation's
  robot::Robot robot_;
  std::shared_ptr<blocks::Link> link_;
  packs::PackSet packs_;
  session::Session session_;
  session::TelemetryBoard board_;
  session::Wanted wanted_;
  Micros wall_behind_ = 0;  ///< wall time that the simulation will never catch up with
  Micros next_tick_ = 0;
  std::uint64_t shown_frame_ = 0;
};

}  // namespace mirada::rig
