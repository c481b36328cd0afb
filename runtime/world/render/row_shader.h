#pragma once
#include <array>
#include <cstdint>
#include <numbers>

#include "world/render/floor_row.h"
#include "world/render/hit_row.h"

namespace mirada::world {

/// The colours of eight rays at once, as SceneView::colour gives them one by one.
class RowShader {
 public:
  static constexpr std::size_t kRays = 8;
  using Row = std::array<std::uint32_t, kRays>;

  struct Rays {
    const float* x;
    const float* y;
    const std::uint32_t* dither;
  };
  /// How floor is filtered along the view: a ray stands for one of `parts` of a pixel's length and is looked
  /// up at `looks` places.
  struct Filter {
    int parts, looks;
  };

  explicit RowShader(const SceneView& view) : view_(view), floor_(view) {}

  MIRADA_LANES Row floor(const Rays& rays, const Filter& filter) const {
    FloorRow line;
    line.aim(floor_, rays.x, rays.y, filter.parts, rays.dither);
    Words left, right;
    if (filter.looks == 1) {
      line.look(floor_, 0, left, right);
      return packed_row(left >> 8, right >> 8);
    }
    Words left_sum{}, right_sum{};
    const auto looks = static_cast<float>(filter.looks);
    for (int i = 0; i < filter.looks; ++i) {
      line.look(floor_, (static_cast<float>(i) + 0.5F) / looks - 0.5F, left, right);
      left_sum += left >> 8;
      right_sum += right >> 8;
    }
    const auto part = static_cast<std::uint16_t>(256 / filter.looks);
    return packed_row(left_sum * part >> 8, right_sum * part >> 8);
  }

  MIRADA_LANES Row quad(const Rays& rays, std::size_t item) const {
    const Quad& quad = view_.stage->quads[item];
    const QuadView& q = view_.quads[item];
    const Texture& texture = view_.stage->textures[quad.texture];
    const float per_u = texture.width() / quad.width_m;
    const float per_v = texture.height() / quad.height_m;
    const auto x = load_lanes<Floats>(rays.x);
    const auto y = load_lanes<Floats>(rays.y);
    const Floats facing = q.normal_C.x() * x + q.normal_C.y() * y + q.normal_C.z();
    const Floats t = q.plane / facing;
    const Floats u = (q.right0 + t * (q.right_C.x() * x + q.right_C.y() * y + q.right_C.z())) * per_u;
    const Floats v = (q.down0 + t * (q.down_C.x() * x + q.down_C.y() * y + q.down_C.z())) * per_v;
    const Floats across = t * (view_.pixel_x * per_u);
    const Floats stretch = -(1 + (x * x + y * y) / 2) / facing;
    const Floats footprint2 = across * across * least(stretch, all_lanes(9.0F));
    std::array<Texture::Spot, kRays> spots;
    for (int i = 0; i < int{kRays}; ++i) {
      spots[static_cast<std::size_t>(i)] =
          Texture::spot(texture.level(footprint2[i], rays.dither[i]), u[i], v[i]);
    }
    return sampled(spots);
  }

  /// The rays that are `wanted`, a bit each; what stands for the others is anything.
  MIRADA_LANES Row seen(const HitRow& hits, unsigned wanted, const Rays& rays, const Filter& filter) const {
    Row out{};
    while (wanted != 0) {
      const int first = std::countr_zero(wanted);
      const unsigned alike = hits.like(first) & wanted;
      wanted &= ~alike;
      const Row colours = of_one(hits, first, alike, rays, filter);
      for (std::size_t i = 0; i < kRays; ++i) {
        if ((alike >> i & 1) != 0) out[i] = colours[i];
      }
    }
    return out;
  }

 private:
  /// Of rays that meet the same.
  MIRADA_LANES Row of_one(const HitRow& hits, int first, unsigned alike, const Rays& rays,
                          const Filter& filter) const {
    const int id = hits.id(first);
    if (id == SceneView::kFloor && (hits.on_map(floor_) & alike) == alike) return floor(rays, filter);
    if (id >= SceneView::kFirstItem) {
      const auto item = static_cast<std::size_t>(id - SceneView::kFirstItem);
      return item < view_.quads.size() ? quad(rays, item) : round(hits, rays, item - view_.quads.size());
    }
    Row out{};
    for (; alike != 0; alike &= alike - 1) {
      const int i = std::countr_zero(alike);
      out[static_cast<std::size_t>(i)] = view_.colour(hits.hit(i), rays.x[i], rays.y[i], rays.dither[i]);
    }
    return out;
  }

  MIRADA_LANES Row round(const HitRow& hits, const Rays& rays, std::size_t index) const {
    const Round& round = view_.rounds[index];
    const auto [x, y, z] = hits.places(view_);
    const Floats px = x - round.x_m;
    const Floats py = y - round.y_m;
    const Floats front = px * round.ahead_x + py * round.ahead_y;
    const Floats left = py * round.ahead_x - px * round.ahead_y;
    const float girth = (round.head ? 2 : kTau) * round.reach_m;
    const Floats column = round.head ? left / girth + 0.5F : arc_tangent(-left, -front) / kTau + 0.5F;
    const Floats down = round.cap ? all_lanes(0.5F) : (round.high_m - z) / (round.high_m - round.low_m);
    std::array<Texture::Spot, kRays> spots;
    for (int i = 0; i < int{kRays}; ++i) {
      const Texture& texture =
          view_.stage->textures[round.head && front[i] < 0 ? round.back_texture : round.texture];
      const float across = hits.hit(i).t * view_.pixel_x * texture.width() / girth;
      spots[static_cast<std::size_t>(i)] =
          Texture::spot(texture.level(across * across * 1.3F, rays.dither[i]), column[i] * texture.width(),
                        down[i] * texture.height());
    }
    return lit(sampled(spots), brightness(round, px, py, z));
  }

  MIRADA_LANES Floats brightness(const Round& round, Floats px, Floats py, Floats z) const {
    const Lamp& lamp = view_.stage->lamp;
    if (round.cap) return all_lanes(lamp.on({0, 0, 1}));
    const Floats up = -round.b / 2 - round.c * z;
    const Floats along = px * lamp.towards.x() + py * lamp.towards.y() + up * lamp.towards.z();
    return lamp.facing(most(along / root(px * px + py * py + up * up), all_lanes(0.0F)));
  }

  MIRADA_LANES Row lit(Row painted, Floats bright) const {
    const Eigen::Vector3f& tint = view_.stage->lamp.tint_bgr;
    Row out{};
    for (std::size_t i = 0; i < kRays; ++i) {
      for (int k = 0; k < 3; ++k) {
        const auto channel = static_cast<float>((painted[i] >> (8 * k)) & 0xFF);
        const float value = channel * bright[static_cast<int>(i)] * tint[k];
        out[i] |= static_cast<std::uint32_t>(value < 255 ? value : 255.0F) << (8 * k);
      }
    }
    return out;
  }

  MIRADA_LANES static Row sampled(const std::array<Texture::Spot, kRays>& spots) {
    return packed_row(Texture::sample_four(spots.data()) >> 8, Texture::sample_four(spots.data() + 4) >> 8);
  }

  MIRADA_LANES static Row packed_row(Words left, Words right) {
    const Bytes halves[2] = {__builtin_convertvector(left, Bytes), __builtin_convertvector(right, Bytes)};
    return std::bit_cast<Row>(halves);
  }

  static constexpr float kTau = 2 * std::numbers::pi_v<float>;
  const SceneView& view_;
  FloorRow::Scene floor_;
};

}  // namespace mirada::world
