#include "vision/floor_looks.h"

namespace mirada::vision {

void FloorLooks::clear() {
  cells_.fill(0);
  empty_ = true;
}

void FloorLooks::add(const Look& look, int weight) {
  empty_ = false;
  const int light = light_bin(look.light);
  const int red = colour_bin(look.red);
  const int blue = colour_bin(look.blue);
  const auto raise = [&](int l, int r, int b, int by) {
    if (l < 0 || l >= kSide || r < 0 || r >= kSide || b < 0 || b >= kSide) return;
    std::uint8_t& value = cells_[cell(l, r, b)];
    value = static_cast<std::uint8_t>(std::min(255, value + by));
  };
  for (int dr = -1; dr <= 1; ++dr) {
    for (int db = -1; db <= 1; ++db)
      raise(light, red + dr, blue + db, dr == 0 && db == 0 ? weight : weight / 2);
  }
  raise(light - 1, red, blue, weight / 2);
  raise(light + 1, red, blue, weight / 2);
}

void FloorLooks::fade() {
  for (std::uint8_t& value : cells_) value = static_cast<std::uint8_t>(value - (value >> 3));
}

}  // namespace mirada::vision
