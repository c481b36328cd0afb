#pragma once
#include <opencv2/core.hpp>

#include "vision/calibration/board.h"

namespace mirada::vision {

/// Finds one kind of board in pictures. One thread.
class BoardFinder {
 public:
  explicit BoardFinder(const BoardSpec& board);

  /// The board's corners in a CV_8UC1 picture, to about a twentieth of a pixel; or why not and what to do:
  /// too small, without contrast, no board, cut off, another board, blurred, from a screen. `image` names the
  /// picture in faults. All inner corners of a chessboard; of a ChArUco board those whose marks are seen.
  Result<BoardView> find(const cv::Mat& gray, const std::string& image);

  const BoardSpec& board() const { return board_; }

 private:
  Result<std::vector<cv::Point2f>> chessboard(const cv::Mat& gray, const std::string& image) const;

  BoardSpec board_;
  TagFinder tags_;
};

}  // namespace mirada::vision
