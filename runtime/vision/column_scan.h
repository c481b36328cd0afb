#pragma once
#include <vector>

#include "vision/floor_looks.h"
#include "vision/picture_grid.h"

namespace mirada::vision {

/// How much the floor's look wanders from one place to the next, in Look units (1 sigma); learnt from the
/// picture.
struct FloorTexture {
  double light_sigma = 3;
  double colour_sigma = 2;
};

/// What one column of the grid says, bottom to top.
struct ColumnResult {
  enum class End {
    boundary,         ///< the floor ends at `row`
    not_floor_below,  ///< the lowest usable cell is already not floor
    floor_to_top,     ///< floor up to the picture's edge or the horizon
    through_horizon,  ///< the floor's look goes on above the horizon: it cannot be the floor's alone
    above_horizon,    ///< no cell lies below the horizon
    nothing           ///< no usable cell
  };
  End end = End::nothing;
  double row = 0;        ///< where the floor ends, sub-pixel; half rows lie between two cells
  double sigma_row = 1;  ///< in grid rows
};

/// Where a column is below and above the horizon, in rows; fixed by the neck's position.
struct ColumnSpan {
  int bottom_row = -1;   ///< the lowest usable row; -1: none
  int horizon_row = -1;  ///< the lowest row whose ray does not go down; -1: even the top row goes down
};

struct ScanSettings {
  bool lines_are_obstacles = false;
  double camera_height_m = 0.2;
};

/// Walks up one column from the look that the floor has at its foot, and finds where the floor ends. The look
/// is followed as it drifts with the light; looks that `looks` knows are floor too; short interruptions after
/// which the floor comes back (joints, painted lines) are crossed. `depth_m` is the floor's distance ahead of
/// the lens for every grid row.
class ColumnScan {
 public:
  ColumnScan(const PictureGrid& grid, const FloorLooks& looks, const std::vector<double>& depth_m)
      : grid_(grid), looks_(looks), depth_m_(depth_m) {}

  void prepare(const FloorTexture& texture, const ScanSettings& settings);
  ColumnResult run(int column, const ColumnSpan& span, const Look& start);
  /// The floor's look at the column's foot as followed by the last run(), to start its neighbour with.
  const Look& foot() const { return foot_; }

 private:
  enum class Match { followed, known, odd, very_odd };
  Match match(const Look& look) const;
  void follow(const Look& look, int slowness);
  ColumnResult refined(int column, int row, const ColumnSpan& span) const;
  int row_where_floor_is_back(int column, int row, int top) const;

  const PictureGrid& grid_;
  const FloorLooks& looks_;
  const std::vector<double>& depth_m_;
  ScanSettings settings_;
  int light_tolerance_ = 10;
  int colour_tolerance_ = 6;
  int light_16_ = 0, red_16_ = 0, blue_16_ = 0;  ///< the look followed, times 16
  Look foot_;
};

}  // namespace mirada::vision
