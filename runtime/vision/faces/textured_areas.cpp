#include "vision/faces/textured_areas.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace mirada::vision {
namespace {

constexpr int kParts = 3;         // a square's, each way
constexpr int kVaryingParts = 7;  // of nine
// One sigma, of the square's mean level. The seventh of a face's parts has 0.11 and more; a wall 0.01 to
// 0.04.
constexpr double kVaries = 0.06;
constexpr int kStepsASide = 4;        // squares are asked this close together
constexpr double kAreaCost = 12;      // cells' worth of work to begin one more area
constexpr double kBorderCells = 2.0;  // an area is read wider than its squares begin
constexpr double kFull = 0.95;        // an area is not cut further

/// The sum in a rectangle, from an integral picture.
template <typename T>
double sum_of(const cv::Mat& integral, int x, int y, int w, int h) {
  const T* top = integral.ptr<T>(y);
  const T* bottom = integral.ptr<T>(y + h);
  return static_cast<double>(bottom[x + w] - top[x + w] - bottom[x] + top[x]);
}

int step_of(int side_px) { return std::max(2, side_px / kStepsASide); }

/// Work to search an area of the size of these cells.
double cost(const cv::Rect& cells) {
  return cells.empty() ? 0 : kAreaCost + (cells.width + kBorderCells) * (cells.height + kBorderCells);
}

}  // namespace

void TexturedAreas::look(const cv::Mat& gray) {
  size_ = gray.size();
  cv::integral(gray, sums_, squares_, CV_32S, CV_64F);
}

bool TexturedAreas::may_be_face(int x, int y, int side_px) const {
  const double mean = sum_of<int>(sums_, x, y, side_px, side_px) / (static_cast<double>(side_px) * side_px);
  const double least = kVaries * kVaries * mean * mean;
  const int part = side_px / kParts;
  const double n = static_cast<double>(part) * part;
  int varying = 0;
  for (int i = 0; i < kParts * kParts; ++i) {
    // Even if all the others vary.
    if (varying + kParts * kParts - i < kVaryingParts) return false;
    const int left = x + i % kParts * part, top = y + i / kParts * part;
    const double level = sum_of<int>(sums_, left, top, part, part) / n;
    const double square = sum_of<double>(squares_, left, top, part, part) / n;
    varying += square - level * level > least ? 1 : 0;
  }
  return varying >= kVaryingParts;
}

const std::vector<cv::Rect>& TexturedAreas::of_side(int side_px) {
  areas_.clear();
  const int step = step_of(side_px);
  const cv::Size begins(size_.width - side_px + 1, size_.height - side_px + 1);
  if (begins.width <= 0 || begins.height <= 0) return areas_;
  cells_.create((begins.height + step - 1) / step, (begins.width + step - 1) / step, CV_8U);
  for (int row = 0; row < cells_.rows; ++row) {
    for (int column = 0; column < cells_.cols; ++column) {
      const int x = std::min(column * step + step / 2, begins.width - 1);
      const int y = std::min(row * step + step / 2, begins.height - 1);
      cells_.at<std::uint8_t>(row, column) = may_be_face(x, y, side_px) ? 1 : 0;
    }
  }
  cv::integral(cells_, counts_, CV_32S);
  cover({0, 0, cells_.cols, cells_.rows}, step, side_px);
  return areas_;
}

cv::Rect TexturedAreas::trimmed(cv::Rect cells) const {
  const auto empty = [&](int x, int y, int w, int h) { return sum_of<int>(counts_, x, y, w, h) == 0; };
  while (cells.height > 0 && empty(cells.x, cells.y, cells.width, 1)) ++cells.y, --cells.height;
  while (cells.height > 0 && empty(cells.x, cells.y + cells.height - 1, cells.width, 1)) --cells.height;
  if (cells.height == 0) return {};
  while (empty(cells.x, cells.y, 1, cells.height)) ++cells.x, --cells.width;
  while (empty(cells.x + cells.width - 1, cells.y, 1, cells.height)) --cells.width;
  return cells;
}

/// Cuts in two where that saves most, as long as it saves.
void TexturedAreas::cover(cv::Rect cells, int step_px, int side_px) {
  cells = trimmed(cells);
  if (cells.empty()) return;
  cv::Rect first, second;
  double least = cost(cells);
  const auto try_cut = [&](const cv::Rect& a, const cv::Rect& b) {
    const cv::Rect left = trimmed(a), right = trimmed(b);
    const double both = cost(left) + cost(right);
    if (both < least) least = both, first = left, second = right;
  };
  if (sum_of<int>(counts_, cells.x, cells.y, cells.width, cells.height) < kFull * cells.area()) {
    for (int x = 1; x < cells.width; ++x)
      try_cut({cells.x, cells.y, x, cells.height}, {cells.x + x, cells.y, cells.width - x, cells.height});
    for (int y = 1; y < cells.height; ++y)
      try_cut({cells.x, cells.y, cells.width, y}, {cells.x, cells.y + y, cells.width, cells.height - y});
  }
  if (first.empty()) {
    const cv::Rect area(cells.x * step_px, cells.y * step_px, cells.width * step_px + side_px - 1,
                        cells.height * step_px + side_px - 1);
    areas_.push_back(area & cv::Rect({}, size_));
    return;
  }
  cover(first, step_px, side_px);
  cover(second, step_px, side_px);
}

}  // namespace mirada::vision
