#pragma once
#include "model/percepts.h"

namespace mirada::robot {

/// How surely a distance can be relied on, 0..1: the chance that the true one lies within a tenth of it (at
/// least 2 cm), from its sigma. 0 for what was not seen.
double sureness(const SonarReading& reading);

}  // namespace mirada::robot
