#pragma once
#include <deque>
#include <memory>
#include <optional>

#include "hal/camera.h"
#include "model/robot_config.h"
#include "robot/detectors.h"
#include "robot/face_worker.h"
#include "robot/motion_history.h"

namespace mirada::robot {

/// Live: answers come when they come, faces from a thread of their own. Simulated: everything on the caller's
/// thread, and each answer is held back until it is as old as robot.json says.
enum class Timing { live, simulated };

/// What somebody needs now: the running program's blocks, an open panel.
struct Needs {
  bool frames = false;
  bool sonar = false;
  bool faces = false;
  bool memory = false;  ///< remember what is seen; wants sonar too
  bool things = false;  ///< tags and balls
  bool place = false;   ///< where it is: tags and lines, when it knows a place with some

  bool any() const { return frames || sonar || faces || memory || things; }
  Needs operator|(const Needs& other) const {
    return {frames || other.frames, sonar || other.sonar,   faces || other.faces,
            memory || other.memory, things || other.things, place || other.place};
  }
  bool operator==(const Needs&) const = default;
};

/// From pictures to percepts. Camera and detectors work only while they are needed. Control thread.
class Perception {
 public:
  /// `camera` may be null: a robot that cannot see.
  Perception(hal::Camera* camera, Detectors detectors, const LatencyConfig& latency, Timing timing);

  void need(const Needs& needs);
  const Needs& needs() const { return needs_; }
  bool has_camera() const { return camera_ != nullptr; }
  Status health() const;

  /// Takes a picture that is due and publishes what has been seen by `now`. True when a picture came.
  bool step(Micros now, const MotionHistory& history);

  /// Never null. The newest answers; each knows its picture's exposure time.
  const std::shared_ptr<const Percepts>& percepts() const { return percepts_; }
  /// The newest picture; number 0 before the first.
  const Frame& frame() const { return frame_; }
  /// Why faces cannot be looked for, if so.
  const std::optional<Fault>& faces_trouble() const { return faces_trouble_; }

  /// Whose faces are known; null = faces are not told apart here.
  std::shared_ptr<vision::FaceBook> known_faces() const { return detectors_.book; }

  /// The robot was put elsewhere: forgets the floor's look and everything seen.
  void forget();

 private:
  template <class T>
  struct Due {
    Micros at;
    T percept;
  };

  void look(const Frame& frame, Micros now, const MotionHistory& history);
  void look_for_faces(const Frame& frame, Micros now, const MotionHistory::State& then);
  void accept(Result<FacesPercept> found, Micros due);
  void publish(Micros now);

  hal::Camera* camera_;
  Detectors detectors_;
  LatencyConfig latency_;
  Timing timing_;
  Needs needs_;
  Frame frame_;
  std::uint64_t pictures_ = 0;  ///< taken, whatever their numbers
  Micros forgotten_at_ = -1;    ///< the newest picture then
  std::shared_ptr<const Percepts> percepts_ = std::make_shared<const Percepts>();
  std::deque<Due<SonarPercept>> sonar_due_;
  std::deque<Due<FacesPercept>> faces_due_;
  std::deque<Due<ThingsPercept>> things_due_;
  std::deque<Due<LinesPercept>> lines_due_;
  std::optional<Fault> faces_trouble_;
  std::unique_ptr<FaceWorker> face_worker_;
};

}  // namespace mirada::robot
