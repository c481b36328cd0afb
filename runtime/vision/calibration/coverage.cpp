#include "vision/calibration/coverage.h"

#include <opencv2/imgproc.hpp>

namespace mirada::vision {

Coverage coverage_of(const std::vector<BoardView>& views) {
  constexpr int kWide = 96;
  constexpr int kHigh = 72;
  cv::Mat mask = cv::Mat::zeros(kHigh, kWide, CV_8UC1);
  for (const BoardView& view : views) {
    std::vector<cv::Point2f> hull;
    cv::convexHull(view.corners_px, hull);
    std::vector<cv::Point> small;
    for (const cv::Point2f& p : hull) {
      small.emplace_back(cvRound((p.x + 0.5F) * kWide / static_cast<float>(view.size_px.width) - 0.5F),
                         cvRound((p.y + 0.5F) * kHigh / static_cast<float>(view.size_px.height) - 0.5F));
    }
    cv::fillConvexPoly(mask, small, 255);
  }
  Coverage out;
  out.share = cv::countNonZero(mask) / static_cast<double>(kWide * kHigh);
  for (int zone = 0; zone < 9; ++zone) {
    const cv::Rect part(zone % 3 * kWide / 3, zone / 3 * kHigh / 3, kWide / 3, kHigh / 3);
    out.zones.push_back(cv::countNonZero(mask(part)) / static_cast<double>(part.area()));
  }
  return out;
}

}  // namespace mirada::vision
