#include "vision/faces/textured_areas.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace mirada::vision {
namespace {

constexpr int kAreaCell_px = 16;
constexpr int kDenseCells = 5;           // of three times three
constexpr double kNoise = 5;             // grey levels, one sigma: a cheap camera's is 3
constexpr double kSavesTooLittle = 0.8;  // of the picture

/// 1 where a cell varies by more than noise.
cv::Mat textured_cells(const cv::Mat& gray) {
  cv::Mat cells((gray.rows + kAreaCell_px - 1) / kAreaCell_px, (gray.cols + kAreaCell_px - 1) / kAreaCell_px,
                CV_8U);
  for (int y = 0; y < cells.rows; ++y) {
    for (int x = 0; x < cells.cols; ++x) {
      const cv::Rect cell = cv::Rect(x * kAreaCell_px, y * kAreaCell_px, kAreaCell_px, kAreaCell_px) &
                            cv::Rect({}, gray.size());
      cv::Scalar mean, spread;
      cv::meanStdDev(gray(cell), mean, spread);
      cells.at<std::uint8_t>(y, x) = spread[0] > kNoise ? 1 : 0;
    }
  }
  return cells;
}

/// Boxes that touch or overlap become one.
std::vector<cv::Rect> merged(std::vector<cv::Rect> boxes) {
  for (bool again = true; again;) {
    again = false;
    for (std::size_t i = 0; i < boxes.size() && !again; ++i) {
      for (std::size_t j = i + 1; j < boxes.size() && !again; ++j) {
        if ((boxes[i] & boxes[j]).area() == 0) continue;
        boxes[i] |= boxes[j];
        boxes.erase(boxes.begin() + static_cast<std::ptrdiff_t>(j));
        again = true;
      }
    }
  }
  return boxes;
}

}  // namespace

std::vector<cv::Rect> textured_areas(const cv::Mat& gray) {
  cv::Mat around, dense, labels, stats, middles;
  cv::boxFilter(textured_cells(gray), around, CV_8U, {3, 3}, {-1, -1}, false, cv::BORDER_REPLICATE);
  // A face's rim lies in the cells beside.
  cv::dilate(around >= kDenseCells, dense, {});
  const int count = cv::connectedComponentsWithStats(dense, labels, stats, middles, 8);
  std::vector<cv::Rect> boxes;
  for (int i = 1; i < count; ++i) {
    const auto of = [&](int what) { return kAreaCell_px * stats.at<int>(i, what); };
    boxes.push_back(
        {of(cv::CC_STAT_LEFT), of(cv::CC_STAT_TOP), of(cv::CC_STAT_WIDTH), of(cv::CC_STAT_HEIGHT)});
  }
  const cv::Rect picture({}, gray.size());
  boxes = merged(std::move(boxes));
  int kept = 0;
  for (cv::Rect& box : boxes) {
    box &= picture;
    kept += box.area();
  }
  if (kept > kSavesTooLittle * picture.area()) return {picture};
  return boxes;
}

}  // namespace mirada::vision
