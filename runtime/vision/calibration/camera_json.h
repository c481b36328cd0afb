#pragma once
#include <nlohmann/json_fwd.hpp>

#include "vision/calibration/solve.h"

namespace mirada::vision {

/// The camera.json of a calibration (docs/calibration.md), which robot.json's "calibration" names.
nlohmann::ordered_json camera_json(const Calibration& calibration, const BoardSpec& board,
                                   const std::string& preset_id);

}  // namespace mirada::vision
