#pragma once
#include <deque>

#include "memory/attention.h"
#include "robot/gaze.h"

namespace mirada::robot {

/// Moves the neck for attention: saccade, settle, look, choose. A look counts when a picture that is not
/// blurred, exposed after the neck came to rest, has been remembered. Whoever aims the neck by a block ends
/// it. Control thread.
class Watch {
 public:
  Watch(Gaze& gaze, const RobotConfig& robot) : gaze_(&gaze), half_view_rad_(robot.camera.hfov_rad() / 2) {}

  /// Goes on until something else is asked for.
  void keep(memory::Watching what);
  memory::Watching keeping() const { return attention_.watching(); }
  /// Looks once at all that the neck can show within 80° to both sides, then ahead; afterwards goes on with
  /// what it kept an eye on.
  void look_around();
  bool looking_around() const { return !stops_.empty(); }
  /// rest(), and the camera ahead.
  void rest_ahead();
  /// The neck is somebody else's.
  void rest();

  struct Sight {
    Micros now = 0;
    double speed_mps = 0;
    double turn_radps = 0;
    std::optional<double> face_rad;
  };
  void step(const memory::VisualMemory& memory, const Sight& sight);
  const memory::NextLook& next() const { return next_; }

 private:
  memory::GazeRange range(const Sight& sight) const;
  bool look_is_over(const memory::VisualMemory& memory, Micros now);
  void level();
  void aim(const memory::NextLook& look, Micros now);

  Gaze* gaze_;
  double half_view_rad_;
  memory::Attention attention_;
  memory::NextLook next_;
  std::deque<double> stops_;
  bool sweep_asked_ = false;
  bool aimed_ = false;
  Micros since_ = 0;
  Micros settled_ = 0;  ///< 0: the neck is on its way
};

}  // namespace mirada::robot
