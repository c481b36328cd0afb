#pragma once
#include <vector>

#include "vision/calibration/board.h"

namespace mirada::vision {

/// Which part of the picture a board has been shown in, as shares 0..1.
struct Coverage {
  double share = 0;
  std::vector<double> zones;  ///< of nine zones, row by row
};
Coverage coverage_of(const std::vector<BoardView>& views);

}  // namespace mirada::vision
