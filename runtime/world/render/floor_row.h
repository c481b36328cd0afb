#pragma once
#include <cstdint>

#include "world/render/lanes.h"
#include "world/render/scene_view.h"

namespace mirada::world {

/// Eight neighbouring pixels of floor at once: where they lie on the floor's texture, in sixteenths of a
/// texel, and which level to take there.
class FloorRow {
 public:
  static constexpr int kPixels = 8;

  /// What is the same for the whole picture.
  struct Scene {
    explicit Scene(const SceneView& view)
        : r(view.rotation),
          map(&view.stage->textures[view.stage->floor_texture]),
          min_x_m(view.stage->floor_min_x_m),
          max_y_m(view.stage->floor_max_y_m),
          per_16(view.stage->floor_texels_per_m * 16),
          u0((view.at_m.x() - min_x_m) * per_16),
          v0((max_y_m - view.at_m.y()) * per_16),
          height(view.at_m.z()),
          deep(view.pixel_y * per_16),
          wide(view.pixel_x * per_16),
          u_high((map->width() - 65) * 16),
          v_high((map->height() - 65) * 16),
          columns(static_cast<int>(map->width())) {}
    /// Which places of the W frame lie well on the floor's texture.
    MIRADA_LANES Ints covers(Floats x_m, Floats y_m) const {
      const Floats u = (x_m - min_x_m) * per_16;
      const Floats v = (max_y_m - y_m) * per_16;
      return (u > kEdge_16) & (v > kEdge_16) & (u < u_high) & (v < v_high);
    }
    static constexpr float kEdge_16 = 16 * 64;  // filtering may reach as far from a pixel's middle
    Eigen::Matrix3f r;
    const Texture* map;
    float min_x_m, max_y_m, per_16, u0, v0, height, deep, wide, u_high, v_high;
    int columns;
  };

  /// Rays (x, y, 1) of the eight; the pixel is filtered by `taps` places along the view, so it counts that
  /// much shorter.
  MIRADA_LANES void aim(const Scene& s, const float* rx, const float* ry, int taps,
                        const std::uint32_t* dither) {
    const auto x = load_lanes<Floats>(rx);
    const auto y = load_lanes<Floats>(ry);
    const Floats dx = s.r(0, 0) * x + s.r(0, 1) * y + s.r(0, 2);
    const Floats dy = s.r(1, 0) * x + s.r(1, 1) * y + s.r(1, 2);
    const Floats dz = s.r(2, 0) * x + s.r(2, 1) * y + s.r(2, 2);
    const Floats per_drop = -1 / dz;
    const Floats t = s.height * per_drop;
    u_ = s.u0 + t * dx * s.per_16;
    v_ = s.v0 - t * dy * s.per_16;
    // How the place moves a pixel further down.
    const Floats drop = s.r(2, 1) * per_drop;
    const Floats k = t * s.deep;
    du_ = k * (s.r(0, 1) + dx * drop);
    dv_ = k * (-s.r(1, 1) - dy * drop);
    const float share = 1 / static_cast<float>(taps);
    const Floats across = t * s.wide;
    const Floats along2 = (du_ * du_ + dv_ * dv_) * (share * share);
    choose_level(s, most(along2, across * across), load_lanes<Ints>(dither));
  }

  /// The colours at the places that lie `offset` (-0.5 to 0.5) of a pixel further down the picture: four
  /// pixels' channels, times 256, each.
  MIRADA_LANES void look(const Scene& s, float offset, Words& left, Words& right) const {
    const Floats low = all_lanes(Scene::kEdge_16);  // far off a pixel may reach past the floor's map
    const Floats u = least(most(u_ + offset * du_, low), all_lanes(s.u_high));
    const Floats v = least(most(v_ + offset * dv_, low), all_lanes(s.v_high));
    const Ints x = (__builtin_convertvector(u, Ints) >> level_) - 8;
    const Ints y = (__builtin_convertvector(v, Ints) >> level_) - 8;
    const Ints upper = begin_ + (y >> 4) * stride_ + (x >> 4);
    const Ints lower = upper + stride_;
    // Each weight twice in a lane, as two words.
    const Ints down = (y & 15) * 0x10001;
    const Ints to_right = (x & 15) * 0x10001;
    const Ints to_left = 0x100010 - to_right;
    const std::uint32_t* texels = s.map->texels();
    left = Texture::added(two<0, 2>(texels, upper, lower, down, to_left, to_right),
                          two<1, 3>(texels, upper, lower, down, to_left, to_right));
    right = Texture::added(two<4, 6>(texels, upper, lower, down, to_left, to_right),
                           two<5, 7>(texels, upper, lower, down, to_left, to_right));
  }

 private:
  /// As Texture::level, for a squared footprint in sixteenths of a texel.
  MIRADA_LANES void choose_level(const Scene& s, Floats footprint2, Ints dither) {
    const Ints bits = std::bit_cast<Ints>(footprint2) - ((127 + 8) << 23);
    level_ = least(most((bits + (dither << 1)) >> 24, all_lanes(0)), all_lanes(Texture::kHalved));
    stride_ = (all_lanes(s.columns) >> level_) + 1;
    begin_ = looked_up(s.map->halvings(), level_);
  }

  template <int a, int b>
  MIRADA_LANES static Words two(const std::uint32_t* texels, Ints upper, Ints lower, Ints down, Ints to_left,
                                Ints to_right) {
    return Texture::weighed(widened(Texture::two(texels + upper[a]), Texture::two(texels + upper[b])),
                            widened(Texture::two(texels + lower[a]), Texture::two(texels + lower[b])),
                            std::bit_cast<Words>(__builtin_shufflevector(down, down, a, a, a, a, b, b, b, b)),
                            std::bit_cast<Words>(__builtin_shufflevector(to_left, to_right, a, a, a + 8,
                                                                         a + 8, b, b, b + 8, b + 8)));
  }

  Floats u_, v_, du_, dv_;
  Ints level_, stride_, begin_;
};

}  // namespace mirada::world
