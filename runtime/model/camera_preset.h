#pragma once
#include <string>
#include <vector>

#include "base/result.h"

namespace mirada {

/// One way a camera delivers pictures: which part of the sensor they show. Holds for every picture of the
/// same shape (width : height), scaled or not.
struct CameraMode {
  int width_px = 0;
  int height_px = 0;
  double hfov_rad = 0;
  double vfov_rad = 0;
};

/// What a camera's datasheet says of it (runtime/model/cameras/<id>.json).
struct CameraPreset {
  std::string id;
  std::string name_en;
  std::string name_es;
  double tolerance = 0.06;  ///< how far a sample may differ from the sheet's field of view, relative
  std::vector<CameraMode> modes;

  /// The mode of the picture's shape whose view is nearest to the measured one; null when no mode has that
  /// shape.
  const CameraMode* nearest_mode(int width_px, int height_px, double hfov_rad) const;
  bool agrees(const CameraMode& mode, double hfov_rad) const;
};

/// The ids of the cameras that we know, sorted, and one of them or of a file by path; every fault at once.
std::vector<std::string> shipped_cameras();
Result<CameraPreset> camera_preset(const std::string& id_or_path);

}  // namespace mirada
