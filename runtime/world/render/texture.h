#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/core/hal/intrin.hpp>

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

  /// The colour at x, y in sixteenths of a texel of level 0, from a level up to kHalved; at least one of that
  /// level's texels inside the edges.
  Lanes sample_halved(int index, int x16, int y16) const {
    return at_sixteenths(levels_[static_cast<std::size_t>(index)], (x16 >> index) - 8, (y16 >> index) - 8);
  }

  float width() const { return width_; }
  float height() const { return height_; }

 private:
  /// Weights by sixteenths: below[f] is f in every lane, beside[f] the left texel's four lanes and the right
  /// one's.
  struct Weights {
    std::uint16_t below[17][8];
    std::uint16_t beside[16][8];
  };
  static constexpr Weights make_weights() {
    Weights out{};
    for (int f = 0; f <= 16; ++f) {
      for (int lane = 0; lane < 8; ++lane) {
        out.below[f][lane] = static_cast<std::uint16_t>(f);
        if (f < 16) out.beside[f][lane] = static_cast<std::uint16_t>(lane < 4 ? 16 - f : f);
      }
    }
    return out;
  }
  static const Weights kWeights;

  /// Two texels side by side are eight lanes; first the rows are blended, then the columns.
  static Lanes at_sixteenths(const Level& level, int xi, int yi) {
    const std::uint32_t* above = level.texels + (yi >> 4) * level.stride + (xi >> 4);
    const cv::v_uint16x8 upper = cv::v_load_expand(reinterpret_cast<const std::uint8_t*>(above));
    const cv::v_uint16x8 lower =
        cv::v_load_expand(reinterpret_cast<const std::uint8_t*>(above + level.stride));
    const int fy = yi & 15;
    const cv::v_uint16x8 rows = cv::v_add_wrap(cv::v_mul_wrap(upper, cv::v_load(kWeights.below[16 - fy])),
                                               cv::v_mul_wrap(lower, cv::v_load(kWeights.below[fy])));
    const cv::v_uint16x8 both = cv::v_mul_wrap(rows, cv::v_load(kWeights.beside[xi & 15]));
    return cv::v_reinterpret_as_u64(cv::v_add_wrap(both, cv::v_rotate_right<4>(both))).get0();
  }

  std::vector<Level> levels_;
  float width_ = 0, height_ = 0;
};

inline constexpr Texture::Weights Texture::kWeights = Texture::make_weights();

}  // namespace mirada::world
