#pragma once
#include <opencv2/core.hpp>

#include "vision/calibration/board.h"

namespace mirada::vision {

/// A board as it is printed.
struct BoardPicture {
  cv::Mat gray;  ///< CV_8UC1, a white edge one square wide round it
  double px_per_m = 0;
  cv::Point2d origin_px;  ///< the first inner corner, from the upper left corner's outer edge
};

/// `square_px` pixels a square. ChArUco boards in OpenCV's layout since 4.6: the top left square is black.
BoardPicture board_picture(const BoardSpec& board, int square_px);

}  // namespace mirada::vision
