#include "vision/exposure_watch.h"

#include <cstdlib>
#include <utility>

namespace mirada::vision {
namespace {

constexpr int kSameExposure = 6;  // Look units: the floor's own light varies as much
constexpr int kMostChange = 75;   // a factor of three
constexpr int kLittle = 16;       // a thing that differs so little is hardly seen anyway
constexpr int kSameHue = 8;
constexpr int kEnoughAbove = 40;  // cells

/// What stands above the horizon does not change when something comes into the robot's way.
std::optional<int> light_above(const PictureGrid& grid, const std::vector<ColumnSpan>& spans) {
  int sum = 0;
  int cells = 0;
  for (std::size_t i = 1; i < spans.size(); i += 4) {
    for (int row = spans[i].top_row; row < spans[i].horizon_row; row += 4, ++cells)
      sum += grid.look(static_cast<int>(i), row).light;
  }
  if (cells < kEnoughAbove) return std::nullopt;
  return sum / cells;
}

}  // namespace

void ExposureWatch::forget() {
  light_ = before_ = 0;
  above_.reset();
}

void ExposureWatch::see(const PictureGrid& grid, const std::vector<ColumnSpan>& spans,
                        const FloorLooks& looks, const Look& home, const Look& main, bool same_view) {
  before_ = light_;
  const auto above_before = std::exchange(above_, light_above(grid, spans));
  const int now = main.light - home.light;
  const int change = now - light_;
  if (std::abs(change) <= kSameExposure || std::abs(now) > kMostChange) return;
  if (std::abs(main.red - home.red) > kSameHue || std::abs(main.blue - home.blue) > kSameHue) return;
  if (same_view && above_before && above_ && 2 * (*above_ - *above_before) * change < change * change) return;
  int cells = 0;
  int as_before = 0;
  int as_now = 0;
  for (std::size_t i = 1; i < spans.size(); i += 4) {
    for (int row = spans[i].bottom_row; row > spans[i].horizon_row; row -= 8, ++cells) {
      const Look look = grid.look(static_cast<int>(i), row);
      as_before += looks.knows({look.light - light_, look.red, look.blue});
      as_now += looks.knows({look.light - now, look.red, look.blue});
    }
  }
  // Where the floor is still seen as it was, the light is the same, and something stands in the way.
  const bool better = std::abs(change) <= kLittle ? 3 * as_before <= 2 * as_now : 3 * as_before <= as_now;
  if (better && 2 * as_now >= cells) light_ = now;
}

}  // namespace mirada::vision
