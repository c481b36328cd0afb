#pragma once
#include "model/camera_preset.h"
#include "vision/calibration/solve.h"

namespace mirada::vision {

/// The fewest different pictures that a calibration is trusted with.
inline constexpr int kFewestViews = 6;

/// The largest rms error that is trusted; it grows with pictures wider than 800 pixels.
double highest_rms_px(const CameraModel& camera);

/// Everything that keeps a calibration from being trusted, each with what to do; empty when it can be.
Faults distrust(const Calibration& calibration);

/// Compares the field of view with the camera's datasheet. A view that no mode of the camera has is an error
/// that names the camera it would fit (`others`); a picture shape that the sheet does not know is a warning.
Faults check_datasheet(const Calibration& calibration, const CameraPreset& preset,
                       const std::vector<CameraPreset>& others);

}  // namespace mirada::vision
