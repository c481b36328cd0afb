#pragma once
#include <array>
#include <vector>

#include "vision/floor_lights.h"
#include "vision/floor_looks.h"
#include "vision/look_follower.h"
#include "vision/picture_grid.h"
#include "vision/tone_watch.h"

namespace mirada::vision {

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
  /// Something of another look that was taken for a part of the floor: shade, a patch of sun, a tile. What
  /// stands upright is none; that only the neighbouring columns tell.
  struct Crossing {
    int from_row = 0;       ///< the lowest row that is not the floor below
    int to_row = 0;         ///< the first row above it
    float upright_m = 0;    ///< how high it is if it stands upright
    bool doubtful = false;  ///< by itself it looks like a thing
    bool flat = false;      ///< it lies on the floor, say its sides
    bool patch = false;     ///< not the floor's own colour in another light
    bool large = false;     ///< too large to be passed unless it clearly lies flat
  };
  static constexpr int kMostCrossings = 8;

  End end = End::nothing;
  double row = 0;        ///< where the floor ends, sub-pixel; half rows lie between two cells
  double sigma_row = 1;  ///< in grid rows
  int stop = -1;         ///< the crossing that turned out to be a thing
  double low_row = -1;   ///< the row before narrow spots gave way to what stands beside; -1: no end low down
  int crossing_count = 0;
  std::array<Crossing, kMostCrossings> crossings{};
};

/// Where a column is below and above the horizon, in rows; fixed by the neck's position.
struct ColumnSpan {
  int bottom_row = -1;   ///< the lowest usable row; -1: none
  int top_row = 0;       ///< the highest usable row
  int horizon_row = -1;  ///< the lowest row whose ray does not go down; -1: even the top row goes down
};

/// What the rows of the grid mean on the floor; fixed by the neck's position.
struct RowScale {
  std::vector<double> depth_m;  ///< ahead of the lens, for every grid row; huge at and above the horizon
  int coarse_row = 10'000;      ///< below this row, every second one is enough
  double height_m = 0.2;        ///< the lens's
  double focal_cells = 66;      ///< focal length in grid columns
};

struct ScanSettings {
  bool lines_are_obstacles = false;
  /// The floor is known from earlier pictures and the robot may be driving: what stands near and could be a
  /// thing is one. A picture that stands alone is judged by what is likelier.
  bool careful = false;
};

constexpr double kCareful_m = 1.0;  ///< so near that doubt is dangerous

/// Walks up one column from the look that the floor has at its foot, and finds where the floor ends. The look
/// is followed as it drifts with the light; looks that `looks` knows are floor too. What interrupts it is
/// judged: joints, painted lines and shade are crossed, the rest is an obstacle.
class ColumnScan {
 public:
  ColumnScan(const PictureGrid& grid, const FloorLooks& looks, const FloorLights& lights,
             const FloorTones& tones, const RowScale& scale)
      : grid_(grid), looks_(looks), lights_(lights), tones_(tones), scale_(scale) {}

  /// `home` is the main look of the floor where `looks` was learnt.
  void prepare(const FloorTexture& texture, const Look& home, const ScanSettings& settings);
  ColumnResult run(int column, const ColumnSpan& span, const Look& start);
  /// The answer for a column where the floor ends below `row`; what was crossed before stays known.
  ColumnResult ends_at(int column, int row, const ColumnSpan& span, const ColumnResult& before) const;
  /// Whether what could be a thing at `row` has to be taken for one.
  bool is_careful_at(int row) const {
    return settings_.careful && scale_.depth_m[static_cast<std::size_t>(std::max(row, 0))] < kCareful_m;
  }
  /// The floor has a colour: what looks like it beyond something is hardly anything else. Grey is
  /// everything's colour in some light.
  bool is_colourful() const { return is_colourful_; }
  int columns() const { return grid_.columns(); }
  /// How much of the rows shows a change from one column to another.
  double change_between(int column, int other, int from_row, int to_row) const;
  /// Whether the same rows of two columns are clearly of two colours.
  bool differ_in_colour(int column, int other, int from_row, int to_row) const;
  /// Whether the rows of a column look like a mixture of the same rows of two others.
  bool lies_between(int column, int one, int other, int from_row, int to_row) const;
  /// Whether what stands in `strip_rows` above `foot_row` goes on up in another column, as high as a wall.
  bool goes_up_beside(int column, int other, int foot_row, int strip_rows) const;
  /// The floor's look at the column's foot as followed by the last run(), to start its neighbour with.
  const Look& foot() const { return foot_; }

 private:
  /// What became of an interruption: the floor goes on above `row`, or it has ended at `row`.
  struct Verdict {
    bool floor_goes_on;
    int row;
  };
  /// Known looks are compared in the light that there is here: as much brighter or darker as the main look
  /// has become.
  bool is_known(const Look& look) const {
    return looks_.knows({look.light + home_light_ - floor_.look().light, look.red, look.blue});
  }
  bool is_floor(const Look& look) const { return floor_.oddness(look, tolerance_) == 0 || is_known(look); }
  /// The same on a surface that is `lighter` than the floor by so much.
  bool is_on(const LookFollower& surface, int lighter, const Look& look) const {
    return surface.oddness(look, tolerance_) == 0 || is_known({look.light - lighter, look.red, look.blue});
  }
  bool has_other_tone(int column, int begin, int row) const;
  bool is_shade_of(const Eigen::Vector3d& floor_bgr, const Eigen::Vector3d& bgr, bool careful) const;
  /// Means over rows of a column.
  Eigen::Vector3d mean_colour(int column, int from, int to) const;
  bool is_as_rough_as_floor(int column, int from, int to, bool unless_told) const;
  Look mean_look(int column, int from, int to) const;
  int begin_of_odd(int column, int first_odd, int row) const;
  Verdict judge(int column, int row, int top);
  struct Surface {
    LookFollower look;
    int lighter;  ///< than the floor, in Look units
  };
  struct Limits {
    double width_m;     ///< at most so deep on the floor
    double obstacle_m;  ///< less than so high if it stood upright
    int floor_rows;     ///< of floor beyond it
  };
  static const Limits kJoint, kPatch, kTile;
  int end_of_joint(int column, int row, int top, const Surface* surface, const Limits& limits) const;
  double as_obstacle_m(int from_row, int to_row) const;
  bool cross(int from_row, int to_row, bool doubtful, bool patch, bool large = false);
  Verdict judge_line(int column, int row, int top);
  Verdict judge_shade(int column, int row, int top);
  int end_of_surface(int column, int row, int top, Surface surface) const;
  int end_of_ramp(int column, int row, int top) const;
  bool is_band(int column, int from_row, int to_row) const;
  struct Width {
    int cells;
    bool whole;  ///< floor on both sides; false: cut off by the picture's side
  };
  Width width_at(int column, int row, int limit) const;
  ColumnResult from_above(int column, const ColumnSpan& span, int top) const;
  ColumnResult with_crossings(ColumnResult result) const;
  ColumnResult refined(int column, int row, const ColumnSpan& span) const;

  const PictureGrid& grid_;
  const FloorLooks& looks_;
  const FloorLights& lights_;
  const FloorTones& tones_;
  const RowScale& scale_;
  ScanSettings settings_;
  FloorTexture texture_;
  Tolerance tolerance_;
  LookFollower floor_;
  ToneWatch tone_;
  bool is_colourful_ = false;
  bool is_vivid_ = false;  ///< so colourful that nothing else shares its colour by chance
  int home_light_ = 0;
  int brightest_ = 0;  ///< of the floor in this column so far
  ColumnResult crossed_;
  Look foot_;
};

}  // namespace mirada::vision
