#include "vision/calibration/charuco.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "vision/calibration/messages.h"
#include "vision/calibration/print_quality.h"

namespace mirada::vision {
namespace {

constexpr double kBoardNoise_px = 3;
constexpr int kFewestMarks = 4;
constexpr float kMargin_px = 3;

/// Where the marks stand: white squares, counted row by row. `first_white` is 1 when the top left square is
/// black (OpenCV 4.6 and later, and every odd number of rows before), 0 when it is white.
struct Layout {
  int columns = 0;
  int rows = 0;
  int first_white = 1;

  /// Row and column of the square that bears a mark; nothing for an id that this board lacks.
  std::optional<cv::Point> square_of(int id) const {
    int count = 0;
    for (int row = 0; row < rows; ++row) {
      const int shift = (row + first_white) % 2;
      const int here = (columns - shift + 1) / 2;
      if (id < count + here) return cv::Point(shift + 2 * (id - count), row);
      count += here;
    }
    return std::nullopt;
  }
};

/// Corners of a square's mark in units of squares, from the board's top left; top left first, clockwise.
std::array<cv::Point2d, 4> mark_corners(const cv::Point& square, double mark) {
  const double a = (1 - mark) / 2;
  const double b = (1 + mark) / 2;
  const cv::Point2d at(square.x, square.y);
  return {at + cv::Point2d(a, a), at + cv::Point2d(b, a), at + cv::Point2d(b, b), at + cv::Point2d(a, b)};
}

struct Fit {
  Layout layout;
  cv::Mat H;
  std::vector<TagSighting> marks;  ///< those that stand where the layout wants them
};

/// The marks that one board in this layout explains.
Fit fit_layout(const std::vector<TagSighting>& seen, const Layout& layout, double mark) {
  std::vector<cv::Point2d> board;
  std::vector<cv::Point2d> picture;
  std::vector<const TagSighting*> known;
  for (const TagSighting& sighting : seen) {
    const auto square = layout.square_of(sighting.id);
    if (!square) continue;
    const auto corners = mark_corners(*square, mark);
    board.insert(board.end(), corners.begin(), corners.end());
    picture.insert(picture.end(), sighting.corners_px.begin(), sighting.corners_px.end());
    known.push_back(&sighting);
  }
  Fit fit{layout, {}, {}};
  if (known.size() < kFewestMarks) return fit;
  std::vector<uchar> inliers;
  // A lens bends the board by more than the corners' noise: what is refused here are wrong ids.
  const double most_px = std::max(kBoardNoise_px, 0.25 * cv::norm(picture[1] - picture[0]));
  fit.H = cv::findHomography(board, picture, cv::RANSAC, most_px, inliers);
  if (fit.H.empty()) return fit;
  for (std::size_t i = 0; i < known.size(); ++i) {
    const uchar* at = &inliers[4 * i];
    if (at[0] && at[1] && at[2] && at[3]) fit.marks.push_back(*known[i]);
  }
  return fit;
}

cv::Point2d mapped(const cv::Mat& H, const cv::Point2d& p) {
  const cv::Mat q = H * (cv::Mat_<double>(3, 1) << p.x, p.y, 1.0);
  return {q.at<double>(0) / q.at<double>(2), q.at<double>(1) / q.at<double>(2)};
}

/// Every inner corner as its neighbouring marks foretell it: near a mark the lens bends little.
std::vector<cv::Point2f> foretold(const Fit& fit, const BoardSpec& board) {
  const auto count = static_cast<std::size_t>(board.corner_count());
  std::vector<cv::Point2d> sum(count, {0, 0});
  std::vector<int> votes(count, 0);
  const double mark = board.marker_m / board.square_m;
  for (const TagSighting& sighting : fit.marks) {
    const cv::Point square = *fit.layout.square_of(sighting.id);
    const auto corners = mark_corners(square, mark);
    const cv::Mat H = cv::getPerspectiveTransform(
        std::vector<cv::Point2f>(corners.begin(), corners.end()),
        std::vector<cv::Point2f>(sighting.corners_px.begin(), sighting.corners_px.end()));
    for (int i = 0; i < 4; ++i) {
      const cv::Point corner = square + cv::Point(i % 2, i / 2);  // inner corner number is one less
      if (corner.x < 1 || corner.y < 1 || corner.x > board.corner_columns || corner.y > board.corner_rows)
        continue;
      const auto at = static_cast<std::size_t>((corner.y - 1) * board.corner_columns + corner.x - 1);
      sum[at] += mapped(H, corner);
      ++votes[at];
    }
  }
  const float none = std::numeric_limits<float>::quiet_NaN();
  std::vector<cv::Point2f> out(count, {none, none});
  for (std::size_t i = 0; i < count; ++i) {
    if (votes[i] > 0) out[i] = cv::Point2f(sum[i] * (1.0 / votes[i]));
  }
  return out;
}

void refine(const cv::Mat& gray, const BoardSpec& board, std::vector<cv::Point2f>& grid) {
  const float none = std::numeric_limits<float>::quiet_NaN();
  // The window must stay between a corner and the marks beside it.
  const double gap = 0.9 * (1 - board.marker_m / board.square_m) / 2;
  const int half = refining_half_window_px(grid, board.corner_columns, gray.cols, std::min(0.25, gap));
  for (cv::Point2f& corner : grid) {
    if (std::isnan(corner.x)) continue;
    const bool inside = corner.x > kMargin_px && corner.y > kMargin_px &&
                        corner.x < static_cast<float>(gray.cols) - kMargin_px - 1 &&
                        corner.y < static_cast<float>(gray.rows) - kMargin_px - 1;
    if (!inside) {
      corner = {none, none};
      continue;
    }
    std::vector<cv::Point2f> one = {corner};
    cv::cornerSubPix(gray, one, {half, half}, {-1, -1}, {3, 100, 1e-4});
    corner = cv::norm(one[0] - corner) <= half ? one[0] : cv::Point2f(none, none);
  }
}

}  // namespace

Result<std::vector<cv::Point2f>> find_charuco(const cv::Mat& gray, const BoardSpec& board, TagFinder& tags,
                                              const std::string& image) {
  const std::vector<TagSighting> seen = tags.find(gray);
  const int squares_x = board.corner_columns + 1;
  const int squares_y = board.corner_rows + 1;
  const std::string wanted = std::to_string(squares_x) + "x" + std::to_string(squares_y);
  if (seen.size() < kFewestMarks) {
    return make_fault(image, messages::charuco_few_marks,
                      {{"seen", std::to_string(seen.size())}, {"min", std::to_string(kFewestMarks)}});
  }
  const double mark = board.marker_m / board.square_m;
  const Fit newer = fit_layout(seen, {squares_x, squares_y, 1}, mark);
  const Fit older = fit_layout(seen, {squares_x, squares_y, 0}, mark);
  const Fit& fit = older.marks.size() > newer.marks.size() ? older : newer;
  if (fit.marks.size() < kFewestMarks || fit.marks.size() * 10 < seen.size() * 7) {
    return make_fault(image, messages::charuco_other_board, {{"wanted", wanted}});
  }
  std::vector<cv::Point2f> grid = foretold(fit, board);
  refine(gray, board, grid);
  const auto found = std::count_if(grid.begin(), grid.end(), [](const auto& p) { return !std::isnan(p.x); });
  const int needed = std::max(8, board.corner_count() / 4);
  if (found < needed) {
    return make_fault(image, messages::charuco_too_little,
                      {{"seen", std::to_string(found)}, {"min", std::to_string(needed)}});
  }
  return grid;
}

}  // namespace mirada::vision
