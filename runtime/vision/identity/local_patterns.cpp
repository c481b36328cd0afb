#include "vision/identity/local_patterns.h"

#include <array>
#include <bit>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace mirada::vision {
namespace {

constexpr int kCells = 6;  // a side
constexpr int kUniform = 58;
constexpr int kBinsACell = kUniform + 1;  // the last one: all that are not uniform
constexpr int kRing_px = 2;

/// Bins of the 256 patterns; uniform are those with at most two changes round the circle.
std::array<int, 256> pattern_bins() {
  std::array<int, 256> out{};
  int next = 0;
  for (unsigned pattern = 0; pattern < 256; ++pattern) {
    const auto ring = static_cast<std::uint8_t>(pattern);
    const int changes = std::popcount(static_cast<std::uint8_t>(ring ^ std::rotl(ring, 1)));
    out[pattern] = changes <= 2 ? next++ : kUniform;
  }
  return out;
}

unsigned pattern_at(const cv::Mat& grey, int x, int y) {
  constexpr std::array<std::pair<int, int>, 8> kRing{
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  const int middle = grey.at<std::uint8_t>(y, x);
  unsigned out = 0;
  for (std::size_t i = 0; i < kRing.size(); ++i) {
    const auto [dx, dy] = kRing[i];
    if (grey.at<std::uint8_t>(y + kRing_px * dy, x + kRing_px * dx) >= middle) out |= 1U << i;
  }
  return out;
}

}  // namespace

std::vector<float> local_patterns(const cv::Mat& grey) {
  static const std::array<int, 256> kBins = pattern_bins();
  cv::Mat smooth;
  cv::GaussianBlur(grey, smooth, {0, 0}, 1.0);
  std::vector<float> out(static_cast<std::size_t>(kCells * kCells * kBinsACell), 0.F);
  for (int y = kRing_px; y < smooth.rows - kRing_px; ++y) {
    for (int x = kRing_px; x < smooth.cols - kRing_px; ++x) {
      const int cell = y * kCells / smooth.rows * kCells + x * kCells / smooth.cols;
      out[static_cast<std::size_t>(cell * kBinsACell + kBins[pattern_at(smooth, x, y)])] += 1;
    }
  }
  for (float& value : out) value = std::sqrt(value);
  return out;
}

}  // namespace mirada::vision
