#pragma once
#include "base/units.h"
#include "model/command.h"
#include "model/geometry.h"

namespace mirada::hal {

/// Distance that each wheel says it has rolled since opening, and the pose integrated from it (X_OR, odometry
/// frame O).
struct Odometry {
  Micros t = 0;
  Pose2 X_OR;
  WheelSpeeds speed;
};

/// Two driven wheels. Opening one stops it. set() may be called from one thread (robot/safety); stop() from
/// any, at any moment, without waiting for anything.
class Drive {
 public:
  virtual ~Drive() = default;
  virtual void set(const WheelSpeeds& speeds) = 0;
  virtual void stop() = 0;
  virtual Odometry odometry() const = 0;
};

}  // namespace mirada::hal
