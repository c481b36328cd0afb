#include "world/render/tiles.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirada::world {
namespace {

using Eigen::Vector3f;

constexpr float kSlack = 0.06F;  // of a tile's own extent: the directions inside bend a little
constexpr float kLeastSlack = 0.0015F;
constexpr float kMapEdge = 65;          // texels: filtering may reach this far
constexpr float kFloorSlope = -0.005F;  // flatter than this is too far to fill as floor

}  // namespace

std::array<std::size_t, 4> TileSorter::corners_of(std::size_t tile) const {
  const std::size_t row = tile / static_cast<std::size_t>(rays_.tiles_x);
  const std::size_t at = tile + row;  // rows of corners are longer by one
  const auto below = at + static_cast<std::size_t>(rays_.tiles_x) + 1;
  return {at, at + 1, below, below + 1};
}

void TileSorter::measure_corners(const SceneView& view) {
  corners_.resize(rays_.corner_x.size());
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Vector3f ray = view.ray_W(rays_.corner_x[i], rays_.corner_y[i]);
    const float ahead = ray.x() * view.ahead_x + ray.y() * view.ahead_y;
    const float left = ray.y() * view.ahead_x - ray.x() * view.ahead_y;
    const float flat = std::sqrt(ahead * ahead + left * left);
    Corner& corner = corners_[i];
    corner.wild = ahead < 0.05F * ray.norm();
    corner.q = corner.wild ? 0 : left / ahead;
    corner.s = ray.z() / std::max(flat, 1e-6F);
    const float t = ray.z() < -1e-6F ? -view.at_m.z() / ray.z() : 0;
    corner.floor_x_m = view.at_m.x() + t * ray.x();
    corner.floor_y_m = view.at_m.y() + t * ray.y();
  }
}

void TileSorter::bound_tiles() {
  const auto count = static_cast<std::size_t>(rays_.tiles_x) * static_cast<std::size_t>(rays_.tiles_y);
  for (auto* list : {&q_low_, &q_high_, &s_low_, &s_high_}) list->resize(count);
  wild_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto [a, b, c, d] = corners_of(i);
    const auto [q_low, q_high] = std::minmax({corners_[a].q, corners_[b].q, corners_[c].q, corners_[d].q});
    const auto [s_low, s_high] = std::minmax({corners_[a].s, corners_[b].s, corners_[c].s, corners_[d].s});
    const float q_slack = kLeastSlack + kSlack * (q_high - q_low);
    const float s_slack = kLeastSlack + kSlack * (s_high - s_low);
    q_low_[i] = q_low - q_slack;
    q_high_[i] = q_high + q_slack;
    s_low_[i] = s_low - s_slack;
    s_high_[i] = s_high + s_slack;
    wild_[i] = corners_[a].wild || corners_[b].wild || corners_[c].wild || corners_[d].wild;
  }
}

bool TileSorter::all_floor_before(const SceneView& view, std::size_t tile, std::size_t quad) const {
  const Quad& face = view.stage->quads[quad];
  if (face.normal.z() != 0 || s_high_[tile] > kFloorSlope) return false;
  for (const std::size_t i : corners_of(tile)) {
    const Corner& corner = corners_[i];
    const float reach =
        std::abs(corner.floor_x_m - view.at_m.x()) + std::abs(corner.floor_y_m - view.at_m.y());
    const float before = face.normal.x() * (corner.floor_x_m - face.corner_m.x()) +
                         face.normal.y() * (corner.floor_y_m - face.corner_m.y());
    if (before < 0.004F * reach) return false;
  }
  return true;
}

bool TileSorter::covered_by(const SceneView& view, std::size_t tile, std::size_t quad,
                            float& farthest_m) const {
  farthest_m = 0;
  for (const std::size_t i : corners_of(tile)) {
    const auto item = static_cast<std::uint16_t>(quad);
    const SceneView::Hit hit = view.hit(rays_.corner_x[i], rays_.corner_y[i], &item, 1);
    if (hit.id != static_cast<int>(quad) + SceneView::kFirstItem) return false;
    const Vector3f ray = view.ray_W(rays_.corner_x[i], rays_.corner_y[i]);
    farthest_m = std::max(farthest_m, hit.t * std::sqrt(ray.x() * ray.x() + ray.y() * ray.y()));
  }
  return true;
}

std::uint8_t TileSorter::taps(std::size_t tile) const {
  // The floor's footprint of a pixel is longer than wide by about 1 / sine of the angle that it is seen
  // under.
  const float slope = (s_low_[tile] + s_high_[tile]) / 2;
  const float longer = std::sqrt(1 + slope * slope) / std::max(-slope, 0.01F);
  return static_cast<std::uint8_t>(SceneView::floor_taps(longer));
}

bool TileSorter::on_floor_map(const SceneView& view, std::size_t tile) const {
  const Stage& stage = *view.stage;
  const Texture& texture = stage.textures[stage.floor_texture];
  for (const std::size_t i : corners_of(tile)) {
    const float u = (corners_[i].floor_x_m - stage.floor_min_x_m) * stage.floor_texels_per_m;
    const float v = (stage.floor_max_y_m - corners_[i].floor_y_m) * stage.floor_texels_per_m;
    if (u < kMapEdge || v < kMapEdge || u > texture.width() - kMapEdge || v > texture.height() - kMapEdge)
      return false;
  }
  return true;
}

TileSorter::Tile TileSorter::settle(const SceneView& view, std::size_t tile, std::uint32_t first,
                                    std::size_t count) {
  Tile out{first, static_cast<std::uint16_t>(count), Kind::mixed, taps(tile)};
  if (wild_[tile]) return out;
  if (count == 0) {
    if (s_high_[tile] < kFloorSlope && on_floor_map(view, tile)) out.kind = Kind::floor;
    if (s_low_[tile] > 0.001F) out.kind = Kind::sky;
    return out;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t index = here_[i];
    const std::uint16_t item = view.items[index];
    float farthest_m = 0;
    if (item >= view.quads.size() || !covered_by(view, tile, item, farthest_m)) continue;
    bool hidden = true;
    for (std::size_t k = 0; k < count; ++k) {
      hidden = hidden && (k == i || view.seen[here_[k]].nearest_m > farthest_m);
    }
    if (!hidden) continue;
    candidates_.resize(first);
    candidates_.push_back(item);
    out.count = 1;
    out.kind = Kind::quad;
    return out;
  }
  return out;
}

void TileSorter::collect(const SceneView& view) {
  tiles_.resize(q_low_.size());
  candidates_.clear();
  for (std::size_t tile = 0; tile < tiles_.size(); ++tile) {
    here_.clear();
    for (std::size_t i = 0; i < view.items.size(); ++i) {
      const Directions& d = view.seen[i];
      if (!wild_[tile] && (d.q_low > q_high_[tile] || d.q_high < q_low_[tile] || d.s_low > s_high_[tile] ||
                           d.s_high < s_low_[tile])) {
        continue;
      }
      if (view.items[i] < view.quads.size() && all_floor_before(view, tile, view.items[i])) continue;
      here_.push_back(static_cast<std::uint16_t>(i));
    }
    const auto first = static_cast<std::uint32_t>(candidates_.size());
    for (const std::uint16_t i : here_) candidates_.push_back(view.items[i]);
    tiles_[tile] = settle(view, tile, first, here_.size());
  }
}

void TileSorter::sort(const SceneView& view) {
  measure_corners(view);
  bound_tiles();
  collect(view);
}

}  // namespace mirada::world
