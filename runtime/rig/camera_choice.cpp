#include "rig/camera_choice.h"

#include "hal/replay/replay_camera.h"
#include "hal/v4l2/v4l2_camera.h"

namespace mirada::rig {

Result<std::unique_ptr<hal::Camera>> open_camera(const std::string& spec, const RobotConfig& robot,
                                                 const Clock& clock) {
  constexpr std::string_view kUsb = "v4l2:";
  if (!spec.starts_with(kUsb)) return hal::open_replay(spec, clock, {});
  hal::V4l2Settings settings;
  settings.width_px = robot.camera.width_px;
  settings.height_px = robot.camera.height_px;
  settings.fps = robot.camera_fps;
  const std::string device = spec.substr(kUsb.size());
  return hal::open_v4l2(device.starts_with('/') ? device : "/dev/video" + device, clock, settings);
}

}  // namespace mirada::rig
