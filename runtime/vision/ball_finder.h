#pragma once
#include <optional>

#include "model/frame.h"
#include "model/percepts.h"
#include "model/robot_config.h"

namespace mirada::vision {

/// Finds the largest red ball on the floor (one fixed colour). One thread.
class BallFinder {
 public:
  explicit BallFinder(const RobotConfig& robot) : robot_(robot) {}

  /// `neck` at the frame's exposure. Where its foot stands; nothing when there is no red blob of a ball's
  /// shape, or its foot is out of the picture.
  std::optional<ThingSeen> find(const Frame& frame, const NeckAngles& neck);

 private:
  RobotConfig robot_;
  cv::Mat hsv_, mask_, other_;
};

}  // namespace mirada::vision
