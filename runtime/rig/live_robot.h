#pragma once
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "base/clock.h"
#include "hal/camera.h"
#include "rig/mount_watch.h"
#include "rig/picture_encoder.h"
#include "rig/shipped_packs.h"
#include "session/session.h"
#include "session/telemetry_board.h"
#include "vision/identity/face_book.h"
#include "world/simulation.h"

namespace mirada::rig {

/// Who looks at each new picture on the control thread, with where the neck points; empty = nobody.
using FrameTap = std::function<void(const Frame&, const NeckAngles&)>;

/// Where words for the log go; called on the control thread.
using Tell = std::function<void(const Fault&)>;

/// What one live robot is built from.
struct LiveParts {
  session::Setup setup;
  world::WorldConfig world;
  RobotConfig robot;       ///< what is believed of it
  RobotConfig body;        ///< what the simulation makes of it: as its file says, whatever was measured since
  std::string camera;      ///< "" = the simulated one
  std::string face_model;  ///< "" = the one that was fetched, or none
  std::shared_ptr<vision::FaceBook> book = std::make_shared<vision::FaceBook>();  ///< who is known
  std::uint64_t runs_before = 0;
  Faults notes;  ///< what is odd about these files, in words
  Tell tell;     ///< hears what the start-up check found; may be empty
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
  /// From now on pictures are taken for this too.
  void tap(FrameTap tap);
  void hold_board(std::optional<world::HeldBoard> board) { simulation_.hold_board(std::move(board)); }

  session::Session& session() { return session_; }
  robot::Safety& safety() { return robot_.safety(); }
  const session::TelemetryBoard& board() const { return board_; }
  const packs::PackSet& packs() const { return packs_; }
  const session::Setup& setup() const { return setup_; }
  /// What is known of the camera's place and lens, in words. Any thread.
  Faults camera_words() const;
  const RobotConfig& config() const { return robot_.config(); }

 private:
  LiveRobot(const LiveParts& parts, std::unique_ptr<hal::Camera> camera, std::unique_ptr<ManualClock> clock);
  void publish();
  void wake_scripts();
  void show_picture(PictureEncoder& encoder);
  void update_wanted();
  void check_mount(const Frame& frame);

  session::Setup setup_;
  mutable std::mutex words_mutex_;
  Faults words_;  // under words_mutex_
  MountWatch mount_watch_;
  Tell tell_;
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
  FrameTap tap_;
  Micros wall_behind_ = 0;  ///< wall time that the simulation will never catch up with
  Micros next_tick_ = 0;
  std::uint64_t shown_frame_ = 0;
};

}  // namespace mirada::rig
