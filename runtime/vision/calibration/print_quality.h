#pragma once
#include <vector>

#include <opencv2/core.hpp>

namespace mirada::vision {

/// How well a grid of corners is pictured. `corners_px` row by row, `columns` of them in a row; a corner that
/// was not seen is NaN.
struct PrintQuality {
  double edge_width_px =
      0;                 ///< 10 to 90 % of the black-white step, median of the blurrier of both directions
  double roughness = 0;  ///< grain inside the black squares as a share of the black-white step, median
};
PrintQuality print_quality(const cv::Mat& gray, const std::vector<cv::Point2f>& corners_px, int columns);

/// Half the side of the window that a corner may be refined in without meeting its neighbours: `share` of the
/// smallest spacing, in pixels; never more than a picture so wide has use for.
int refining_half_window_px(const std::vector<cv::Point2f>& corners_px, int columns, int picture_width_px,
                            double share);

}  // namespace mirada::vision
