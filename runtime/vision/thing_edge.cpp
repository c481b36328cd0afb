#include "vision/thing_edge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace mirada::vision {
namespace {

constexpr int kEdgeRows = 8;
constexpr int kEdgeSteps = 16;  // from one line before the thing's last to one line behind
constexpr double kMiddle = 0.5;
constexpr int kFaint = 12;  // of 765, a row: less is noise
constexpr double kOutside = 0.75;

}  // namespace

double thing_edge(const PictureGrid& grid, int column, int beside, double row) {
  std::array<std::array<int, 3>, kEdgeSteps> change{};
  int rows = 0;
  const int first = static_cast<int>(row) - 1;
  for (int r = first; r > first - kEdgeRows && grid.sees(column, r) && grid.sees(beside, r); --r, ++rows) {
    const double from = grid.u_px(column, r);
    const double width = grid.u_px(beside, r) - from;
    const auto at = [&](int step) {
      const double u = from + width * ((step - 0.5) * 2.0 / kEdgeSteps - kMiddle);
      return grid.pixel(std::clamp(static_cast<int>(std::lround(u)), 0, grid.width_px() - 1), r);
    };
    const std::uint8_t* before = at(0);
    for (int step = 0; step < kEdgeSteps; ++step) {
      const std::uint8_t* now = at(step + 1);
      for (std::size_t c = 0; c < 3; ++c) change[static_cast<std::size_t>(step)][c] += now[c] - before[c];
      before = now;
    }
  }
  if (rows == 0) return kMiddle;
  std::array<int, kEdgeSteps> size{};
  std::size_t best = 0;
  for (std::size_t i = 0; i < kEdgeSteps; ++i) {
    size[i] = std::abs(change[i][0]) + std::abs(change[i][1]) + std::abs(change[i][2]);
    if (size[i] > size[best]) best = i;
  }
  if (size[best] < kFaint * rows) return kMiddle;
  double sum = 0;
  double weight = 0;
  for (std::size_t i = best > 1 ? best - 2 : 0; i <= std::min<std::size_t>(best + 2, kEdgeSteps - 1); ++i) {
    sum += static_cast<double>(size[i]) * static_cast<double>(i);
    weight += size[i];
  }
  return std::clamp(sum / weight * 2.0 / kEdgeSteps - kMiddle, -kOutside, 1 + kOutside);
}

}  // namespace mirada::vision
