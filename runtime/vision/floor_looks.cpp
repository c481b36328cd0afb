#include "vision/floor_looks.h"

namespace mirada::vision {

void FloorLooks::clear() { std::fill(cells_.begin(), cells_.end(), std::uint8_t{0}); }

void FloorLooks::add(const Look& look, int weight) {
  const int light = light_bin(look.light);
  const int red = colour_bin(look.red);
  const int blue = colour_bin(look.blue);
  for (int l = std::max(0, light - 1); l <= std::min(kSide - 1, light + 1); ++l) {
    for (int dr = -1; dr <= 1; ++dr) {
      for (int db = -1; db <= 1; ++db) {
        std::uint8_t& value = cells_[cell(l, (red + dr) & (kSide - 1), (blue + db) & (kSide - 1))];
        value = static_cast<std::uint8_t>(std::min(255, value + weight));
      }
    }
  }
}

void FloorLooks::fade() {
  for (std::uint8_t& value : cells_) value = static_cast<std::uint8_t>(value - (value >> 3));
}

}  // namespace mirada::vision
