#include "world/render/renderer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>

#include "world/render/finish.h"
#include "world/render/paint_board.h"
#include "world/render/row_shader.h"
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

  using Row = RowShader::Row;

  void fill_tile(int tx, int ty);
  void fill_tiles();
  void mixed_tile(std::size_t start, const TileSorter::Tile& tile);
  void mixed_row(std::size_t row, int y, const TileSorter::Tile& tile);
  void floor_tile(std::size_t start, const TileSorter::Tile& tile);
  void quad_tile(std::size_t start, const TileSorter::Tile& tile);
  void sky_tile(std::size_t start);
  void smooth_edges();
  RowShader::Rays rays_of(std::size_t row, int y) const {
    return {rays.x.data() + row, rays.y.data() + row, kDither[static_cast<std::size_t>(y & 3)].data()};
  }
  static RowShader::Filter filter_of(const TileSorter::Tile& tile) {
    return {tile.floor_taps, tile.floor_taps};
  }
  void keep(const Row& row, std::size_t start) {
    std::copy(row.begin(), row.end(), pixels.begin() + static_cast<std::ptrdiff_t>(start));
  }
  void resample_two(int x, int y, unsigned which);
  void aim_samples(int x, int y, float* sample_x, float* sample_y) const;
  bool on_edge(std::size_t at, int x, int y) const;
  /// Whether four pixels side by side and all their neighbours show the same thing.
  bool four_alike(std::size_t at) const;
  std::size_t at(int x, int y) const { return static_cast<std::size_t>(y * rays.stride + x); }

  Stage stage;
  RayTable rays;
  SceneView view;
  std::optional<RowShader> shader;  ///< of the picture at hand
  TileSorter sorter;
  Finish finish;
  std::vector<std::uint32_t> pixels;
  std::vector<std::uint16_t> ids;
};

MIRADA_INSIDE void Renderer::Impl::mixed_row(std::size_t row, int y, const TileSorter::Tile& tile) {
  const RowShader::Rays line = rays_of(row, y);
  HitRow hits;
  hits.find(view, line.x, line.y, sorter.candidates() + tile.first, tile.count);
  for (std::size_t x = 0; x < kTile; ++x)
    ids[row + x] = static_cast<std::uint16_t>(hits.id(static_cast<int>(x)));
  keep(shader->seen(hits, 0xFF, line, filter_of(tile)), row);
}

MIRADA_INSIDE void Renderer::Impl::mixed_tile(std::size_t start, const TileSorter::Tile& tile) {
  for (int y = 0; y < kTile; ++y) mixed_row(start + static_cast<std::size_t>(y * rays.stride), y, tile);
}

MIRADA_INSIDE void Renderer::Impl::floor_tile(std::size_t start, const TileSorter::Tile& tile) {
  const RowShader::Filter filter = filter_of(tile);
  for (int y = 0; y < kTile; ++y) {
    const std::size_t row = start + static_cast<std::size_t>(y * rays.stride);
    keep(shader->floor(rays_of(row, y), filter), row);
    std::fill_n(ids.begin() + static_cast<std::ptrdiff_t>(row), kTile, std::uint16_t{SceneView::kFloor});
  }
}

MIRADA_INSIDE void Renderer::Impl::quad_tile(std::size_t start, const TileSorter::Tile& tile) {
  const std::size_t item = sorter.candidates()[tile.first];
  const auto id = static_cast<std::uint16_t>(item + SceneView::kFirstItem);
  for (int y = 0; y < kTile; ++y) {
    const std::size_t row = start + static_cast<std::size_t>(y * rays.stride);
    keep(shader->quad(rays_of(row, y), item), row);
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
  shader.emplace(view);
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

void Renderer::Impl::aim_samples(int x, int y, float* sample_x, float* sample_y) const {
  const std::size_t i = at(x, y);
  // How the ray changes a pixel to the right and down, from the neighbours.
  const std::size_t left = x > 0 ? i - 1 : i;
  const std::size_t right = x + 1 < rays.width ? i + 1 : i;
  const std::size_t up = y > 0 ? i - static_cast<std::size_t>(rays.stride) : i;
  const std::size_t down = y + 1 < rays.height ? i + static_cast<std::size_t>(rays.stride) : i;
  const float wide = 1.0F / static_cast<float>(std::max<std::size_t>(right - left, 1));
  const float deep = up != i && down != i ? 0.5F : 1.0F;
  for (const auto& [sx, sy] : kSamples) {
    *sample_x++ =
        rays.x[i] + sx * wide * (rays.x[right] - rays.x[left]) + sy * deep * (rays.x[down] - rays.x[up]);
    *sample_y++ =
        rays.y[i] + sx * wide * (rays.y[right] - rays.y[left]) + sy * deep * (rays.y[down] - rays.y[up]);
  }
}

MIRADA_INSIDE void Renderer::Impl::resample_two(int x, int y, unsigned which) {
  static constexpr std::array<std::uint32_t, RowShader::kRays> kNoDither = {
      kMiddleDither, kMiddleDither, kMiddleDither, kMiddleDither,
      kMiddleDither, kMiddleDither, kMiddleDither, kMiddleDither};
  constexpr unsigned kHalf = 0xF;
  const TileSorter::Tile& tile =
      sorter.tiles()[static_cast<std::size_t>((y / kTile) * rays.tiles_x + x / kTile)];
  std::array<float, RowShader::kRays> sample_x, sample_y;
  aim_samples(x, y, sample_x.data(), sample_y.data());
  aim_samples(std::min(x + 1, rays.width - 1), y, sample_x.data() + 4, sample_y.data() + 4);
  HitRow hits;
  hits.find(view, sample_x.data(), sample_y.data(), sorter.candidates() + tile.first, tile.count);
  const unsigned wanted = ((which & 1) != 0 ? kHalf : 0) | ((which & 2) != 0 ? kHalf << 4 : 0);
  const RowShader::Filter filter{int{kSamples.size()}, 1};
  const Row seen = shader->seen(hits, wanted, {sample_x.data(), sample_y.data(), kNoDither.data()}, filter);
  for (std::size_t k = 0; k < 2; ++k) {
    if ((which >> k & 1) == 0) continue;
    Lanes sum = 0;
    for (std::size_t i = 0; i < kSamples.size(); ++i) sum += spread(seen[4 * k + i]);
    pixels[at(x, y) + k] = packed(sum * 64);
  }
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
      for (int k = 0; k < 4 && x + k < rays.width; k += 2) {
        unsigned which = on_edge(at(x + k, y), x + k, y) ? 1 : 0;
        if (x + k + 1 < rays.width && on_edge(at(x + k + 1, y), x + k + 1, y)) which |= 2;
        if (which != 0) resample_two(x + k, y, which);
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
