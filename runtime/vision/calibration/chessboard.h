#pragma once
#include <optional>
#include <vector>

#include <opencv2/core.hpp>

#include "vision/calibration/board.h"

namespace mirada::vision {

/// The board's corners, row by row, to a few pixels; nothing when the picture does not show them all. A
/// blurred board is found too, in a smaller copy of the picture.
std::optional<std::vector<cv::Point2f>> rough_chessboard(const cv::Mat& gray, const BoardSpec& board);

/// Whether the pattern goes on beyond the corners found: then it is a larger board.
bool goes_on_beyond(const cv::Mat& gray, const std::vector<cv::Point2f>& corners_px, int columns);

/// Why no whole board was found, in a sentence with what to do.
Fault why_no_chessboard(const cv::Mat& gray, const BoardSpec& board, const std::string& image);

}  // namespace mirada::vision
