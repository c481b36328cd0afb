#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

namespace mirada::world {

/// A colour sum on its way: four 16-bit lanes (B, R, G, A from the low end), each channel times 256.
using Lanes = std::uint64_t;

inline Lanes spread(std::uint32_t bgra) {
  return (bgra & 0x00FF00FFu) | (static_cast<Lanes>(bgra & 0xFF00FF00u) << 24);
}

/// The pixel of a sum whose channels are times 256.
inline std::uint32_t packed(Lanes sum) {
  const Lanes y = sum >> 8;
  return static_cast<std::uint32_t>((y & 0x00FF00FFu) | ((y >> 24) & 0xFF00FF00u));
}

/// Scales every channel by share/256 (0..256).
inline std::uint32_t scaled(std::uint32_t bgra, std::uint32_t share) { return packed(spread(bgra) * share); }

/// A picture with its halvings, filtered bilinearly. Read-only after it was made; edges are clamped.
class Texture {
 public:
  explicit Texture(const cv::Mat& bgr8);

  struct Level {
    std::vector<std::uint32_t> texels;  ///< BGRA in memory, rows of stride, last row and column doubled
    int stride = 0;
    float scale_x = 1, scale_y = 1;  ///< from texels of level 0
    float most_x = 0, most_y = 0;    ///< largest coordinate, in sixteenths of a texel
  };

  /// The level whose texels are about as wide as a footprint, given squared in texels of level 0; `dither` in
  /// [0, 2^23) blends levels over pixels. A float's bits are nearly its logarithm, which spares computing
  /// one.
  const Level& level(float footprint2, std::uint32_t dither) const {
    const int bits = std::bit_cast<std::int32_t>(footprint2) - (127 << 23) + static_cast<int>(dither << 1);
    return levels_[static_cast<std::size_t>(std::clamp(bits >> 24, 0, static_cast<int>(levels_.size()) - 1))];
  }

  /// The colour at x, y in texels of level 0, whose first texel's middle is at 0.5, 0.5.
  static Lanes sample(const Level& level, float x, float y) {
    const float xs = std::clamp(x * level.scale_x * 16 - 8, 0.0F, level.most_x);
    const float ys = std::clamp(y * level.scale_y * 16 - 8, 0.0F, level.most_y);
    const int xi = static_cast<int>(xs);
    const int yi = static_cast<int>(ys);
    const std::uint32_t* at = level.texels.data() + (yi >> 4) * level.stride + (xi >> 4);
    const auto fx = static_cast<Lanes>(xi & 15);
    const auto fy = static_cast<Lanes>(yi & 15);
    const std::uint32_t* below = at + level.stride;
    return spread(at[0]) * ((16 - fx) * (16 - fy)) + spread(at[1]) * (fx * (16 - fy)) +
           spread(below[0]) * ((16 - fx) * fy) + spread(below[1]) * (fx * fy);
  }

  float width() const { return width_; }
  float height() const { return height_; }

 private:
  std::vector<Level> levels_;
  float width_ = 0, height_ = 0;
};

}  // namespace mirada::world
