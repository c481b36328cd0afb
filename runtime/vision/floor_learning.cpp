// What the floor memory learns from a picture that was judged.
#include <algorithm>
#include <array>
#include <cmath>

#include "vision/floor_memory.h"

namespace mirada::vision {
namespace {

constexpr double kLearnTo_m = 0.45;  // beyond the nearest visible floor
constexpr int kFadeEvery = 16;
constexpr int kToneRows = 4;

Look mean_look(const PictureGrid& grid, int column, int row) {
  Look sum{0, 0, 0};
  for (int r = row; r > row - kToneRows; --r) {
    const Look look = grid.look(column, r);
    sum = {sum.light + look.light, sum.red + look.red, sum.blue + look.blue};
  }
  return {sum.light / kToneRows, sum.red / kToneRows, sum.blue / kToneRows};
}

/// Whether a row lies in something that was crossed and may yet stand on the floor. What is learnt is never
/// an obstacle again, so this teaches nothing.
bool in_doubt(const ColumnResult& result, int row) {
  for (int k = 0; k < result.crossing_count; ++k) {
    const ColumnResult::Crossing& c = result.crossings[static_cast<std::size_t>(k)];
    if (!c.flat && row <= c.from_row + 1 && row >= c.to_row - 1) return true;
  }
  return false;
}

}  // namespace

bool FloorMemory::learn_patches(const PictureGrid& grid, const std::vector<ColumnResult>& results) {
  constexpr int kPatchWeight = 6;
  int columns = 0;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const ColumnResult& result = results[i];
    bool any = false;
    for (int k = 0; k < result.crossing_count; ++k) {
      const ColumnResult::Crossing& c = result.crossings[static_cast<std::size_t>(k)];
      if (!c.patch || !c.flat) continue;
      any = true;
      for (int row = c.from_row - 2; row > c.to_row + 2; row -= 2)
        looks_.add(grid.look(static_cast<int>(i), row), kPatchWeight);
      for (int row = c.from_row - 2; row > c.to_row + 2 + kToneRows; row -= kToneRows)
        tones_.add(mean_look(grid, static_cast<int>(i), row), kPatchWeight);
    }
    columns += any;
  }
  return columns > 0;
}

void FloorMemory::learn(const PictureGrid& grid, const std::vector<ColumnSpan>& spans, const RowScale& scale,
                        const std::vector<ColumnResult>& results) {
  if (!can_learn_) return;
  if (++pictures_since_fade_ >= kFadeEvery) {
    pictures_since_fade_ = 0;
    looks_.fade();
    tones_.fade();
  }
  learn_tones(grid, spans, scale, results);
  const double limit_m = scale.depth_m.back() + kLearnTo_m;
  Look sum{0, 0, 0};
  int count = 0;
  for (std::size_t i = 2; i < results.size(); i += 5) {
    if (results[i].end != ColumnResult::End::boundary && results[i].end != ColumnResult::End::floor_to_top)
      continue;
    const int top = static_cast<int>(results[i].row) + 8;
    for (int row = spans[i].bottom_row - 4; row > top; row -= 12) {
      if (scale.depth_m[static_cast<std::size_t>(row)] > limit_m) break;
      if (in_doubt(results[i], row)) continue;
      const Look look = grid.look(static_cast<int>(i), row);
      looks_.add(look, 4);
      const bool main = std::abs(look.light - home_.light) < 16 && std::abs(look.red - home_.red) < 10 &&
                        std::abs(look.blue - home_.blue) < 10;
      if (!main || row < spans[i].bottom_row - 40) continue;
      sum = {sum.light + look.light, sum.red + look.red, sum.blue + look.blue};
      ++count;
    }
  }
  if (count > 0) home_ = {sum.light / count, sum.red / count, sum.blue / count};
}

void FloorMemory::learn_tones(const PictureGrid& grid, const std::vector<ColumnSpan>& spans,
                              const RowScale& scale, const std::vector<ColumnResult>& results) {
  const double limit_m = scale.depth_m.back() + kLearnTo_m;
  for (std::size_t i = 2; i < results.size(); i += 5) {
    if (results[i].end != ColumnResult::End::boundary && results[i].end != ColumnResult::End::floor_to_top)
      continue;
    const int top = static_cast<int>(results[i].row) + 8;
    for (int row = spans[i].bottom_row - 4; row > top; row -= 3 * kToneRows) {
      if (scale.depth_m[static_cast<std::size_t>(row)] > limit_m) break;
      if (in_doubt(results[i], row)) continue;
      tones_.add(mean_look(grid, static_cast<int>(i), row), 4);
    }
  }
}

/// What was crossed in many columns side by side as the floor in another light is one of its lights.
void FloorMemory::see_crossed_lights(const PictureGrid& grid, const std::vector<ColumnResult>& results) {
  constexpr int kBin = 12;
  constexpr int kEnoughColumns = 15;
  struct Sum {
    int light = 0, red = 0, blue = 0, count = 0;
  };
  std::array<Sum, 256 / kBin + 1> sums{};
  for (std::size_t i = 0; i < results.size(); ++i) {
    for (int k = 0; k < results[i].crossing_count; ++k) {
      const ColumnResult::Crossing& c = results[i].crossings[static_cast<std::size_t>(k)];
      if (c.patch || c.doubtful || c.upright_m < 0.02F) continue;
      const Look look = grid.look(static_cast<int>(i), (c.from_row + c.to_row) / 2);
      Sum& sum = sums[static_cast<std::size_t>(std::clamp(look.light, 0, 255) / kBin)];
      sum = {sum.light + look.light, sum.red + look.red, sum.blue + look.blue, sum.count + 1};
    }
  }
  for (const Sum& sum : sums) {
    if (sum.count < kEnoughColumns) continue;
    const Look look{sum.light / sum.count, sum.red / sum.count, sum.blue / sum.count};
    lights_.see(look);
  }
}

}  // namespace mirada::vision
