#include "world/render/renderer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>

#include "world/render/finish.h"
#include "world/render/floor_row.h"
#include "world/render/hit_row.h"
#include "world/render/paint_board.h"
#include "world/render/per_cpu.h"
#include "world/render/tiles.h"

namespace mirada::world {
namespace {

constexpr int kTile = RayTable::kTile_px;
constexpr std::uint32_t kMiddleDither = 1U << 22;

/// Ordered dither over 8 x 4 pixels, in parts of 2^23.
constexpr auto kDither = [] {
  constexpr int kBayer[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
  std::array<std::array<std::uint32_t, kTile>, 4> out{};
  for (std::size_t y = 0; y < 4; ++y) {
    for (std::size_t x = 0; x < kTile; ++x)
      out[y][x] = static_cast<std::uint32_t>(2 * kBayer[y][x & 3] + 1) << 18;
  }
  return out;
}();
std::uint32_t dither_at(int x, int y) {
  return kDither[static_cast<std::size_t>(y & 3)][static_cast<std::size_t>(x & 7)];
}

// Four samples of a pixel on a turned grid, in pixels from its middle.
constexpr std::array<std::array<float, 2>, 4> kSamples = {
    {{-0.125F, -0.375F}, {0.375F, -0.125F}, {-0.375F, 0.125F}, {0.125F, 0.375F}}};

}  // namespace

struct Renderer::Impl {
  Impl(const WorldConfig& placed, const CameraModel& camera, std::uint64_t seed)
      : stage(placed, seed), rays(camera), view(stage), sorter(rays), finish(rays, placed.noise, seed) {
    pixels.resize(rays.x.size());
    ids.resize(rays.x.size());
  }

  /// Eight pixels side by side of which all are floor, or all show one face.
  using Row = std::array<std::uint32_t, kTile>;
  MIRADA_LANES static Row packed_row(Words left, Words right) {
    const Bytes halves[2] = {__builtin_convertvector(left, Bytes), __builtin_convertvector(right, Bytes)};
    return std::bit_cast<Row>(halves);
  }

  void fill_tile(int tx, int ty);
  void fill_tiles();
  void mixed_tile(std::size_t start, const TileSorter::Tile& tile);
  void mixed_row(std::size_t row, int y, const TileSorter::Tile& tile);
  void floor_tile(std::size_t start, const TileSorter::Tile& tile);
  Row floor_row(std::size_t row, int y, int taps) const;
  void quad_tile(std::size_t start, const TileSorter::Tile& tile);
  Row quad_row(std::size_t row, int y, std::size_t item) const;
  void sky_tile(std::size_t start);
  void smooth_edges();
  std::uint32_t resampled(int x, int y) const;
  bool on_edge(std::size_t at, int x, int y) const;
  /// Whether four pixels side by side and all their neighbours show the same thing.
  bool four_alike(std::size_t at) const;
  std::size_t at(int x, int y) const { return static_cast<std::size_t>(y * rays.stride + x); }

  Stage stage;
  RayTable rays;
  SceneView view;
  std::optional<FloorRow::Scene> floor;  ///< of the picture at hand
  TileSorter sorter;
  Finish finish;
  std::vector<std::uint32_t> pixels;
  std::vector<std::uint16_t> ids;
};

MIRADA_INSIDE void Renderer::Impl::mixed_row(std::size_t row, int y, const TileSorter::Tile& tile) {
  HitRow hits;
  hits.find(view, rays.x.data() + row, rays.y.data() + row, sorter.candidates() + tile.first, tile.count);
  for (int x = 0; x < kTile; ++x) ids[row + static_cast<std::size_t>(x)] = static_cast<std::uint16_t>(hits.id(x));
  for (unsigned left = 0xFF; left != 0;) {
    const int first = std::countr_zero(left);
    const unsigned alike = hits.like(first);
    left &= ~alike;
    const int id = hits.id(first);
    const auto item = static_cast<std::size_t>(id - SceneView::kFirstItem);
    const bool quad = id >= SceneView::kFirstItem && item < view.quads.size();
    // Eight at once cost about as much as two one by one.
    if (std::popcount(alike) >= 2 && (quad || (id == SceneView::kFloor && tile.on_floor_map))) {
      const Row colours = quad ? quad_row(row, y, item) : floor_row(row, y, tile.floor_taps);
      for (std::size_t x = 0; x < kTile; ++x) {
        if ((alike >> x & 1) != 0) pixels[row + x] = colours[x];
      }
      continue;
    }
    for (unsigned rest = alike; rest != 0; rest &= rest - 1) {
      const int x = std::countr_zero(rest);
      const std::size_t i = row + static_cast<std::size_t>(x);
      pixels[i] = view.colour(hits.hit(x), rays.x[i], rays.y[i], dither_at(x, y));
    }
  }
}

MIRADA_INSIDE void Renderer::Impl::mixed_tile(std::size_t start, const TileSorter::Tile& tile) {
  for (int y = 0; y < kTile; ++y) mixed_row(start + static_cast<std::size_t>(y * rays.stride), y, tile);
}

MIRADA_INSIDE Renderer::Impl::Row Renderer::Impl::floor_row(std::size_t row, int y, int taps) const {
  FloorRow line;
  line.aim(*floor, rays.x.data() + row, rays.y.data() + row, taps,
           kDither[static_cast<std::size_t>(y & 3)].data());
  Words left, right;
  if (taps == 1) {
    line.look(*floor, 0, left, right);
    return packed_row(left >> 8, right >> 8);
  }
  Words left_sum{}, right_sum{};
  for (int i = 0; i < taps; ++i) {
    line.look(*floor, (static_cast<float>(i) + 0.5F) / static_cast<float>(taps) - 0.5F, left, right);
    left_sum += left >> 8;
    right_sum += right >> 8;
  }
  const auto part = static_cast<std::uint16_t>(256 / taps);
  return packed_row(left_sum * part >> 8, right_sum * part >> 8);
}

MIRADA_INSIDE void Renderer::Impl::floor_tile(std::size_t start, const TileSorter::Tile& tile) {
  for (int y = 0; y < kTile; ++y) {
    const std::size_t row = start + static_cast<std::size_t>(y * rays.stride);
    const Row line = floor_row(row, y, tile.floor_taps);
    std::copy(line.begin(), line.end(), pixels.begin() + static_cast<std::ptrdiff_t>(row));
    std::fill_n(ids.begin() + static_cast<std::ptrdiff_t>(row), kTile, std::uint16_t{SceneView::kFloor});
  }
}

MIRADA_INSIDE Renderer::Impl::Row Renderer::Impl::quad_row(std::size_t row, int y, std::size_t item) const {
  const Quad& quad = stage.quads[item];
  const QuadView& q = view.quads[item];
  const Texture& texture = stage.textures[quad.texture];
  const float per_u = texture.width() / quad.width_m;
  const float per_v = texture.height() / quad.height_m;
  const float* rx = rays.x.data() + row;
  const float* ry = rays.y.data() + row;
  std::array<float, kTile> u, v, footprint2;
  for (std::size_t x = 0; x < kTile; ++x) {
    const float facing = q.normal_C.x() * rx[x] + q.normal_C.y() * ry[x] + q.normal_C.z();
    const float t = q.plane / facing;
    u[x] = (q.right0 + t * (q.right_C.x() * rx[x] + q.right_C.y() * ry[x] + q.right_C.z())) * per_u;
    v[x] = (q.down0 + t * (q.down_C.x() * rx[x] + q.down_C.y() * ry[x] + q.down_C.z())) * per_v;
    const float across = t * view.pixel_x * per_u;
    const float stretch = -(1 + (rx[x] * rx[x] + ry[x] * ry[x]) / 2) / facing;
    footprint2[x] = across * across * (stretch < 9 ? stretch : 9.0F);
  }
  std::array<Texture::Spot, kTile> spots;
  for (std::size_t x = 0; x < kTile; ++x) {
    const Texture::Level& level = texture.level(footprint2[x], dither_at(static_cast<int>(x), y));
    spots[x] = Texture::spot(level, u[x], v[x]);
  }
  return packed_row(Texture::sample_four(spots.data()) >> 8, Texture::sample_four(spots.data() + 4) >> 8);
}

MIRADA_INSIDE void Renderer::Impl::quad_tile(std::size_t start, const TileSorter::Tile& tile) {
  const std::size_t item = sorter.candidates()[tile.first];
  const auto id = static_cast<std::uint16_t>(item + SceneView::kFirstItem);
  for (int y = 0; y < kTile; ++y) {
    const std::size_t row = start + static_cast<std::size_t>(y * rays.stride);
    const Row line = quad_row(row, y, item);
    std::copy(line.begin(), line.end(), pixels.begin() + static_cast<std::ptrdiff_t>(row));
    std::fill_n(ids.begin() + static_cast<std::ptrdiff_t>(row), kTile, id);
  }
}

MIRADA_INSIDE void Renderer::Impl::sky_tile(std::size_t start) {
  for (int y = 0; y < kTile; ++y) {
    for (int x = 0; x < kTile; ++x) {
      const std::size_t i = start + static_cast<std::size_t>(y * rays.stride + x);
      pixels[i] = view.sky(rays.x[i], rays.y[i]);
      ids[i] = SceneView::kSky;
    }
  }
}

MIRADA_INSIDE void Renderer::Impl::fill_tile(int tx, int ty) {
  const TileSorter::Tile& tile = sorter.tiles()[static_cast<std::size_t>(ty * rays.tiles_x + tx)];
  const std::size_t start = at(tx * kTile, ty * kTile);
  switch (tile.kind) {
    case TileSorter::Kind::floor:
      floor_tile(start, tile);
      break;
    case TileSorter::Kind::sky:
      sky_tile(start);
      break;
    case TileSorter::Kind::quad:
      quad_tile(start, tile);
      break;
    case TileSorter::Kind::mixed:
      mixed_tile(start, tile);
      break;
  }
}

MIRADA_PER_CPU void Renderer::Impl::fill_tiles() {
  floor.emplace(view);
  for (int ty = 0; ty < rays.tiles_y; ++ty) {
    for (int tx = 0; tx < rays.tiles_x; ++tx) fill_tile(tx, ty);
  }
}

bool Renderer::Impl::on_edge(std::size_t i, int x, int y) const {
  const std::uint16_t id = ids[i];
  return (x > 0 && ids[i - 1] != id) || (x + 1 < rays.width && ids[i + 1] != id) ||
         (y > 0 && ids[i - static_cast<std::size_t>(rays.stride)] != id) ||
         (y + 1 < rays.height && ids[i + static_cast<std::size_t>(rays.stride)] != id);
}

MIRADA_INSIDE std::uint32_t Renderer::Impl::resampled(int x, int y) const {
  const TileSorter::Tile& tile =
      sorter.tiles()[static_cast<std::size_t>((y / kTile) * rays.tiles_x + x / kTile)];
  const std::uint16_t* items = sorter.candidates() + tile.first;
  const std::size_t i = at(x, y);
  // How the ray changes a pixel to the right and down, from the neighbours.
  const std::size_t left = x > 0 ? i - 1 : i;
  const std::size_t right = x + 1 < rays.width ? i + 1 : i;
  const std::size_t up = y > 0 ? i - static_cast<std::size_t>(rays.stride) : i;
  const std::size_t down = y + 1 < rays.height ? i + static_cast<std::size_t>(rays.stride) : i;
  const float wide = 1.0F / static_cast<float>(std::max<std::size_t>(right - left, 1));
  const float deep = up != i && down != i ? 0.5F : 1.0F;
  std::array<float, HitRow::kRays> rx, ry;
  for (std::size_t k = 0; k < HitRow::kRays; ++k) {
    const auto& [sx, sy] = kSamples[k % kSamples.size()];
    rx[k] =
        rays.x[i] + sx * wide * (rays.x[right] - rays.x[left]) + sy * deep * (rays.x[down] - rays.x[up]);
    ry[k] =
        rays.y[i] + sx * wide * (rays.y[right] - rays.y[left]) + sy * deep * (rays.y[down] - rays.y[up]);
  }
  HitRow hits;
  hits.find(view, rx.data(), ry.data(), items, tile.count);
  Lanes sum = 0;
  for (std::size_t k = 0; k < kSamples.size(); ++k)
    sum += spread(view.colour(hits.hit(static_cast<int>(k)), rx[k], ry[k], kMiddleDither));
  return packed(sum * 64);
}

bool Renderer::Impl::four_alike(std::size_t i) const {
  const auto four = [&](std::size_t start) {
    std::uint64_t out;
    std::memcpy(&out, ids.data() + start, sizeof out);
    return out;
  };
  const auto stride = static_cast<std::size_t>(rays.stride);
  const std::uint64_t own = four(i);
  return ((own ^ four(i - 1)) | (own ^ four(i + 1)) | (own ^ four(i - stride)) | (own ^ four(i + stride))) ==
         0;
}

MIRADA_PER_CPU void Renderer::Impl::smooth_edges() {
  for (int y = 0; y < rays.height; ++y) {
    for (int x = 0; x < rays.width; x += 4) {
      const std::size_t i = at(x, y);
      const bool inside = x > 0 && y > 0 && x + 4 < rays.width && y + 1 < rays.height;
      if (inside && four_alike(i)) continue;
      for (int k = 0; k < 4 && x + k < rays.width; ++k) {
        const std::size_t own = i + static_cast<std::size_t>(k);
        if (on_edge(own, x + k, y)) pixels[own] = resampled(x + k, y);
      }
    }
  }
}

Renderer::Renderer(const WorldConfig& placed, const CameraModel& camera, std::uint64_t seed)
    : impl_(std::make_unique<Impl>(placed, camera, seed)) {}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;

cv::Mat Renderer::render(const Eigen::Isometry3d& X_WC, const std::vector<Pose2>& people, std::int64_t chance,
                         const HeldBoard* held) {
  Impl& r = *impl_;
  r.view.look(r.rays, X_WC, people);
  r.sorter.sort(r.view);
  r.fill_tiles();
  r.smooth_edges();
  if (held != nullptr) paint_board(r.rays, *held, r.pixels);
  return r.finish.develop(r.pixels, static_cast<std::uint64_t>(chance));
}

}  // namespace mirada::world
