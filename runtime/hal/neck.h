#pragma once
#include "base/units.h"
#include "model/geometry.h"

namespace mirada::hal {

struct NeckState {
  Micros t = 0;
  NeckAngles angles;
  bool settled = true;  ///< at its target
};

/// A pan (and tilt) servo with a range and a speed. Targets out of range are clamped by the caller (robot/),
/// refused by nobody.
class Neck {
 public:
  virtual ~Neck() = default;
  virtual void aim(const NeckAngles& target) = 0;
  /// Stays where it is now.
  virtual void hold() = 0;
  virtual NeckState state() const = 0;
};

}  // namespace mirada::hal
