#include "vision/floor_study.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace mirada::vision {
namespace {

constexpr int kSameLight = 12;
constexpr int kSameColour = 9;
constexpr int kDarkest = 34;  // Look units: about 8 of 255
constexpr int kGlare = 253;   // of 255, in every channel
constexpr double kStripDepth_m = 0.15;
constexpr int kWeightOfASample = 12;

bool same(const Look& a, const Look& b) {
  return std::abs(a.light - b.light) <= kSameLight && std::abs(a.red - b.red) <= kSameColour &&
         std::abs(a.blue - b.blue) <= kSameColour;
}

}  // namespace

int FloorStudy::group_of(const Look& look) {
  for (int i = 0; i < group_count_; ++i) {
    Group& group = groups_[static_cast<std::size_t>(i)];
    const Look mean{group.light_sum / group.size, group.red_sum / group.size, group.blue_sum / group.size};
    if (same(mean, look)) return i;
  }
  if (group_count_ == kGroups) return kNoGroup;
  groups_[static_cast<std::size_t>(group_count_)] = Group{.seed = look};
  return group_count_++;
}

void FloorStudy::sample(const PictureGrid& grid, const std::vector<ColumnSpan>& spans, int bottom, int top) {
  group_count_ = sample_count_ = glaring_ = 0;
  const int first = grid.columns() * 15 / 100;
  const int width = grid.columns() * 70 / 100;
  for (int i = 0; i < kColumns; ++i) {
    const int column = first + i * width / kColumns;
    int& height = heights_[static_cast<std::size_t>(i)] = 0;
    for (int j = 0; j < kRows; ++j) {
      const int row = bottom - j * (bottom - top) / (kRows - 1);
      if (row > spans[static_cast<std::size_t>(column)].bottom_row || row < 0) continue;
      Sample& out = samples_[static_cast<std::size_t>(i * kRows + height++)];
      out.look = grid.look(column, row);
      const auto c = grid.colour(column, row);
      glaring_ += std::min({c[0], c[1], c[2]}) >= kGlare;
      ++sample_count_;
      out.group = group_of(out.look);
      if (out.group == kNoGroup) continue;
      Group& group = groups_[static_cast<std::size_t>(out.group)];
      group.light_sum += out.look.light;
      group.red_sum += out.look.red;
      group.blue_sum += out.look.blue;
      ++group.size;
    }
  }
}

void FloorStudy::find_hanging() {
  for (int i = 0; i < kColumns; ++i) {
    const Sample* column = &samples_[static_cast<std::size_t>(i * kRows)];
    const int height = heights_[static_cast<std::size_t>(i)];
    for (int j = height - 1; j > 0; --j) {
      if (column[j].group == kNoGroup || column[j].group != column[height - 1].group) break;
      const bool reaches_foot =
          std::all_of(column, column + j, [&](const Sample& s) { return s.group == column[j].group; });
      if (reaches_foot) break;
      ++groups_[static_cast<std::size_t>(column[j].group)].hanging;
    }
  }
}

bool FloorStudy::choose_floor() {
  int explained = 0;
  int largest = 0;
  for (int i = 0; i < group_count_; ++i) {
    Group& group = groups_[static_cast<std::size_t>(i)];
    group.floor = group.size * 25 >= sample_count_ && group.hanging * 4 < group.size * 3;
    if (!group.floor) continue;
    explained += group.size;
    if (group.size <= largest) continue;
    largest = group.size;
    main_look_ = {group.light_sum / group.size, group.red_sum / group.size, group.blue_sum / group.size};
  }
  return largest > 0 && explained * 2 >= sample_count_;
}

void FloorStudy::measure_texture(const PictureGrid& grid, int bottom, int top) {
  int light = 0;
  int colour = 0;
  int n = 0;
  const int first = grid.columns() * 15 / 100;
  const int width = grid.columns() * 70 / 100;
  for (int i = 0; i < kColumns; ++i) {
    const int column = first + i * width / kColumns;
    for (int j = 0; j + 1 < kRows; ++j) {
      const int row = bottom - j * (bottom - top) / (kRows - 1);
      const Look a = grid.look(column, row);
      const Look b = grid.look(column, std::max(row - 3, 0));
      if (!same(a, b)) continue;
      light += std::abs(a.light - b.light);
      colour += std::max(std::abs(a.red - b.red), std::abs(a.blue - b.blue));
      ++n;
    }
  }
  if (n == 0) return;
  constexpr double kSigmaOfMeanDifference = 0.886;  // of two equal Gaussians
  texture_.light_sigma = std::max(1.0, kSigmaOfMeanDifference * light / n);
  texture_.colour_sigma = std::max(1.0, kSigmaOfMeanDifference * colour / n);
}

FloorStudy::Verdict FloorStudy::run(const PictureGrid& grid, const std::vector<ColumnSpan>& spans,
                                    const std::vector<double>& depth_m) {
  const int bottom = grid.rows() - 1;
  int top = bottom;
  const double limit_m = depth_m[static_cast<std::size_t>(bottom)] + kStripDepth_m;
  while (top > grid.rows() * 6 / 10 && depth_m[static_cast<std::size_t>(top - 1)] < limit_m) --top;
  top = std::min(top, bottom - grid.rows() / 12);
  sample(grid, spans, bottom, top);
  if (sample_count_ < kColumns * kRows / 4) return Verdict::no_pattern;
  if (glaring_ * 10 > sample_count_ * 6) return Verdict::glaring;
  find_hanging();
  if (!choose_floor()) return Verdict::no_pattern;
  if (main_look_.light < kDarkest) return Verdict::dark;
  measure_texture(grid, bottom, top);
  return Verdict::floor;
}

void FloorStudy::teach(FloorLooks& looks) const {
  for (int i = 0; i < kColumns; ++i) {
    for (int j = 0; j < heights_[static_cast<std::size_t>(i)]; ++j) {
      const Sample& s = samples_[static_cast<std::size_t>(i * kRows + j)];
      if (s.group == kNoGroup || !groups_[static_cast<std::size_t>(s.group)].floor) continue;
      looks.add(s.look, kWeightOfASample);
    }
  }
}

double FloorStudy::share_known(const FloorLooks& looks) const {
  int known = 0;
  for (int i = 0; i < kColumns; ++i) {
    for (int j = 0; j < heights_[static_cast<std::size_t>(i)]; ++j) {
      known += looks.knows(samples_[static_cast<std::size_t>(i * kRows + j)].look);
    }
  }
  return sample_count_ == 0 ? 0 : static_cast<double>(known) / sample_count_;
}

}  // namespace mirada::vision
