#pragma once
#include <memory>
#include <string>
#include <vector>

#include "hal/neck.h"
#include "memory/visual_memory.h"
#include "robot/follower.h"
#include "robot/gaze.h"
#include "robot/localizer.h"
#include "robot/motion.h"
#include "robot/perception.h"
#include "robot/pilot.h"
#include "robot/recall.h"
#include "robot/seeing.h"
#include "robot/watch.h"

namespace mirada::robot {

/// What the robot is made of. Any may be missing (null). They must outlive the robot.
struct Devices {
  hal::Camera* camera = nullptr;
  hal::Drive* drive = nullptr;
  hal::Neck* neck = nullptr;
};

/// Something odd that a block met, in words (a warning on the block).
struct Note {
  std::string block;
  Fault fault;
};

/// All that a program may touch of a robot. Control thread, but for what Safety allows elsewhere.
class Robot {
 public:
  /// `clock` is the robot's; `guard` is safety's, which must go on whatever the control thread does
  /// (lockstep: the same).
  Robot(RobotConfig config, const Devices& devices, Detectors detectors, Timing timing, const Clock& clock,
        const Clock& guard);

  /// Every world step (10 ms): where am I, what is there to be seen.
  void observe();
  /// Every VM tick, after the scripts: the behaviours' commands go through safety to the wheels.
  Safety::Verdict act();

  const RobotConfig& config() const { return config_; }
  Micros now() const { return clock_->now(); }
  Safety& safety() { return safety_; }
  Motion& motion() { return motion_; }
  Gaze& gaze() { return gaze_; }
  Perception& perception() { return perception_; }
  const Perception& perception() const { return perception_; }
  const hal::Odometry& odometry() const { return odometry_; }
  /// What must be seen from now on.
  void need(Needs needs);
  /// What the robot itself wants to see, for what it was told to do.
  Needs own_needs() const;
  SonarView sonar() const;
  Pilot& pilot() { return pilot_; }
  Follower& follower() { return follower_; }
  const Follower& follower() const { return follower_; }
  /// Where it is in the place that it knows, if it knows one.
  const Localizer& localizer() const { return localizer_; }
  /// Where a run began, in O: what "where I started" means.
  void mark_start() {
    X_OS_ = odometry_.X_OR;
    start_mark_ = memory_.drift().now();
    met_face_ = false;
  }
  const Pose2& start_pose() const { return X_OS_; }
  /// How badly the wheels alone may tell where that was, 1-sigma.
  double drift_since_start_m() const;
  Watch& watch() { return watch_; }
  const Watch& watch() const { return watch_; }
  memory::VisualMemory& memory() { return memory_; }
  const memory::VisualMemory& memory() const { return memory_; }
  /// In view: what is seen now. Elsewhere: what is remembered.
  Recall obstacle_at(double bearing_rad) const;
  /// The newest faces, or null when they are too old to say anything.
  const FacesPercept* faces() const;
  /// Whose faces are known; null = faces are not told apart here.
  std::shared_ptr<vision::FaceBook> known_faces() { return perception_.known_faces(); }
  /// Whether a face has been seen since the run began.
  bool met_face() const { return met_face_; }

  void note(const std::string& block, Fault fault);
  std::vector<Note> take_notes();

  /// The robot was put elsewhere: nothing seen or driven before holds.
  void forget();

 private:
  void remember();
  void remember_things();
  void locate();
  void attend();

  RobotConfig config_;
  Devices devices_;
  const Clock* clock_;
  Safety safety_;
  Motion motion_;
  Gaze gaze_;
  Perception perception_;
  MotionHistory history_;
  memory::VisualMemory memory_;
  Watch watch_;
  Pilot pilot_;
  Follower follower_;
  Localizer localizer_;
  bool met_face_ = false;
  Pose2 X_OS_;
  memory::DriftMark start_mark_;
  std::uint64_t remembered_frame_ = 0;
  std::uint64_t remembered_things_ = 0;
  std::uint64_t remembered_faces_ = 0;
  std::uint64_t located_things_ = 0;
  std::uint64_t located_lines_ = 0;
  hal::Odometry odometry_;
  std::vector<Note> notes_;
};

}  // namespace mirada::robot
