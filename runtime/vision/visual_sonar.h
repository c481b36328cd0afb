#pragma once
#include <memory>

#include "model/frame.h"
#include "model/percepts.h"
#include "model/robot_config.h"

namespace mirada::vision {

struct SonarSettings {
  enum class Floor { learnt, fixed_colour };
  Floor floor = Floor::learnt;
  /// For fixed_colour: HSV range of the *boundary* (the paper's GREEN_MIN/GREEN_MAX by default).
  double hsv_min[3] = {20, 50, 100};
  double hsv_max[3] = {90, 235, 210};
  bool lines_are_obstacles = false;
  double range_m = 3.0;  ///< farther floor is not trusted: clear to at most this
};

/// Obstacle distance in every direction from pictures: per column the floor's boundary, bottom to top, the
/// floor's look learnt (Ulrich & Nourbakhsh 2000 in spirit). Keeps the floor model between pictures; no
/// allocation after the first picture of a size beyond the percept it returns. One thread.
class VisualSonar {
 public:
  VisualSonar(const RobotConfig& robot, const SonarSettings& settings = {});
  ~VisualSonar();

  /// `neck` and `X_OR` at the frame's exposure. A frame of another size than calibrated with the same aspect
  /// is scaled; any other gives not_seen everywhere.
  SonarPercept look(const Frame& frame, const NeckAngles& neck, const Pose2& X_OR);

  /// Forgets the learnt floor (robot put elsewhere).
  void forget();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mirada::vision
