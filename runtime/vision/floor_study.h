#pragma once
#include <array>
#include <vector>

#include "vision/column_scan.h"
#include "vision/floor_looks.h"
#include "vision/picture_grid.h"

namespace mirada::vision {

/// What the strip of picture right before the robot looks like: a few groups of looks, and which of them can
/// be floor. A group that only stands in the strip's upper part and never gives way to the floor again is an
/// obstacle's.
class FloorStudy {
 public:
  enum class Verdict { floor, dark, glaring, no_pattern };

  /// Studies the strip from the picture's foot to about `strip_depth_m` beyond the nearest visible floor.
  Verdict run(const PictureGrid& grid, const std::vector<ColumnSpan>& spans,
              const std::vector<double>& depth_m);

  /// The strip as seen in a picture exposed darker by so many units of light.
  void expose(int light);
  /// The look that most of the strip has.
  const Look& main_look() const { return main_look_; }
  const FloorTexture& texture() const { return texture_; }
  /// Puts the looks that can be floor into `looks`.
  void teach(FloorLooks& looks) const;
  /// The same of its smoothed colours.
  void teach(FloorTones& tones) const;
  /// How much of the strip `looks` knows, 0..1.
  double share_known(const FloorLooks& looks) const;

 private:
  static constexpr int kColumns = 24;
  static constexpr int kRows = 16;
  static constexpr int kGroups = 10;
  static constexpr int kNoGroup = -1;
  struct Group {
    int light_sum = 0, red_sum = 0, blue_sum = 0;
    int size = 0;
    int foot_columns = 0;   ///< columns that it begins
    int ended_columns = 0;  ///< columns that it begins and another one with feet goes on with
    int inner_columns = 0;  ///< columns where it lies between two parts of another one with feet
    int parted_rows = 0;    ///< rows where one with feet lies between two parts of it
    bool floor = false;
  };
  struct Sample {
    Look look;
    int group = kNoGroup;
  };

  void sample(const PictureGrid& grid, const std::vector<ColumnSpan>& spans, int bottom, int top);
  int group_of(const Look& look);
  bool counts(int group) const;
  void find_feet();
  bool has_feet(int group) const;
  void look_along_columns();
  void look_along_rows();
  void teach_mixtures(FloorLooks& looks) const;
  bool choose_floor();
  void measure_texture(const PictureGrid& grid, int bottom, int top);

  std::array<Sample, static_cast<std::size_t>(kColumns* kRows)>
      samples_;                          ///< column by column, bottom to top
  std::array<int, kColumns> heights_{};  ///< samples in each column
  std::array<Group, kGroups> groups_;
  int group_count_ = 0;
  int sample_count_ = 0;
  int glaring_ = 0;
  Look main_look_;
  FloorTexture texture_;
};

}  // namespace mirada::vision
