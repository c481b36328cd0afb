#include "vision/calibration/board_picture.h"

#include <cmath>

#include <opencv2/imgproc.hpp>

#include "vision/tags/tag_picture.h"

namespace mirada::vision {
namespace {

void put_mark(cv::Mat& gray, const BoardSpec& board, cv::Rect square, int id) {
  const int side = static_cast<int>(std::lround(square.width * board.marker_m / board.square_m));
  const int edge = (square.width - side) / 2;
  cv::Mat mark;
  cv::resize(tag_picture(board.markers, id), mark, {side, side}, 0, 0, cv::INTER_NEAREST);
  mark.copyTo(gray(cv::Rect(square.x + edge, square.y + edge, side, side)));
}

}  // namespace

BoardPicture board_picture(const BoardSpec& board, int square_px) {
  const int columns = board.corner_columns + 1;
  const int rows = board.corner_rows + 1;
  BoardPicture out;
  out.gray = cv::Mat((rows + 2) * square_px, (columns + 2) * square_px, CV_8UC1, cv::Scalar(255));
  int id = 0;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const cv::Rect square((column + 1) * square_px, (row + 1) * square_px, square_px, square_px);
      if ((row + column) % 2 == 0) {
        out.gray(square).setTo(20);
      } else if (board.kind == BoardSpec::Kind::charuco) {
        put_mark(out.gray, board, square, id++);
      }
    }
  }
  out.px_per_m = square_px / board.square_m;
  out.origin_px = cv::Point2d(2.0 * square_px, 2.0 * square_px);
  return out;
}

}  // namespace mirada::vision
