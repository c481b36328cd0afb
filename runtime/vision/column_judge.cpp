#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "vision/column_scan.h"

// What interrupts the floor on the way up a column: a joint, a painted line, shade - or an obstacle.

namespace mirada::vision {
namespace {

constexpr int kAlarm = 6;
constexpr int kFloorIsBack = 5;  // rows of floor after an interruption
constexpr double kWidestLine_m = 0.12;
constexpr int kFirstLineRows = 5;    // show how wide a line is
constexpr int kLineRows = 10;        // a line running away from the robot is at least so long
constexpr double kDeepestShade = 3;  // the factor of a channel, as encoded
constexpr int kLongestRamp = 18;     // rows of a shadow's soft rim
constexpr int kSurfaceRows = 8;
constexpr int kCrispRows = 4;
constexpr double kRough = 4;            // Look units: a floor with a pattern
constexpr double kPatternSeen_m = 1.0;  // farther away patterns blur
constexpr double kSameColourCareful = 0.05;
constexpr double kMostNoise = 0.1;
constexpr double kSameColour = 0.08;  // by which the channels' factors may differ
constexpr int kSameLight = 14;        // Look units: lit floor before and behind a shadow
constexpr double kColourNoise = 1.5;  // of 255, of a mean
constexpr double kSkirting_m = 0.13;
constexpr int kMostJoints = 8;  // crossed on one shaded surface

/// Shade takes the gloss from a floor too: the same colour, darker and with less white in it.
bool is_dull_shade(const Eigen::Vector3d& floor_bgr, const Eigen::Vector3d& bgr) {
  const double floor_light = floor_bgr.mean();
  const Eigen::Vector3d colour = floor_bgr.array() - floor_light;
  constexpr double kColourful = 8;
  constexpr double kMostGloss = 0.3;
  if (colour.norm() < kColourful || bgr.mean() > floor_light) return false;
  const Eigen::Vector3d seen = bgr.array() - bgr.mean();
  const double factor = colour.dot(seen) / colour.squaredNorm();
  const double gloss = factor * floor_light - bgr.mean();
  return factor > 1 / kDeepestShade && factor < 1.3 && gloss > 0 && gloss < kMostGloss * floor_light &&
         (seen - factor * colour).norm() < 1 + 0.03 * bgr.mean();
}

}  // namespace

const ColumnScan::Limits ColumnScan::kJoint{kWidestLine_m, 0.035, kFloorIsBack};
const ColumnScan::Limits ColumnScan::kPatch{0.5, 0.075, 8};
const ColumnScan::Limits ColumnScan::kTile{0.9, 0.14, 8};

/// The same colour in another light: all three channels have changed by the same factor.
bool ColumnScan::is_shade_of(const Eigen::Vector3d& floor_bgr, const Eigen::Vector3d& bgr,
                             bool careful) const {
  if (!careful && is_dull_shade(floor_bgr, bgr)) return true;
  const Eigen::Array3d factor = bgr.array().max(1) / floor_bgr.array().max(1);
  const double darkest = std::max(1.0, std::min(bgr.minCoeff(), floor_bgr.minCoeff()));
  const double slack = careful ? kSameColourCareful + kColourNoise / darkest
                               : kSameColour + std::min(kMostNoise, kColourNoise / darkest);
  return factor.maxCoeff() <= factor.minCoeff() * (1 + slack) && factor.maxCoeff() < kDeepestShade &&
         factor.minCoeff() > 1 / kDeepestShade;
}

/// Shade keeps the floor's pattern; a board or a box in the floor's colour is smooth on a rough floor.
bool ColumnScan::is_as_rough_as_floor(int column, int from, int to, bool unless_told) const {
  if (texture_.light_sigma < kRough || from - to < kSurfaceRows) return unless_told;
  int sum = 0;
  int n = 0;
  for (int r = from; r - 3 >= to; --r, ++n)
    sum += std::abs(grid_.look(column, r).light - grid_.look(column, r - 3).light);
  if (n == 0 || 0.886 * sum / n > 0.3 * texture_.light_sigma) return true;
  const bool far = scale_.depth_m[static_cast<std::size_t>(from)] > kPatternSeen_m;
  return far && unless_told;
}

/// The row from which the floor, or the `surface` it has turned into, goes on after an interruption at `row`
/// too short to be an obstacle, or -1.
int ColumnScan::end_of_joint(int column, int row, int top, const Surface* surface,
                             const Limits& limits) const {
  const double from_m = scale_.depth_m[static_cast<std::size_t>(row)];
  int floor_rows = 0;
  for (int r = row; r >= top; --r) {
    const double to_m = scale_.depth_m[static_cast<std::size_t>(r)];
    const Look look = grid_.look(column, r);
    const bool floor = is_floor(look) || (surface && is_on(surface->look, surface->lighter, look));
    floor_rows = floor ? floor_rows + 1 : 0;
    if (floor_rows == 0) {
      const double upright_m = scale_.height_m * (1 - from_m / to_m);
      if (to_m - from_m > limits.width_m || upright_m > limits.obstacle_m) return -1;
    }
    if (floor_rows >= limits.floor_rows) return r;
  }
  return -1;
}

/// How many cells side by side are not floor round this one, in its row; 0 when it is floor. Counts to
/// `limit` and one more.
ColumnScan::Width ColumnScan::width_at(int column, int row, int limit) const {
  if (is_floor(grid_.look(column, row))) return {0, true};
  int left = column;
  int right = column;
  const auto shown = [&](int at) { return at >= 0 && at < grid_.columns() && grid_.sees(at, row); };
  while (shown(left - 1) && column - left <= limit && !is_floor(grid_.look(left - 1, row))) --left;
  while (shown(right + 1) && right - left <= limit && !is_floor(grid_.look(right + 1, row))) ++right;
  return {right - left + 1, shown(left - 1) && shown(right + 1)};
}

/// A line that runs away from the robot keeps its width on the floor, so it narrows in the picture; a post
/// keeps its width in the picture, and a box's corner widens. Where a line ends at something wide, that
/// begins there.
ColumnScan::Verdict ColumnScan::judge_line(int column, int row, int top) {
  const Verdict obstacle{false, row};
  const double from_m = scale_.depth_m[static_cast<std::size_t>(row)];
  const int start = std::max(row - 1, top);
  int widest = 1;
  int newest = 1;
  int wide_row = -1;
  int floor_rows = 0;
  for (int r = start; r >= top; --r) {
    const double depth_m = scale_.depth_m[static_cast<std::size_t>(r)];
    const int limit = std::max(1, static_cast<int>(kWidestLine_m * scale_.focal_cells / depth_m));
    const Width width = width_at(column, r, limit);
    floor_rows = width.cells == 0 ? floor_rows + 1 : 0;
    if (floor_rows >= kFloorIsBack) {
      cross(row, r + kFloorIsBack, false, true);
      return {true, r};
    }
    if (width.cells == 0) continue;
    if (start - r < kFirstLineRows) widest = std::max(widest, width.cells);
    const bool too_wide = width.cells > limit;
    if (too_wide && start - r < kFirstLineRows) return obstacle;
    if (too_wide || width.cells > widest + 1) {
      if (wide_row < 0) wide_row = r;
      // Another line across is passed; something wide stays wide.
      const double wide_from_m = scale_.depth_m[static_cast<std::size_t>(wide_row)];
      if (depth_m - wide_from_m <= kWidestLine_m) continue;
      const bool was_line = start - wide_row >= kLineRows && newest <= widest && wide_from_m > 1.15 * from_m;
      if (!was_line) return obstacle;
      cross(row, wide_row, false, true);
      return {false, wide_row};
    }
    wide_row = -1;
    if (width.cells >= widest && depth_m > (1.5 + 1.0 / widest) * from_m) return obstacle;
    if (!width.whole && depth_m > 1.3 * from_m) return obstacle;
    newest = width.cells;
  }
  return obstacle;
}

/// Past the soft rim of a shadow: where the look stops changing from row to row.
int ColumnScan::end_of_ramp(int column, int row, int top) const {
  const int last = std::max(top, row - kLongestRamp);
  int r = row;
  while (r - 3 > last) {
    const int step = std::abs(grid_.look(column, r).light - grid_.look(column, r - 3).light);
    if (step <= tolerance_.light) break;
    r -= 2;
  }
  return r;
}

/// The first row above `row` that no longer looks like the surface there, or `top` - 1 when it goes on to the
/// top.
int ColumnScan::end_of_surface(int column, int row, int top, Surface surface) const {
  int evidence = 0;
  int first_odd = row;
  for (int r = row; r >= top; --r) {
    const Look look = grid_.look(column, r);
    const int odd = surface.look.oddness(look, tolerance_);
    if (odd == 0 || is_on(surface.look, surface.lighter, look)) {
      evidence = std::max(0, evidence - 1);
      if (odd == 0) surface.look.follow(look, 4);
      continue;
    }
    if (evidence == 0) first_odd = r;
    evidence += odd;
    if (evidence >= kAlarm) return first_odd;
  }
  return top - 1;
}

/// The floor's colour in another light. Shade on the floor is one even surface that gives way below the
/// horizon to lit floor or to a thing of another colour. A thing that happens to have the floor's colour goes
/// on above the horizon, or shows its top in a third light.
ColumnScan::Verdict ColumnScan::judge_shade(int column, int row, int top) {
  const Verdict obstacle{false, row};
  const bool careful = is_careful_at(row);
  const int settled = end_of_ramp(column, row, top);
  if (settled - kSurfaceRows < top) return obstacle;
  const Look shade = mean_look(column, settled - kSurfaceRows + 1, settled);
  const int foot = std::min(row + 1 + kSurfaceRows, grid_.rows() - 1);
  const Look floor = foot > row + 3 ? mean_look(column, row + 2, foot) : floor_.look();
  const Eigen::Vector3d floor_bgr =
      foot > row + 3 ? mean_colour(column, row + 2, foot) : grid_.colour_shown(floor);
  const bool known_light = lights_.is_change(floor, shade);
  if (!known_light &&
      !is_shade_of(floor_bgr, mean_colour(column, settled - kSurfaceRows + 1, settled), careful))
    return obstacle;
  Surface surface{.look = {}, .lighter = shade.light - floor.light};
  surface.look.start(shade);
  int end = end_of_surface(column, settled, top, surface);
  for (int joints = 0; end >= top && joints < kMostJoints; ++joints) {
    const int back = end_of_joint(column, end, top, &surface, kJoint);
    if (back < 0) break;
    if (is_floor(mean_look(column, back, back + kFloorIsBack - 1))) {
      cross(row, end, false, false);
      return {true, back};
    }
    end = end_of_surface(column, back, top, surface);
  }
  if (end < top) return obstacle;
  const int beyond = end_of_ramp(column, end, top);
  const Look next = mean_look(column, beyond - kSurfaceRows + 1, beyond);
  const Eigen::Vector3d next_bgr = mean_colour(column, beyond - kSurfaceRows + 1, beyond);
  const bool as_lit = next.light >= floor.light - kSameLight && next.light <= brightest_ + kSameLight;
  const bool lit_again = as_lit && is_shade_of(floor_bgr, next_bgr, careful);
  if (lit_again) floor_.start(next);
  if (lit_again || is_floor(next)) {
    cross(row, end, false, false);
    return {true, beyond};
  }
  if (known_light) {
    cross(row, end, false, false);
    return {false, end};
  }
  // No shade is lighter than the floor has been in this column, but a skirting board is, and a darker one may
  // share the colour of a floor that has hardly any; a deeper band is lit floor beyond the shade.
  const bool lighter = shade.light > std::max(floor.light, brightest_);
  const bool as_board = (lighter || (!careful && !is_vivid_)) && as_obstacle_m(row, end) < kSkirting_m;
  const bool crisp = row - settled < kCrispRows;
  const bool doubtful = !is_as_rough_as_floor(column, settled, end + 1, !as_board && (careful || !crisp));
  if (careful && doubtful) return obstacle;
  if (is_shade_of(floor_bgr, next_bgr, careful)) {
    surface.look.start(next);
    surface.lighter = next.light - floor_.look().light;
    const bool tall = end_of_surface(column, beyond, top, surface) < top;
    if (!tall) return obstacle;
  }
  cross(row, end, doubtful, false);
  return {false, end};
}

/// A painted line that is crossed aslant: no wider on the floor than lines are, whatever its depth along the
/// column.
bool ColumnScan::is_band(int column, int from_row, int to_row) const {
  const int middle = (from_row + to_row) / 2;
  const auto depth_m = [&](int row) { return scale_.depth_m[static_cast<std::size_t>(std::max(row, 0))]; };
  const double deep_m = depth_m(to_row) - depth_m(from_row);
  if (deep_m <= kWidestLine_m) return true;
  const double cell_m = depth_m(middle) / scale_.focal_cells;
  const Width width = width_at(column, middle, static_cast<int>(3 * kWidestLine_m / cell_m));
  const double wide_m = width.cells * cell_m;
  return width.whole && deep_m * wide_m <= kWidestLine_m * std::hypot(deep_m, wide_m);
}

ColumnScan::Verdict ColumnScan::judge(int column, int row, int top) {
  if (settings_.lines_are_obstacles) return judge_shade(column, row, top);
  const int back = end_of_joint(column, row, top, nullptr, kJoint);
  if (back >= 0) {
    cross(row, back + kFloorIsBack, false, true);
    return {true, back};
  }
  const bool careful = is_careful_at(row);
  const int beyond = end_of_joint(column, row, top, nullptr, kPatch);
  if (beyond >= 0 && (!careful || is_band(column, row, beyond + kPatch.floor_rows))) {
    const int end = beyond + kPatch.floor_rows;
    const bool smooth = !is_as_rough_as_floor(column, row - 1, end + 1, true);
    const bool shade =
        is_shade_of(mean_colour(column, row + 2, row + 8), mean_colour(column, end + 1, row - 1), false);
    if (cross(row, end, smooth, !shade)) return {true, beyond};
  }
  const Verdict shade = judge_shade(column, row, top);
  if (shade.floor_goes_on || shade.row != row) return shade;
  const Verdict line = judge_line(column, row, top);
  if (line.floor_goes_on || line.row != row || careful) return line;
  const int tile = end_of_joint(column, row, top, nullptr, kTile);
  if (tile < 0) return line;
  const bool judged_later = cross(row, tile + kTile.floor_rows, true, true, true);
  return judged_later ? Verdict{true, tile} : line;
}

}  // namespace mirada::vision
