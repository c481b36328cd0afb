#pragma once
#include <algorithm>
#include <cstdlib>

#include "vision/picture_grid.h"

namespace mirada::vision {

/// How much the floor's look wanders from one place to the next, in Look units (1 sigma); learnt from the
/// picture.
struct FloorTexture {
  double light_sigma = 3;
  double colour_sigma = 2;
};

/// How far a look may lie from the one followed and still be the same thing, in Look units.
struct Tolerance {
  int light = 10;
  int colour = 6;
};

/// A look that drifts along a column with the light, in sixteenths.
class LookFollower {
 public:
  void start(const Look& look) {
    light_ = 16 * look.light;
    red_ = 16 * look.red;
    blue_ = 16 * look.blue;
  }
  void follow(const Look& look, int slowness) {
    light_ += (16 * look.light - light_) / slowness;
    red_ += (16 * look.red - red_) / slowness;
    blue_ += (16 * look.blue - blue_) / slowness;
  }
  /// 0: the same within the tolerance; 1: off; 2: more than twice the tolerance off.
  int oddness(const Look& look, const Tolerance& tolerance) const {
    const int light = std::abs(16 * look.light - light_);
    const int colour = std::max(std::abs(16 * look.red - red_), std::abs(16 * look.blue - blue_));
    if (light <= 16 * tolerance.light && colour <= 16 * tolerance.colour) return 0;
    return light > 32 * tolerance.light || colour > 32 * tolerance.colour ? 2 : 1;
  }
  Look look() const { return {light_ / 16, red_ / 16, blue_ / 16}; }

 private:
  int light_ = 0;
  int red_ = 0;
  int blue_ = 0;
};

}  // namespace mirada::vision
