#include "vision/floor_study.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace mirada::vision {
namespace {

constexpr int kAlikeLight = 12;
constexpr int kAlikeColour = 9;
constexpr int kDarkest = 34;  // Look units: about 8 of 255
constexpr int kGlare = 253;   // of 255, in every channel
constexpr double kStripDepth_m = 0.15;
constexpr int kWeightOfASample = 12;

bool same(const Look& a, const Look& b) {
  return std::abs(a.light - b.light) <= kAlikeLight && std::abs(a.red - b.red) <= kAlikeColour &&
         std::abs(a.blue - b.blue) <= kAlikeColour;
}

}  // namespace

int FloorStudy::group_of(const Look& look) {
  for (int i = 0; i < group_count_; ++i) {
    Group& group = groups_[static_cast<std::size_t>(i)];
    const Look mean{group.light_sum / group.size, group.red_sum / group.size, group.blue_sum / group.size};
    if (same(mean, look)) return i;
  }
  if (group_count_ == kGroups) return kNoGroup;
  groups_[static_cast<std::size_t>(group_count_)] = Group{};
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

bool FloorStudy::counts(int group) const {
  return group != kNoGroup && groups_[static_cast<std::size_t>(group)].size * 25 >= sample_count_;
}

/// Which groups begin columns. Rare looks are looked through.
void FloorStudy::find_feet() {
  for (int i = 0; i < kColumns; ++i) {
    const Sample* column = &samples_[static_cast<std::size_t>(i * kRows)];
    const Sample* const end = column + heights_[static_cast<std::size_t>(i)];
    column = std::find_if(column, end, [&](const Sample& sample) { return counts(sample.group); });
    if (column != end) ++groups_[static_cast<std::size_t>(column->group)].foot_columns;
  }
}

/// What begins no column may be a wall: whatever lies between parts of it, or gives way to it, can be a part
/// of the wall, too.
bool FloorStudy::has_feet(int group) const {
  return groups_[static_cast<std::size_t>(group)].foot_columns >= kColumns / 8;
}

/// Which groups give way to another one, and which stand between two parts of one other.
void FloorStudy::look_along_columns() {
  for (int i = 0; i < kColumns; ++i) {
    const Sample* column = &samples_[static_cast<std::size_t>(i * kRows)];
    std::array<bool, kGroups> inner{};
    int first_group = kNoGroup;
    int before = kNoGroup;
    int now = kNoGroup;
    for (int j = 0; j < heights_[static_cast<std::size_t>(i)]; ++j) {
      const int group = column[j].group;
      if (!counts(group) || group == now) continue;
      if (now == kNoGroup) {
        first_group = group;
      } else if (now == first_group && before == kNoGroup && has_feet(group)) {
        ++groups_[static_cast<std::size_t>(first_group)].ended_columns;
      }
      if (now != kNoGroup && group == before && has_feet(group)) inner[static_cast<std::size_t>(now)] = true;
      before = now;
      now = group;
    }
    for (std::size_t g = 0; g < kGroups; ++g) groups_[g].inner_columns += inner[g];
  }
}

/// Which groups come again beside another one.
void FloorStudy::look_along_rows() {
  for (int j = 0; j < kRows; ++j) {
    std::array<int, kGroups> parts{};
    std::array<bool, kGroups> seen_since{};
    int before = kNoGroup;
    for (int i = 0; i < kColumns; ++i) {
      if (j >= heights_[static_cast<std::size_t>(i)]) continue;
      const int group = samples_[static_cast<std::size_t>(i * kRows + j)].group;
      if (!counts(group) || group == before) continue;
      const auto g = static_cast<std::size_t>(group);
      if (parts[g] == 0 || seen_since[g]) ++parts[g];
      seen_since[g] = false;
      if (has_feet(group)) seen_since.fill(true), seen_since[g] = false;
      before = group;
    }
    for (std::size_t g = 0; g < kGroups; ++g) groups_[g].parted_rows += parts[g] > 1;
  }
}

bool FloorStudy::choose_floor() {
  int grouped = 0;
  Group* main = nullptr;
  for (int i = 0; i < group_count_; ++i) {
    Group& group = groups_[static_cast<std::size_t>(i)];
    if (!counts(i)) continue;
    grouped += group.size;
    const bool low = has_feet(i) && group.ended_columns * 5 >= group.foot_columns * 3;
    group.floor = low || group.inner_columns >= kColumns / 8 || group.parted_rows >= kRows / 4;
    if (group.foot_columns >= kColumns / 4 && (!main || group.size > main->size)) main = &group;
  }
  if (!main || main->size * 5 < sample_count_ || grouped * 5 < sample_count_ * 3) return false;
  main->floor = true;
  main_look_ = {main->light_sum / main->size, main->red_sum / main->size, main->blue_sum / main->size};
  return true;
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
  find_feet();
  look_along_columns();
  look_along_rows();
  if (!choose_floor()) return Verdict::no_pattern;
  if (main_look_.light < kDarkest) return Verdict::dark;
  measure_texture(grid, bottom, top);
  return Verdict::floor;
}

void FloorStudy::expose(int light) {
  main_look_.light -= light;
  for (Sample& sample : samples_) sample.look.light -= light;
  for (Group& group : groups_) group.light_sum -= light * group.size;
}

void FloorStudy::teach(FloorLooks& looks) const {
  for (int i = 0; i < kColumns; ++i) {
    for (int j = 0; j < heights_[static_cast<std::size_t>(i)]; ++j) {
      const Sample& s = samples_[static_cast<std::size_t>(i * kRows + j)];
      if (s.group == kNoGroup || !groups_[static_cast<std::size_t>(s.group)].floor) continue;
      looks.add(s.look, kWeightOfASample);
    }
  }
  teach_mixtures(looks);
}

/// The colours of a column's samples that follow one another in one group, smoothed.
void FloorStudy::teach(FloorTones& tones) const {
  constexpr int kMean = 4;
  for (int i = 0; i < kColumns; ++i) {
    Look sum{0, 0, 0};
    int n = 0;
    for (int j = 0; j < heights_[static_cast<std::size_t>(i)]; ++j) {
      const Sample& s = samples_[static_cast<std::size_t>(i * kRows + j)];
      const bool floor = s.group != kNoGroup && groups_[static_cast<std::size_t>(s.group)].floor;
      const bool same = j > 0 && samples_[static_cast<std::size_t>(i * kRows + j - 1)].group == s.group;
      if (!floor || !same) sum = {0, 0, 0}, n = 0;
      if (!floor) continue;
      sum = {sum.light + s.look.light, sum.red + s.look.red, sum.blue + s.look.blue};
      if (++n < kMean) continue;
      tones.add({sum.light / n, sum.red / n, sum.blue / n}, kWeightOfASample);
      sum = {0, 0, 0}, n = 0;
    }
  }
}

/// Far away a pattern's colours run into each other.
void FloorStudy::teach_mixtures(FloorLooks& looks) const {
  const auto mean = [](const Group& g) {
    return Look{g.light_sum / g.size, g.red_sum / g.size, g.blue_sum / g.size};
  };
  for (int i = 0; i < group_count_; ++i) {
    for (int j = 0; j < i; ++j) {
      const Group& a = groups_[static_cast<std::size_t>(i)];
      const Group& b = groups_[static_cast<std::size_t>(j)];
      if (!a.floor || !b.floor) continue;
      const Look from = mean(a);
      const Look to = mean(b);
      const auto mixed = [](int x, int y, int part) { return x + (y - x) * part / 8; };
      for (int part = 1; part < 8; ++part) {
        looks.add({mixed(from.light, to.light, part), mixed(from.red, to.red, part),
                   mixed(from.blue, to.blue, part)},
                  5 * kWeightOfASample);
      }
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
