#pragma once
#include "base/units.h"

namespace mirada::rig {

// The beat of a simulated robot, live and in lockstep.
inline constexpr Micros kWorldStep = 10 * kMillisecond;
inline constexpr Micros kTick = 20 * kMillisecond;

}  // namespace mirada::rig
