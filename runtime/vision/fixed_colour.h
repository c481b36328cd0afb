#pragma once
#include "vision/column_scan.h"
#include "vision/picture_grid.h"
#include "vision/visual_sonar.h"

namespace mirada::vision {

/// The paper's way: the lowest cell of the column whose colour lies in the HSV range (OpenCV's scale: 0..180,
/// 0..255, 0..255) is the boundary. Everything else counts as floor.
ColumnResult scan_fixed_colour(const PictureGrid& grid, int column, const ColumnSpan& span,
                               const SonarSettings& settings);

}  // namespace mirada::vision
