#pragma once
#include "memory/visual_memory.h"
#include "robot/seeing.h"

namespace mirada::robot {

/// An answer and where it comes from.
struct Recall {
  SonarReading reading;     ///< from the robot's origin as it stands now
  bool remembered = false;  ///< false: seen now
  Micros age = 0;           ///< of the oldest look that it rests on
};

/// What is known of one direction: what `view` sees there now, else what memory holds. `t_exposure` is the
/// view's picture.
Recall recall(const SonarView& view, Micros t_exposure, const memory::VisualMemory& memory,
              double bearing_rad);

}  // namespace mirada::robot
