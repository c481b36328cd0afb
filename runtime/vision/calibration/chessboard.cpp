#include "vision/calibration/chessboard.h"

#include <algorithm>
#include <cmath>

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "vision/calibration/messages.h"

namespace mirada::vision {
namespace {

using Corners = std::vector<cv::Point2f>;

/// Noise holds grids of 3x3 corners; hardly ever more.
constexpr std::size_t kFewestConvincing = 12;

cv::Mat shrunk(const cv::Mat& gray, double scale) {
  if (scale >= 1) return gray;
  cv::Mat out;
  cv::resize(gray, out, {}, scale, scale, cv::INTER_AREA);
  return out;
}

void stretch(Corners& corners, double scale) {
  const auto by = static_cast<float>(1 / scale);
  for (cv::Point2f& p : corners) p = (p + cv::Point2f(0.5F, 0.5F)) * by - cv::Point2f(0.5F, 0.5F);
}

bool find_at(const cv::Mat& gray, double scale, cv::Size size, bool thorough, Corners& corners) {
  const cv::Mat small = shrunk(gray, scale);
  if (std::min(small.cols, small.rows) < 60) return false;
  // The fast check keeps noise from costing half a minute; the second search takes what it is wrong about.
  const int quick = cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_NORMALIZE_IMAGE | cv::CALIB_CB_FAST_CHECK;
  bool found = cv::findChessboardCorners(small, size, corners, quick);
  if (!found && thorough) {
    found = cv::findChessboardCornersSB(small, size, corners,
                                        cv::CALIB_CB_NORMALIZE_IMAGE | cv::CALIB_CB_EXHAUSTIVE);
  }
  if (found && scale < 1) stretch(corners, scale);
  return found;
}

/// +1 when two opposite quadrants about a point are dark and the others bright, 0 when not, and nothing
/// outside the picture. `e` and `f` reach half a square along the board's directions.
std::optional<bool> is_crossing(const cv::Mat& gray, cv::Point2f at, cv::Point2f e, cv::Point2f f) {
  double grey[4];
  const cv::Point2f around[4] = {at + e + f, at - e + f, at - e - f, at + e - f};
  for (int i = 0; i < 4; ++i) {
    const cv::Point p(around[i]);
    if (p.x < 1 || p.y < 1 || p.x + 1 >= gray.cols || p.y + 1 >= gray.rows) return std::nullopt;
    grey[i] = cv::mean(gray(cv::Rect(p.x - 1, p.y - 1, 3, 3)))[0];
  }
  const double first = std::max(grey[0], grey[2]);
  const double second = std::max(grey[1], grey[3]);
  const double first_low = std::min(grey[0], grey[2]);
  const double second_low = std::min(grey[1], grey[3]);
  const double all = std::max(first, second) - std::min(first_low, second_low);
  const double gap = std::max(first_low - second, second_low - first);
  return all > 20 && gap > 0.5 * all;
}

/// Of the points one step beyond a side, how many are crossings: more than half means that the board goes on.
bool side_goes_on(const cv::Mat& gray, const Corners& corners, int start, int step, int inward, int count) {
  int crossings = 0;
  int looked = 0;
  for (int i = 0; i < count; ++i) {
    const cv::Point2f edge = corners[static_cast<std::size_t>(start + i * step)];
    const cv::Point2f inner = corners[static_cast<std::size_t>(start + i * step + inward)];
    const int neighbour = i + 1 < count ? i + 1 : i - 1;
    const cv::Point2f beside = corners[static_cast<std::size_t>(start + neighbour * step)];
    const cv::Point2f outward = edge - inner;
    // Once far from the crossing, and once near it: the outermost squares of some boards are cut narrow.
    const auto far = is_crossing(gray, edge + outward, 0.4F * outward, 0.4F * (beside - edge));
    const auto near = is_crossing(gray, edge + outward, 0.2F * outward, 0.25F * (beside - edge));
    if (!far && !near) continue;
    ++looked;
    crossings += far.value_or(false) || near.value_or(false);
  }
  return looked >= 2 && crossings * 2 > looked;
}

struct Found {
  Corners corners;
  int columns = 0;
  int rows = 0;
};

/// Whether most of a found grid's corners really are crossings of black and white.
bool convincing(const cv::Mat& gray, const Found& found) {
  int crossings = 0;
  int looked = 0;
  for (int row = 0; row + 1 < found.rows; ++row) {
    for (int column = 0; column + 1 < found.columns; ++column) {
      const auto i = static_cast<std::size_t>(row * found.columns + column);
      const cv::Point2f at = found.corners[i];
      const cv::Point2f right = found.corners[i + 1];
      const cv::Point2f below = found.corners[i + static_cast<std::size_t>(found.columns)];
      const auto crossing = is_crossing(gray, at, 0.35F * (right - at), 0.35F * (below - at));
      if (!crossing) continue;
      ++looked;
      crossings += *crossing;
    }
  }
  return crossings * 4 >= looked * 3 && looked > 0;
}

/// The largest whole piece of any chessboard in the picture.
std::optional<Found> any_chessboard(const cv::Mat& gray) {
  const double scale = std::min(1.0, 640.0 / std::max(gray.cols, gray.rows));
  const cv::Mat small = shrunk(gray, scale);
  if (std::min(small.cols, small.rows) < 60) return std::nullopt;
  Found out;
  cv::Mat meta;
  if (!cv::findChessboardCornersSB(
          small, {3, 3}, out.corners,
          cv::CALIB_CB_NORMALIZE_IMAGE | cv::CALIB_CB_EXHAUSTIVE | cv::CALIB_CB_LARGER, meta) ||
      meta.empty()) {
    return std::nullopt;
  }
  if (meta.total() < kFewestConvincing) return std::nullopt;
  out.columns = meta.cols;
  out.rows = meta.rows;
  if (!convincing(small, out)) return std::nullopt;
  if (scale < 1) stretch(out.corners, scale);
  return out;
}

/// The board's next corners would lie outside the picture (or a square is cut by its edge).
bool touches_edge(const Found& found, cv::Size size) {
  const auto outside = [&](const cv::Point2f& edge, const cv::Point2f& inner) {
    const cv::Point2f next = edge + 1.1F * (edge - inner);
    return next.x < 0 || next.y < 0 || next.x > static_cast<float>(size.width - 1) ||
           next.y > static_cast<float>(size.height - 1);
  };
  const auto at = [&](int row, int column) {
    return found.corners[static_cast<std::size_t>(row * found.columns + column)];
  };
  for (int row = 0; row < found.rows; ++row) {
    if (outside(at(row, 0), at(row, 1))) return true;
    if (outside(at(row, found.columns - 1), at(row, found.columns - 2))) return true;
  }
  for (int column = 0; column < found.columns; ++column) {
    if (outside(at(0, column), at(1, column))) return true;
    if (outside(at(found.rows - 1, column), at(found.rows - 2, column))) return true;
  }
  return false;
}

std::string grid_text(int columns, int rows) { return std::to_string(columns) + "x" + std::to_string(rows); }

}  // namespace

std::optional<Corners> rough_chessboard(const cv::Mat& gray, const BoardSpec& board) {
  const cv::Size size(board.corner_columns, board.corner_rows);
  const double first = std::min(1.0, 1280.0 / std::max(gray.cols, gray.rows));
  Corners corners;
  for (const double scale : {first, first / 2, std::min(1.0, 2 * first), first / 4}) {
    if (find_at(gray, scale, size, scale >= first / 2 && scale <= first, corners)) return corners;
  }
  return std::nullopt;
}

bool goes_on_beyond(const cv::Mat& gray, const Corners& corners, int columns) {
  const int rows = static_cast<int>(corners.size()) / columns;
  const int last = (rows - 1) * columns;
  return side_goes_on(gray, corners, 0, columns, 1, rows) ||
         side_goes_on(gray, corners, columns - 1, columns, -1, rows) ||
         side_goes_on(gray, corners, 0, 1, columns, columns) ||
         side_goes_on(gray, corners, last, 1, -columns, columns);
}

Fault why_no_chessboard(const cv::Mat& gray, const BoardSpec& board, const std::string& image) {
  const std::string wanted = grid_text(board.corner_columns, board.corner_rows);
  const auto found = any_chessboard(gray);
  if (!found) return make_fault(image, messages::board_not_seen, {{"wanted", wanted}});
  const std::string seen =
      grid_text(std::max(found->columns, found->rows), std::min(found->columns, found->rows));
  const MessageArgs args = {{"wanted", wanted}, {"seen", seen}};
  const int wide = std::max(board.corner_columns, board.corner_rows);
  const int narrow = std::min(board.corner_columns, board.corner_rows);
  const bool fits_inside =
      std::max(found->columns, found->rows) <= wide && std::min(found->columns, found->rows) <= narrow;
  if (fits_inside && touches_edge(*found, gray.size()))
    return make_fault(image, messages::board_cut_off, args);
  return make_fault(image, messages::board_other_size, args);
}

}  // namespace mirada::vision
