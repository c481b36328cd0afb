#include "vision/fixed_colour.h"

#include <algorithm>

namespace mirada::vision {
namespace {

std::array<double, 3> hsv(const std::array<int, 3>& bgr) {
  const auto [b, g, r] = bgr;
  const int high = std::max({b, g, r});
  const int spread = high - std::min({b, g, r});
  if (spread == 0) return {0, 0, static_cast<double>(high)};
  double hue = high == r   ? 30.0 * (g - b) / spread
               : high == g ? 60 + 30.0 * (b - r) / spread
                           : 120 + 30.0 * (r - g) / spread;
  if (hue < 0) hue += 180;
  return {hue, 255.0 * spread / high, static_cast<double>(high)};
}

}  // namespace

ColumnResult scan_fixed_colour(const PictureGrid& grid, int column, const ColumnSpan& span,
                               const SonarSettings& settings) {
  if (span.bottom_row < 0) return {};
  if (span.horizon_row >= span.bottom_row) return {.end = ColumnResult::End::above_horizon};
  for (int row = span.bottom_row; row > span.horizon_row && row >= span.top_row; --row) {
    const auto value = hsv(grid.colour(column, row));
    bool inside = true;
    for (std::size_t i = 0; i < 3; ++i)
      inside = inside && value[i] >= settings.hsv_min[i] && value[i] <= settings.hsv_max[i];
    if (!inside) continue;
    const auto end =
        row == span.bottom_row ? ColumnResult::End::not_floor_below : ColumnResult::End::boundary;
    return {.end = end, .row = row + 0.5, .sigma_row = 0.5};
  }
  return {.end = ColumnResult::End::floor_to_top, .row = std::max(span.horizon_row, span.top_row - 1) + 0.5};
}

}  // namespace mirada::vision
