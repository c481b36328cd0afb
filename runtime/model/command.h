#pragma once

namespace mirada {

/// Speeds of the two tyres on the floor. The only thing a drive takes.
struct WheelSpeeds {
  double left_mps = 0;
  double right_mps = 0;
};

}  // namespace mirada
