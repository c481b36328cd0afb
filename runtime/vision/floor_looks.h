#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "vision/picture_grid.h"

namespace mirada::vision {

/// The looks that the floor has been seen to have: a soft three-dimensional histogram with forgetting.
/// Several looks live side by side (tiles, planks, a floor in sun and in shade). 256 kB, allocated once.
class FloorLooks {
 public:
  void clear();
  /// Adds one sighting of the floor; neighbouring looks get a share.
  void add(const Look& look, int weight);
  /// Takes an eighth of what is remembered; looks that are not seen again fade.
  void fade();
  bool knows(const Look& look) const { return cells_[cell(look)] >= kKnown; }

 private:
  static constexpr int kSide = 64;
  static constexpr int kKnown = 60;

  static int light_bin(int light) { return std::clamp(light >> 2, 0, kSide - 1); }
  /// Ratios repeat after 128 units (a factor of 7): two so different looks in one picture's floor do not
  /// matter.
  static int colour_bin(int ratio) { return (ratio >> 1) & (kSide - 1); }
  static std::size_t cell(int light, int red, int blue) {
    return (static_cast<std::size_t>(light) * kSide + static_cast<std::size_t>(red)) * kSide +
           static_cast<std::size_t>(blue);
  }
  static std::size_t cell(const Look& look) {
    return cell(light_bin(look.light), colour_bin(look.red), colour_bin(look.blue));
  }

  std::vector<std::uint8_t> cells_ = std::vector<std::uint8_t>(kSide * kSide * kSide);
};

}  // namespace mirada::vision
