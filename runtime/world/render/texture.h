#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

#include "world/render/lanes.h"

namespace mirada::world {

/// A colour sum on its way: four 16-bit lanes (B, G, R, A from the low end), each channel times 256.
using Lanes = std::uint64_t;
constexpr Lanes kLaneBytes = 0x00FF00FF00FF00FFULL;

inline Lanes spread(std::uint32_t bgra) {
  Lanes out = bgra;
  out = (out | (out << 16)) & 0x0000FFFF0000FFFFULL;
  return (out | (out << 8)) & kLaneBytes;
}

/// The pixel of a sum whose channels are times 256.
inline std::uint32_t packed(Lanes sum) {
  Lanes out = (sum >> 8) & kLaneBytes;
  out = (out | (out >> 8)) & 0x0000FFFF0000FFFFULL;
  return static_cast<std::uint32_t>(out | (out >> 16));
}

/// Scales every channel by share/256 (0..256).
inline std::uint32_t scaled(std::uint32_t bgra, std::uint32_t share) { return packed(spread(bgra) * share); }

/// A picture with its halvings, filtered bilinearly. Read-only after it was made; edges are clamped.
class Texture {
 public:
  explicit Texture(const cv::Mat& bgr8);

  struct Level {
    const std::uint32_t* texels = nullptr;  ///< BGRA, rows of stride; the last row and column stand twice
    int stride = 0;
    float scale_x = 16, scale_y = 16;  ///< from texels of level 0 to sixteenths of this level's
    float most_x = 0, most_y = 0;      ///< largest coordinate, in sixteenths of a texel
  };

  /// The level whose texels are about as wide as a footprint, given squared in texels of level 0; `dither` in
  /// [0, 2^23) blends levels over pixels. A float's bits are nearly its logarithm, which spares computing
  /// one.
  const Level& level(float footprint2, std::uint32_t dither) const {
    const int bits = std::bit_cast<std::int32_t>(footprint2) - (127 << 23) + static_cast<int>(dither << 1);
    return levels_[static_cast<std::size_t>(std::clamp(bits >> 24, 0, static_cast<int>(levels_.size()) - 1))];
  }

  /// The colour at x, y in texels of level 0, whose first texel's middle is at 0.5, 0.5. Edges are clamped.
  static Lanes sample(const Level& level, float x, float y) {
    const Spot at = spot(level, x, y);
    const auto right = static_cast<Lanes>(at.right);
    const auto down = static_cast<Lanes>(at.down);
    // Downwards first: four lanes of a texel stay below 2^12, and below 2^16 when weighed sideways.
    const auto column = [&](std::ptrdiff_t beside) {
      return spread(at.above[beside]) * (16 - down) + spread(at.above[beside + at.stride]) * down;
    };
    return column(0) * (16 - right) + column(1) * right;
  }

  /// Where a pixel's colour is taken: the upper left of the four texels about it, its level's row length, and
  /// how far it lies between them, in sixteenths.
  struct Spot {
    const std::uint32_t* above;
    int stride;
    int right, down;
  };

  /// The spot at x, y in texels of level 0, as sample() takes it.
  static Spot spot(const Level& level, float x, float y) {
    const float xs = x * level.scale_x - 8;
    const float ys = y * level.scale_y - 8;
    return spot_at(level, static_cast<int>(std::min(std::max(xs, 0.0F), level.most_x)),
                   static_cast<int>(std::min(std::max(ys, 0.0F), level.most_y)));
  }

  /// Two texels side by side.
  static std::uint64_t two(const std::uint32_t* texels) {
    std::uint64_t out;
    std::memcpy(&out, texels, sizeof out);
    return out;
  }
  /// The left and the right texels of two pixels, blended downwards and weighed sideways, from what stands in
  /// the upper and lower rows and the weights in sixteenths.
  MIRADA_LANES static Words weighed(Words upper, Words lower, Words down, Words beside) {
    return ((upper << 4) + (lower - upper) * down) * beside;
  }
  /// Left and right added: the channels, times 256, of pixels 0 to 3, from what weighed() gives of 0 and 2
  /// and of 1 and 3.
  MIRADA_LANES static Words added(Words even, Words odd) {
    return __builtin_shufflevector(even, odd, 0, 1, 2, 3, 16, 17, 18, 19, 8, 9, 10, 11, 24, 25, 26, 27) +
           __builtin_shufflevector(even, odd, 4, 5, 6, 7, 20, 21, 22, 23, 12, 13, 14, 15, 28, 29, 30, 31);
  }

  /// Four spots' channels, each times 256.
  MIRADA_LANES static Words sample_four(const Spot* spots) {
    return added(of_two(spots[0], spots[2]), of_two(spots[1], spots[3]));
  }

  /// Levels up to this one are exact halvings, for a size that is a multiple of 64.
  static constexpr int kHalved = 6;
  /// The first texel of level 0; the other levels follow it.
  const std::uint32_t* texels() const { return levels_.front().texels; }
  /// Where the levels up to kHalved begin, counted from texels(); their rows are (width >> level) + 1 long.
  MIRADA_LANES Ints halvings() const { return load_lanes<Ints>(halvings_.data()); }

  float width() const { return width_; }
  float height() const { return height_; }

 private:
  /// Weights by sixteenths, a byte a channel: down[f] is f for both texels of a row; beside[f] the left
  /// texel's four channels and the right one's.
  struct Weights {
    std::array<std::uint64_t, 16> down;
    std::array<std::uint64_t, 16> beside;
  };
  static constexpr Weights make_weights() {
    Weights out{};
    for (std::uint64_t f = 0; f < 16; ++f) {
      out.down[f] = f * 0x0101010101010101ULL;
      out.beside[f] = (16 - f) * 0x01010101ULL | f * 0x0101010100000000ULL;
    }
    return out;
  }
  static const Weights kWeights;

  static Spot spot_at(const Level& level, int x16, int y16) {
    return {level.texels + static_cast<std::ptrdiff_t>(y16 >> 4) * level.stride + (x16 >> 4), level.stride,
            x16 & 15, y16 & 15};
  }

  MIRADA_LANES static Words of_two(const Spot& a, const Spot& b) {
    const auto weights = [](const std::array<std::uint64_t, 16>& of, int first, int second) {
      return widened(of[static_cast<std::size_t>(first)], of[static_cast<std::size_t>(second)]);
    };
    return weighed(widened(two(a.above), two(b.above)),
                   widened(two(a.above + a.stride), two(b.above + b.stride)),
                   weights(kWeights.down, a.down, b.down), weights(kWeights.beside, a.right, b.right));
  }

  cv::Mat memory_;  ///< CV_8UC4, one row: all levels
  std::vector<Level> levels_;
  std::array<std::int32_t, 8> halvings_{};
  float width_ = 0, height_ = 0;
};

inline constexpr Texture::Weights Texture::kWeights = Texture::make_weights();

}  // namespace mirada::world
