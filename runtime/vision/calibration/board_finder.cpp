#include "vision/calibration/board_finder.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "vision/calibration/charuco.h"
#include "vision/calibration/chessboard.h"
#include "vision/calibration/messages.h"
#include "vision/calibration/print_quality.h"

namespace mirada::vision {
namespace {

constexpr int kSmallestPicture_px = 120;
constexpr double kFlatPicture = 6;  ///< grey levels, standard deviation
constexpr double kWindowShare = 0.25;
constexpr double kRoughest = 0.03;

/// What can be said before looking for a board.
Faults check_picture(const cv::Mat& gray, const std::string& image) {
  if (gray.cols < kSmallestPicture_px || gray.rows < kSmallestPicture_px) {
    return {make_fault(image, messages::picture_too_small,
                       {{"width", std::to_string(gray.cols)},
                        {"height", std::to_string(gray.rows)},
                        {"min", std::to_string(kSmallestPicture_px)}})};
  }
  cv::Scalar mean;
  cv::Scalar spread;
  cv::meanStdDev(gray, mean, spread);
  if (spread[0] >= kFlatPicture) return {};
  const Message& message = mean[0] < 60    ? messages::picture_black
                           : mean[0] > 200 ? messages::picture_white
                                           : messages::picture_flat;
  return {make_fault(image, message)};
}

/// Blur that still counts as sharp: what optics and interpolation cost on large pictures, never near a
/// square.
double widest_edge_px(cv::Size size, double square_px) {
  return std::min(std::max(5.0, 0.006 * size.width), 0.3 * square_px);
}

double median_spacing_px(const std::vector<cv::Point2f>& corners, int columns) {
  std::vector<double> spacings;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    if (i % static_cast<std::size_t>(columns) == 0) continue;
    const cv::Point2f d = corners[i] - corners[i - 1];
    if (!std::isnan(d.x)) spacings.push_back(std::hypot(d.x, d.y));
  }
  if (spacings.empty()) return 0;
  std::nth_element(spacings.begin(), spacings.begin() + static_cast<std::ptrdiff_t>(spacings.size() / 2),
                   spacings.end());
  return spacings[spacings.size() / 2];
}

/// Blur also makes stripes of squares, so it comes first and alone.
Faults check_print(const PrintQuality& quality, cv::Size size, double square_px, const std::string& image) {
  const double widest = widest_edge_px(size, square_px);
  if (quality.edge_width_px > widest) {
    return {make_fault(image, messages::board_blurred,
                       {{"value", number_text(quality.edge_width_px, 1)}, {"max", number_text(widest, 1)}})};
  }
  if (quality.roughness > kRoughest) {
    return {make_fault(
        image, messages::board_from_screen,
        {{"value", number_text(100 * quality.roughness, 1)}, {"max", number_text(100 * kRoughest, 1)}})};
  }
  return {};
}

}  // namespace

BoardFinder::BoardFinder(const BoardSpec& board) : board_(board), tags_(board.markers) {}

Result<BoardView> BoardFinder::find(const cv::Mat& gray, const std::string& image) {
  assert(gray.type() == CV_8UC1);
  if (Faults faults = check_picture(gray, image); !faults.empty()) return faults;
  std::vector<cv::Point2f> grid;
  if (board_.kind == BoardSpec::Kind::chessboard) {
    auto found = chessboard(gray, image);
    if (!found) return found.faults();
    grid = std::move(*found);
  } else {
    auto found = find_charuco(gray, board_, tags_, image);
    if (!found) return found.faults();
    grid = std::move(*found);
  }
  const PrintQuality quality = print_quality(gray, grid, board_.corner_columns);
  const double square_px = median_spacing_px(grid, board_.corner_columns);
  if (Faults faults = check_print(quality, gray.size(), square_px, image); !faults.empty()) return faults;
  BoardView view{image, gray.size(), {}, {}, quality.edge_width_px, quality.roughness};
  for (std::size_t i = 0; i < grid.size(); ++i) {
    if (std::isnan(grid[i].x)) continue;
    view.corners_px.push_back(grid[i]);
    view.corners_B_m.push_back(board_.corner_B_m(static_cast<int>(i)));
  }
  return view;
}

Result<std::vector<cv::Point2f>> BoardFinder::chessboard(const cv::Mat& gray,
                                                         const std::string& image) const {
  auto corners = rough_chessboard(gray, board_);
  if (!corners) return why_no_chessboard(gray, board_, image);
  if (goes_on_beyond(gray, *corners, board_.corner_columns)) {
    return make_fault(
        image, messages::board_larger,
        {{"wanted", std::to_string(board_.corner_columns) + "x" + std::to_string(board_.corner_rows)}});
  }
  const int half = refining_half_window_px(*corners, board_.corner_columns, gray.cols, kWindowShare);
  cv::cornerSubPix(gray, *corners, {half, half}, {-1, -1}, {3, 100, 1e-4});
  return std::move(*corners);
}

}  // namespace mirada::vision
