#pragma once
#include <opencv2/core.hpp>

#include "base/units.h"

namespace mirada::hal {

/// A device that pictures are pulled out of, one blocking call each. Used by one thread.
class CaptureDevice {
 public:
  virtual ~CaptureDevice() = default;
  virtual bool open() = 0;
  virtual void close() = 0;
  /// Waits for the next picture (CV_8UC3) into memory of its own; `age` becomes the time since its exposure.
  /// False when the device is gone or silent.
  virtual bool read(cv::Mat& bgr, Micros& age) = 0;
};

}  // namespace mirada::hal
