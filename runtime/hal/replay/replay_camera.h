#pragma once
#include <filesystem>
#include <memory>

#include "base/clock.h"
#include "base/result.h"
#include "hal/camera.h"

namespace mirada::hal {

struct ReplaySettings {
  double fps = 0;    ///< pictures a second; 0 = the video's own, 20 for pictures
  bool loop = true;  ///< begin again at the end; otherwise health() says that it has ended
};

/// A camera that shows a picture file, a folder of pictures (in the order of their names) or a video file at
/// its pace on the injected clock. Disabled it stands still and goes on where it stood. poll() decodes at
/// most the picture that it gives. A picture that cannot be read is passed over; health() tells of it until
/// the next good one. The clock must outlive the camera.
Result<std::unique_ptr<Camera>> open_replay(const std::filesystem::path& path, const Clock& clock,
                                            const ReplaySettings& settings = {});

}  // namespace mirada::hal
