#pragma once
#include <memory>
#include <string>

#include "base/clock.h"
#include "base/result.h"
#include "hal/camera.h"
#include "model/robot_config.h"

namespace mirada::rig {

/// Opens the camera that `spec` names: "v4l2:0" or "v4l2:/dev/video0" (a USB camera), or a picture, folder or
/// video file that is replayed at its own pace. Frames are stamped on `clock`, which must outlive the
/// camera.
Result<std::unique_ptr<hal::Camera>> open_camera(const std::string& spec, const RobotConfig& robot,
                                                 const Clock& clock);

}  // namespace mirada::rig
