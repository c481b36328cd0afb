#pragma once
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "base/result.h"
#include "vision/tags/tag_finder.h"

namespace mirada::vision {

/// A printed calibration board. Board frame B: origin at the first inner corner, x along a row, y down the
/// columns, z into the paper; metres.
struct BoardSpec {
  enum class Kind { chessboard, charuco };

  Kind kind = Kind::chessboard;
  int corner_columns = 9;  ///< inner corners along a row: squares minus one
  int corner_rows = 6;
  double square_m = 0.025;
  double marker_m = 0;  ///< charuco only: side of a marker's black square
  TagFamily markers = TagFamily::aruco_4x4;

  int corner_count() const { return corner_columns * corner_rows; }
  /// Inner corner number i, row by row.
  cv::Point3f corner_B_m(int i) const;
};

/// The inner corners of one board found in one picture.
struct BoardView {
  std::string image;
  cv::Size size_px;
  std::vector<cv::Point2f> corners_px;  ///< pixel centres at integers
  std::vector<cv::Point3f> corners_B_m;
  double edge_width_px = 0;  ///< 10 to 90 % of a black-white step, of the blurrier direction
  double roughness = 0;      ///< grain inside black squares, as a share of the black-white step
};

/// Reads a board's measures as people give them: "9x6", mm. `marker_mm` 0 means three fifths of a square.
/// Every fault at once.
Result<BoardSpec> chessboard_spec(const std::string& corners, double square_mm);
/// `squares` counts squares, as ChArUco boards do; `dictionary` is 4x4, 5x5, 6x6 or 36h11.
Result<BoardSpec> charuco_spec(const std::string& squares, double square_mm, double marker_mm,
                               const std::string& dictionary);

}  // namespace mirada::vision
