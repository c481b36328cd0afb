#include <algorithm>
#include <cmath>
#include <numbers>

#include "world/render/scene_view.h"

namespace mirada::world {
namespace {

using Eigen::Vector3f;

constexpr float kTau = 2 * std::numbers::pi_v<float>;

}  // namespace

bool SceneView::hit_quad(std::size_t index, float x, float y, Hit& best) const {
  const QuadView& view = quads[index];
  const float towards = view.normal_C.x() * x + view.normal_C.y() * y + view.normal_C.z();
  if (towards >= -1e-7F) return false;
  const float t = view.plane / towards;
  if (t >= best.t) return false;
  const Quad& quad = stage->quads[index];
  const float u = view.right0 + t * (view.right_C.x() * x + view.right_C.y() * y + view.right_C.z());
  if (u < 0 || u > quad.width_m) return false;
  const float v = view.down0 + t * (view.down_C.x() * x + view.down_C.y() * y + view.down_C.z());
  if (v < 0 || v > quad.height_m) return false;
  best = {static_cast<int>(index) + kFirstItem, t, u, v};
  return true;
}

bool SceneView::hit_round(std::size_t index, const Vector3f& ray, Hit& best) const {
  const Round& round = rounds[index];
  const float ox = at_m.x() - round.x_m;
  const float oy = at_m.y() - round.y_m;
  const float h = at_m.z();
  float t;
  if (round.cap) {
    if (ray.z() >= 0) return false;
    t = (round.high_m - h) / ray.z();
    const float px = ox + t * ray.x();
    const float py = oy + t * ray.y();
    if (px * px + py * py > round.a) return false;
  } else {
    const float a = ray.x() * ray.x() + ray.y() * ray.y() - round.c * ray.z() * ray.z();
    const float b = ox * ray.x() + oy * ray.y() - (round.b / 2 + round.c * h) * ray.z();
    const float c = ox * ox + oy * oy - round.a - h * (round.b + round.c * h);
    const float disc = b * b - a * c;
    if (disc < 0 || a <= 0) return false;
    t = (-b - std::sqrt(disc)) / a;
    const float z = h + t * ray.z();
    if (z < round.low_m || z > round.high_m) return false;
  }
  if (t < kNearest || t >= best.t) return false;
  best = {static_cast<int>(index + quads.size()) + kFirstItem, t, 0, 0};
  return true;
}

SceneView::Hit SceneView::hit(float x, float y, const std::uint16_t* candidates, std::size_t count) const {
  Hit best;
  best.t = 1e9F;
  const Vector3f ray = ray_W(x, y);
  if (ray.z() < -1e-6F) best = {kFloor, -at_m.z() / ray.z(), 0, 0};
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t item = candidates[i];
    if (item < quads.size()) {
      hit_quad(item, x, y, best);
    } else {
      hit_round(item - quads.size(), ray, best);
    }
  }
  return best;
}

std::uint32_t SceneView::colour(const Hit& hit, float x, float y, std::uint32_t dither) const {
  if (hit.id == kSky) return sky(x, y);
  if (hit.id == kFloor) return floor_colour(x, y, hit.t, dither);
  const auto item = static_cast<std::size_t>(hit.id - kFirstItem);
  return item < quads.size() ? quad_colour(hit, x, y, dither) : round_colour(hit, ray_W(x, y), dither);
}

std::uint32_t SceneView::sky(float x, float y) const {
  const Vector3f ray = ray_W(x, y);
  const float flat = std::sqrt(ray.x() * ray.x() + ray.y() * ray.y());
  const float slope = flat > 0 ? ray.z() / flat : 0;
  const float step = std::clamp(slope * Stage::kSkySteps, 0.0F, static_cast<float>(stage->sky.size() - 1));
  return stage->sky[static_cast<std::size_t>(step)];
}

std::uint32_t SceneView::floor_colour(float x, float y, float t, std::uint32_t dither) const {
  const Texture& texture = stage->textures[stage->floor_texture];
  const float per_m = stage->floor_texels_per_m;
  const Vector3f ray = ray_W(x, y);
  const float u = (at_m.x() + t * ray.x() - stage->floor_min_x_m) * per_m;
  const float v = (stage->floor_max_y_m - at_m.y() - t * ray.y()) * per_m;
  if (u < 0 || v < 0 || u > texture.width() || v > texture.height()) {
    return scaled(packed(Texture::sample(texture.level(1e18F, 0), 0, 0)), 200);
  }
  const float drop = t / at_m.z() * rotation(2, 1);
  const float k = t * pixel_y * per_m;
  const float du = k * (rotation(0, 1) + ray.x() * drop);
  const float dv = -k * (rotation(1, 1) + ray.y() * drop);
  const float across = t * pixel_x * per_m;
  const float along2 = du * du + dv * dv;
  const int taps = floor_taps(std::sqrt(along2) / across);
  const float share = 1.0F / static_cast<float>(taps);
  const Texture::Level& level = texture.level(std::max(across * across, along2 * share * share), dither);
  Lanes sum = 0;
  for (int i = 0; i < taps; ++i) {
    const float offset = (static_cast<float>(i) + 0.5F) * share - 0.5F;
    sum += (Texture::sample(level, u + offset * du, v + offset * dv) >> 8 & kLaneBytes);
  }
  return packed(sum * static_cast<std::uint32_t>(256 / taps));
}

std::uint32_t SceneView::quad_colour(const Hit& hit, float x, float y, std::uint32_t dither) const {
  const auto index = static_cast<std::size_t>(hit.id - kFirstItem);
  const Quad& quad = stage->quads[index];
  const Texture& texture = stage->textures[quad.texture];
  const QuadView& view = quads[index];
  const float facing = -(view.normal_C.x() * x + view.normal_C.y() * y + view.normal_C.z());
  const float per_m = texture.width() / quad.width_m;
  const float across = hit.t * pixel_x * per_m;
  const float stretch = std::min(std::sqrt(1 + x * x + y * y) / facing, 9.0F);
  const Texture::Level& level = texture.level(across * across * stretch, dither);
  return packed(Texture::sample(level, hit.u * per_m, hit.v * texture.height() / quad.height_m));
}

std::uint32_t SceneView::round_colour(const Hit& hit, const Vector3f& ray, std::uint32_t dither) const {
  const Round& round = rounds[static_cast<std::size_t>(hit.id - kFirstItem) - quads.size()];
  const Vector3f p = at_m + hit.t * ray - Vector3f(round.x_m, round.y_m, 0);
  const float front = p.x() * round.ahead_x + p.y() * round.ahead_y;
  const float left = p.y() * round.ahead_x - p.x() * round.ahead_y;
  const Texture& texture = stage->textures[round.head && front < 0 ? round.back_texture : round.texture];
  const float down = (round.high_m - p.z()) / (round.high_m - round.low_m);
  const float column =
      round.head ? 0.5F + left / (2 * round.reach_m) : std::atan2(-left, -front) / kTau + 0.5F;
  const float girth = round.head ? 2 * round.reach_m : kTau * round.reach_m;
  const float across = hit.t * pixel_x * texture.width() / girth;
  const Texture::Level& level = texture.level(across * across * 1.3F, dither);
  const std::uint32_t painted =
      packed(Texture::sample(level, column * texture.width(), (round.cap ? 0.5F : down) * texture.height()));
  const Vector3f slope =
      round.cap ? Vector3f(0, 0, 1) : Vector3f(p.x(), p.y(), -round.b / 2 - round.c * p.z());
  const float bright = stage->lamp.on(slope.normalized()) * 256;
  const Eigen::Vector3f& tint = stage->lamp.tint_bgr;
  std::uint32_t out = 0;
  for (int k = 0; k < 3; ++k) {
    const auto channel = static_cast<float>((painted >> (8 * k)) & 0xFF);
    out |= static_cast<std::uint32_t>(std::min(channel * bright * tint[k] / 256, 255.0F)) << (8 * k);
  }
  return out;
}

}  // namespace mirada::world
