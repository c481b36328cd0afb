#pragma once
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "vision/calibration/board.h"
#include "vision/tags/tag_finder.h"

namespace mirada::vision {

/// The inner corners of a ChArUco board, row by row, refined; NaN where no mark beside a corner was seen or
/// the corner lies at the picture's edge. Both layouts are known (before and since OpenCV 4.6). Refused with
/// the reason: no marks, another board, too little of the board.
Result<std::vector<cv::Point2f>> find_charuco(const cv::Mat& gray, const BoardSpec& board, TagFinder& tags,
                                              const std::string& image);

}  // namespace mirada::vision
