#pragma once
#include <array>
#include <cstdint>

#include <opencv2/core.hpp>
#include <opencv2/core/hal/intrin.hpp>

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
          per_16(view.stage->floor_texels_per_m * 16),
          u0((view.at_m.x() - view.stage->floor_min_x_m) * per_16),
          v0((view.stage->floor_max_y_m - view.at_m.y()) * per_16),
          height(view.at_m.z()),
          deep(view.pixel_y * per_16),
          wide(view.pixel_x * per_16) {
      const Texture& map = view.stage->textures[view.stage->floor_texture];
      u_high = (map.width() - 65) * 16;
      v_high = (map.height() - 65) * 16;
    }
    Eigen::Matrix3f r;
    float per_16, u0, v0, height, deep, wide, u_high, v_high;
  };

  /// Rays (x, y, 1) of the eight; the pixel is filtered by `taps` places along the view, so it counts that
  /// much shorter.
  void aim(const Scene& s, const float* rx, const float* ry, int taps, const std::uint32_t* dither) {
    for (int x = 0; x < kPixels; x += 4) aim_four(s, rx + x, ry + x, taps, dither + x, x);
  }

  /// The places that lie `offset` (-0.5 to 0.5) of a pixel further down the picture.
  void tap(const Scene& s, float offset) {
    const cv::v_float32x4 low = cv::v_setall_f32(16 * 64);  // far off a pixel may reach past the floor's map
    const cv::v_float32x4 by = cv::v_setall_f32(offset);
    for (int x = 0; x < kPixels; x += 4) {
      const cv::v_float32x4 u = cv::v_load(&u_[x]) + by * cv::v_load(&du_[x]);
      const cv::v_float32x4 v = cv::v_load(&v_[x]) + by * cv::v_load(&dv_[x]);
      cv::v_store(&u16[x], cv::v_trunc(cv::v_min(cv::v_max(u, low), cv::v_setall_f32(s.u_high))));
      cv::v_store(&v16[x], cv::v_trunc(cv::v_min(cv::v_max(v, low), cv::v_setall_f32(s.v_high))));
    }
  }

  int u16[kPixels], v16[kPixels], level[kPixels];

 private:
  void aim_four(const Scene& s, const float* rx, const float* ry, int taps, const std::uint32_t* dither,
                int at) {
    const auto all = [](float value) { return cv::v_setall_f32(value); };
    const cv::v_float32x4 x = cv::v_load(rx);
    const cv::v_float32x4 y = cv::v_load(ry);
    const cv::v_float32x4 dx = all(s.r(0, 0)) * x + all(s.r(0, 1)) * y + all(s.r(0, 2));
    const cv::v_float32x4 dy = all(s.r(1, 0)) * x + all(s.r(1, 1)) * y + all(s.r(1, 2));
    const cv::v_float32x4 dz = all(s.r(2, 0)) * x + all(s.r(2, 1)) * y + all(s.r(2, 2));
    const cv::v_float32x4 per_drop = all(-1) / dz;
    const cv::v_float32x4 t = all(s.height) * per_drop;
    cv::v_store(&u_[at], all(s.u0) + t * dx * all(s.per_16));
    cv::v_store(&v_[at], all(s.v0) - t * dy * all(s.per_16));
    // How the place moves a pixel further down.
    const cv::v_float32x4 drop = all(s.r(2, 1)) * per_drop;
    const cv::v_float32x4 k = t * all(s.deep);
    const cv::v_float32x4 du = k * (all(s.r(0, 1)) + dx * drop);
    const cv::v_float32x4 dv = k * (all(-s.r(1, 1)) - dy * drop);
    cv::v_store(&du_[at], du);
    cv::v_store(&dv_[at], dv);
    const float share = 1 / static_cast<float>(taps);
    const cv::v_float32x4 across = t * all(s.wide);
    const cv::v_float32x4 along2 = (du * du + dv * dv) * all(share * share);
    choose_level(cv::v_max(along2, across * across), dither, at);
  }

  /// As Texture::level, for a squared footprint in sixteenths of a texel.
  void choose_level(const cv::v_float32x4& footprint2, const std::uint32_t* dither, int at) {
    const cv::v_int32x4 bits = cv::v_reinterpret_as_s32(footprint2) - cv::v_setall_s32((127 + 8) << 23);
    const cv::v_int32x4 dithered = bits + cv::v_reinterpret_as_s32(cv::v_load(dither) << 1);
    const cv::v_int32x4 index = dithered >> 24;
    cv::v_store(&level[at],
                cv::v_min(cv::v_max(index, cv::v_setall_s32(0)), cv::v_setall_s32(Texture::kHalved)));
  }

  float u_[kPixels], v_[kPixels], du_[kPixels], dv_[kPixels];
};

}  // namespace mirada::world
