#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "session/calibration.h"
#include "session/known_faces.h"
#include "session/telemetry.h"

namespace mirada::session {

/// A thing that can be chosen in the editor (room or robot).
struct Option {
  std::string id;
  std::string name_en;
  std::string name_es;
};

struct Setup {
  std::string world;  ///< "" on a real robot
  std::string robot;
  std::uint64_t seed = 1;
  bool simulated = true;
  std::string place{};  ///< what the robot knows of where it is: id or file; "" = no map
};

/// Which panels somebody looks at: camera, renderer and detectors run only for them or for the running
/// program.
struct Wanted {
  bool camera = false;
  bool sonar = false;
  bool faces = false;
  bool room = false;
  bool memory = false;
};

/// A program that was loaded and started.
struct Started {
  std::uint64_t run = 0;  ///< as in Telemetry
  Faults warnings;
};

/// One robot with one session on it, live or simulated, as the server sees it. rig/ builds it. Thread-safe:
/// every call may come from any thread and returns within a few milliseconds (start: within the time to
/// compile).
class Station {
 public:
  virtual ~Station() = default;

  /// Stops what runs, loads the program and presses the flag. A stop() that comes meanwhile wins.
  virtual Result<Started> start(const std::string& program_json) = 0;
  /// Motors are at zero when this returns, whatever the program does. Never waits for program, frame or
  /// client.
  virtual void stop(StopReason why) = 0;
  virtual void pause(bool on) = 0;
  virtual void key(const std::string& name, bool down) = 0;
  /// Evaluates one reporter block of this program once, while nothing or something runs. `answer` is called
  /// once from another thread: the value, or the fault.
  virtual void evaluate(const std::string& program_json, const std::string& block_id,
                        std::function<void(Result<vm::MonitorValue>)> answer) = 0;

  virtual Setup setup() const = 0;
  virtual std::vector<Option> worlds() const = 0;
  virtual std::vector<Option> robots() const = 0;
  /// Builds the robot anew (stops first). Ok, or every fault; then the old one stays.
  virtual Status choose(const Setup& setup) = 0;
  /// Stops, and puts the simulated robot back to its start.
  virtual Status put_back() = 0;

  virtual void want(const Wanted& wanted) = 0;
  virtual std::shared_ptr<const Telemetry> telemetry() const = 0;
  /// Null until the first picture, and when nobody wanted one.
  virtual std::shared_ptr<const Picture> picture() const = 0;

  /// The cameras whose datasheets are known.
  virtual std::vector<Option> cameras() const = 0;
  /// A step of the calibration wizard. begin stops what runs; start(), choose() and cancel end it. save
  /// writes the file, keeps the one before, and builds the robot anew with it. Ok, or why not.
  virtual Status calibrate(const CalibrationStep& step) = 0;
  /// Never null.
  virtual std::shared_ptr<const Calibration> calibration() const = 0;
  /// What the start-up check found out about the camera's place; nothing while there is nothing to say.
  virtual std::optional<Fault> camera_words() const = 0;

  virtual KnownFaces known_faces() const = 0;
  /// KnownFaces::revision alone; costs nothing.
  virtual std::uint64_t known_faces_revision() const = 0;
  /// Ok once it is written down, or why not.
  virtual Status change_faces(const FacesStep& step) = 0;
};

}  // namespace mirada::session
