#include "robot/recall.h"

#include <limits>

namespace mirada::robot {

Recall recall(const SonarView& view, Micros t_exposure, const memory::VisualMemory& memory,
              double bearing_rad) {
  if (view.in_view(bearing_rad)) return {view.at(bearing_rad), false, memory.now() - t_exposure};
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  const memory::Direction& known = memory.around().at(bearing_rad);
  if (known.answer == Answer::not_seen) return {{bearing_rad, Answer::not_seen, kUnknown, kUnknown}, true, 0};
  const SonarReading reading{bearing_rad, known.answer, known.distance_m, known.sigma_m};
  return {reading, true, memory.now() - known.seen_at};
}

}  // namespace mirada::robot
