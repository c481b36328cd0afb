#pragma once
#include <cstdint>

#include <opencv2/core.hpp>

#include "base/units.h"

namespace mirada {

/// One picture. The pixels are shared and never written after they have been handed on.
struct Frame {
  cv::Mat bgr;               ///< CV_8UC3
  Micros t_exposure = 0;     ///< middle of the exposure, on the robot's clock
  std::uint64_t number = 0;  ///< counts up by one a picture of one camera; 0 = no picture yet
};

}  // namespace mirada
