#include "vision/floor_lights.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace mirada::vision {
namespace {

constexpr int kSameLight = 12;        // Look units
constexpr int kColourReach = 20;      // farther apart, no noise makes it one colour
constexpr double kSameColour = 0.07;  // by which the channels' factors may differ
constexpr double kColourNoise = 1.5;  // of 255
constexpr int kMostChange = 75;       // a factor of three

/// A gloss puts white into a clear colour: what is left of it points the same way.
bool is_glossy(const Look& a, const Look& b) {
  constexpr int kClear = 15;
  constexpr int kAside = 3;
  const double ar = a.red - 128, ab = a.blue - 128, br = b.red - 128, bb = b.blue - 128;
  const double one = std::hypot(ar, ab);
  const double other = std::hypot(br, bb);
  const double shared = ar * br + ab * bb;
  return std::min(one, other) > kClear && shared > 0 &&
         std::abs(ar * bb - ab * br) < kAside * std::max(one, other);
}

/// All three channels differ by the same factor.
bool same_colour(const Look& a, const Look& b) {
  if (is_glossy(a, b)) return true;
  if (std::abs(a.red - b.red) > kColourReach || std::abs(a.blue - b.blue) > kColourReach) return false;
  const Eigen::Array3d one = PictureGrid::colour_of(a).array().max(1);
  const Eigen::Array3d other = PictureGrid::colour_of(b).array().max(1);
  const Eigen::Array3d factor = one / other;
  const double darkest = std::min(one.minCoeff(), other.minCoeff());
  return factor.maxCoeff() <= factor.minCoeff() * (1 + kSameColour + kColourNoise / darkest);
}

bool is_same_light(const Look& a, const Look& b) {
  return std::abs(a.light - b.light) <= kSameLight && same_colour(a, b);
}

int mixed(int before, int now) { return (3 * before + now) / 4; }

}  // namespace

void FloorLights::start(const Look& look) {
  lights_[0] = look;
  count_ = 1;
}

Look* FloorLights::nearest(const Look& look) {
  Look* best = nullptr;
  for (std::size_t i = 0; i < count_; ++i) {
    Look& light = lights_[i];
    if (!is_same_light(light, look)) continue;
    if (!best || std::abs(light.light - look.light) < std::abs(best->light - look.light)) best = &light;
  }
  return best;
}

void FloorLights::see(const Look& look) {
  if (count_ == 0) return;
  if (Look* light = nearest(look)) {
    *light = {mixed(light->light, look.light), mixed(light->red, look.red), mixed(light->blue, look.blue)};
    return;
  }
  const Look& first = lights_[0];
  if (!same_colour(first, look) || std::abs(first.light - look.light) > kMostChange) return;
  if (count_ == kMost) --count_;
  lights_[count_++] = look;
}

std::optional<Look> FloorLights::of(const Look& look) const {
  for (std::size_t i = 0; i < count_; ++i)
    if (is_same_light(lights_[i], look)) return lights_[i];
  return std::nullopt;
}

bool FloorLights::is_change(const Look& from, const Look& to) const {
  const auto a = of(from);
  const auto b = of(to);
  return a && b && a->light != b->light;
}

int FloorLights::brightest() const {
  int out = 0;
  for (std::size_t i = 0; i < count_; ++i) out = std::max(out, lights_[i].light);
  return out;
}

}  // namespace mirada::vision
