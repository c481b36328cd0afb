#pragma once
#include <memory>

#include "base/result.h"
#include "model/frame.h"
#include "model/percepts.h"
#include "model/robot_config.h"

namespace mirada::vision {

/// Finds faces in one picture with Debian's Haar cascade. One thread.
class FaceFinder {
 public:
  /// Fault in words when the cascade's file is missing (package opencv-data).
  static Result<std::unique_ptr<FaceFinder>> open(const RobotConfig& robot);
  virtual ~FaceFinder() = default;
  virtual FacesPercept find(const Frame& frame, const NeckAngles& neck) = 0;
};

}  // namespace mirada::vision
