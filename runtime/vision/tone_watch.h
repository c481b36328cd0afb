#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>

#include "vision/look_follower.h"
#include "vision/picture_grid.h"

namespace mirada::vision {

/// The colours that the floor's smoothed look has been seen to have, whatever its light: noise is gone from
/// them, so that they tell things apart which single cells do not.
class FloorTones {
 public:
  void clear() { cells_.fill(0); }
  void add(const Look& mean, int weight) {
    for (int dr = -1; dr <= 1; ++dr)
      for (int db = -1; db <= 1; ++db) {
        std::uint8_t& value = cells_[cell(mean.red + 2 * dr, mean.blue + 2 * db)];
        value = static_cast<std::uint8_t>(std::min(255, value + weight));
      }
  }
  void fade() {
    for (std::uint8_t& value : cells_) value = static_cast<std::uint8_t>(value - (value >> 3));
  }
  bool knows(const Look& mean) const { return cells_[cell(mean.red, mean.blue)] >= kKnown; }

 private:
  static constexpr int kSide = 128;
  static constexpr int kKnown = 24;
  static std::size_t cell(int red, int blue) {
    return static_cast<std::size_t>((red >> 1) & (kSide - 1)) * kSide +
           static_cast<std::size_t>((blue >> 1) & (kSide - 1));
  }
  std::array<std::uint8_t, static_cast<std::size_t>(kSide* kSide)> cells_{};
};

/// Notices on the way up a column that the colour has changed for good, by less than a single cell's noise.
class ToneWatch {
 public:
  void start(const Look& look) {
    slow_.start(look);
    fast_.start(look);
    late_.start(look);
    begin_ = -1;
  }
  /// The row where another colour began, or -1 while there is none.
  int see(const Look& look, int row, int tolerance) {
    fast_.follow(look, kFast);
    late_.follow(look, kLate);
    const Look fast = fast_.look();
    const Look slow = slow_.look();
    if (std::max(std::abs(fast.red - slow.red), std::abs(fast.blue - slow.blue)) <= tolerance) {
      begin_ = -1;
      slow_.follow(look, kSlow);
      return -1;
    }
    if (begin_ < 0) begin_ = row + kLag;
    return begin_;
  }
  Look mean() const { return fast_.look(); }
  /// Not on the way from one colour to the next.
  bool is_settled() const {
    const Look fast = fast_.look();
    const Look late = late_.look();
    return std::max(std::abs(fast.red - late.red), std::abs(fast.blue - late.blue)) <= kSettled;
  }

 private:
  static constexpr int kFast = 4;
  static constexpr int kLate = 8;
  static constexpr int kSlow = 32;
  static constexpr int kSettled = 3;
  static constexpr int kLag = 3;  // rows until a change is noticed
  LookFollower slow_;
  LookFollower fast_;
  LookFollower late_;
  int begin_ = -1;
};

}  // namespace mirada::vision
