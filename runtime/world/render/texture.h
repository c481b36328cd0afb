#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
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
    cv::Mat memory;                         ///< CV_8UC4; last row and column doubled
    const std::uint32_t* texels = nullptr;  ///< BGRA in memory, rows of stride
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
    const float xs = x * level.scale_x - 8;
    const float ys = y * level.scale_y - 8;
    return at_sixteenths(level, static_cast<int>(std::min(std::max(xs, 0.0F), level.most_x)),
                         static_cast<int>(std::min(std::max(ys, 0.0F), level.most_y)));
  }

  /// Levels up to this one are exact halvings, for a size that is a multiple of 64.
  static constexpr int kHalved = 6;

  /// The number of the level for a squared footprint, 0 to kHalved; as level().
  static int halved_level(float footprint2, std::uint32_t dither) {
    const int bits = std::bit_cast<std::int32_t>(footprint2) - (127 << 23) + static_cast<int>(dither << 1);
    const int index = bits >> 24;
    const int least = index > 0 ? index : 0;
    return least < kHalved ? least : kHalved;
  }

  /// The colour at x, y in sixteenths of a texel of level 0, from a level up to kHalved; at least one of that
  /// level's texels inside the edges.
  Lanes sample_halved(int index, int x16, int y16) const {
    return at_sixteenths(levels_[static_cast<std::size_t>(index)], (x16 >> index) - 8, (y16 >> index) - 8);
  }

  float width() const { return width_; }
  float height() const { return height_; }

 private:
  /// Two texels side by side are one word: its even and its odd bytes are blended as lanes, first the rows,
  /// then the columns.
  static Lanes at_sixteenths(const Level& level, int xi, int yi) {
    constexpr Lanes kEven = 0x00FF00FF00FF00FFULL;
    const std::uint32_t* above = level.texels + (yi >> 4) * level.stride + (xi >> 4);
    Lanes a, b;
    std::memcpy(&a, above, sizeof a);
    std::memcpy(&b, above + level.stride, sizeof b);
    const auto fx = static_cast<std::uint32_t>(xi & 15);
    const auto fy = static_cast<Lanes>(yi & 15);
    const Lanes even = (a & kEven) * (16 - fy) + (b & kEven) * fy;
    const Lanes odd = ((a >> 8) & kEven) * (16 - fy) + ((b >> 8) & kEven) * fy;
    const std::uint32_t low =
        static_cast<std::uint32_t>(even) * (16 - fx) + static_cast<std::uint32_t>(even >> 32) * fx;
    const std::uint32_t high =
        static_cast<std::uint32_t>(odd) * (16 - fx) + static_cast<std::uint32_t>(odd >> 32) * fx;
    return low | (static_cast<Lanes>(high) << 32);
  }

  std::vector<Level> levels_;
  float width_ = 0, height_ = 0;
};

}  // namespace mirada::world
