#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.h"
#include "model/camera_model.h"

namespace mirada {

/// Reads a camera.json (docs/calibration.md), what `mirada calibrate` writes. On success `warnings` holds
/// what was odd but harmless (unknown fields). Any thread.
Result<CameraModel> read_camera_file(std::string_view json_text, const std::string& file_name,
                                     Faults* warnings = nullptr);
Result<CameraModel> load_camera_file(const std::filesystem::path& file, Faults* warnings = nullptr);

}  // namespace mirada
