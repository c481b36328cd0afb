#pragma once
#include <memory>
#include <string>

#include "base/clock.h"
#include "base/result.h"
#include "hal/camera.h"

namespace mirada::hal {

struct V4l2Settings {
  int width_px = 320;
  int height_px = 240;
  double fps = 20;
};

/// A USB (or any Video4Linux) camera by its device file, "/dev/video0". Opened only while enabled; the driver
/// gives the nearest size that it can. A fault when there is no such device now; one that is pulled out later
/// heals when it is back. The clock must outlive the camera. See GrabberCamera for threads.
Result<std::unique_ptr<Camera>> open_v4l2(const std::string& device, const Clock& clock,
                                          const V4l2Settings& settings = {});

}  // namespace mirada::hal
