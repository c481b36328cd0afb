#pragma once
#include <vector>

#include "world/render/scene_view.h"

namespace mirada::world {

/// Sorts a picture's tiles by what they may show, so that most pixels need no search: only floor, only one
/// flat face, or a short list of candidates.
class TileSorter {
 public:
  enum class Kind : std::uint8_t { floor, sky, quad, mixed };
  struct Tile {
    std::uint32_t first = 0;  ///< into candidates()
    std::uint16_t count = 0;
    Kind kind = Kind::mixed;
    std::uint8_t floor_taps = 1;  ///< how far the floor is foreshortened here
  };

  explicit TileSorter(const RayTable& rays) : rays_(rays) {}

  void sort(const SceneView& view);
  const std::vector<Tile>& tiles() const { return tiles_; }
  const std::uint16_t* candidates() const { return candidates_.data(); }

 private:
  struct Span {
    float low, high;
    void take(float value);
  };
  struct Corner {
    float q, s;
    float floor_x_m, floor_y_m;
    bool wild;  ///< not ahead: its azimuth says nothing
  };
  void measure_corners(const SceneView& view);
  void bound_tiles();
  void collect(const SceneView& view);
  bool all_floor_before(const SceneView& view, std::size_t tile, std::size_t quad) const;
  Tile settle(const SceneView& view, std::size_t tile, std::uint32_t first, std::size_t count);
  bool covered_by(const SceneView& view, std::size_t tile, std::size_t quad, float& farthest_m) const;
  std::uint8_t taps(std::size_t tile) const;
  bool on_floor_map(const SceneView& view, std::size_t tile) const;
  /// The four corners of a tile, as indices into corners_.
  std::array<std::size_t, 4> corners_of(std::size_t tile) const;

  const RayTable& rays_;
  std::vector<Corner> corners_;
  // Per tile, apart for speed.
  std::vector<float> q_low_, q_high_, s_low_, s_high_;
  std::vector<std::uint8_t> wild_;
  std::vector<std::uint16_t> here_;  ///< items of the tile at hand
  std::vector<Tile> tiles_;
  std::vector<std::uint16_t> candidates_;
};

}  // namespace mirada::world
