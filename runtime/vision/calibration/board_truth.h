#pragma once
#include <vector>

#include "vision/calibration/board.h"
#include "vision/calibration/lens_fit.h"

namespace mirada::vision {

/// What a calibration's residuals say of the print itself: paper that bends, squares that are not square.
struct BoardTruth {
  double bend_m = 0;  ///< between the highest and the lowest corner, a tilted plane taken away
  double sigma_bend_m = 0;
  double stretch = 1;  ///< width to height of a square
  double sigma_stretch = 0;
};

/// One step of least squares from a lens that was fitted to a flat board of squares: a second-order surface
/// and a stretch along the rows beside the lens's numbers, every view's pose left free. Sigma is infinite for
/// what the views cannot tell (all of them frontal).
BoardTruth examine_board(const std::vector<BoardView>& views, const LensFit& fit);

}  // namespace mirada::vision
