#include "vision/column_scan.h"

#include <algorithm>
#include <cmath>

namespace mirada::vision {
namespace {

constexpr int kWalkAlarm = 6;        // evidence for "not floor" that stops the walk
constexpr int kRowsPastHorizon = 6;  // the floor's look so far above the horizon is no floor
constexpr int kFootRows = 12;
constexpr double kToneSigmas = 0.8;  // of a cell, a smoothed look's colour may wander
constexpr int kToneLeast = 2;
constexpr int kToneMost = 12;
constexpr int kFloorShows = 4;  // rows that tell the light at a column's foot

}  // namespace

void ColumnScan::prepare(const FloorTexture& texture, const Look& home, const ScanSettings& settings) {
  home_light_ = home.light;
  is_colourful_ = has_colour(home);
  is_vivid_ = has_colour(home, 2);
  settings_ = settings;
  texture_ = texture;
  tolerance_.light = std::clamp(static_cast<int>(std::lround(3.2 * texture.light_sigma)), 5, 24);
  tolerance_.colour = std::clamp(static_cast<int>(std::lround(3.2 * texture.colour_sigma)), 4, 16);
}

Look ColumnScan::mean_look(int column, int from, int to) const {
  Look sum{0, 0, 0};
  int n = 0;
  for (int row = std::max(from, 0); row <= std::min(to, grid_.rows() - 1); ++row, ++n) {
    const Look look = grid_.look(column, row);
    sum = {sum.light + look.light, sum.red + look.red, sum.blue + look.blue};
  }
  n = std::max(n, 1);
  return {sum.light / n, sum.red / n, sum.blue / n};
}

Eigen::Vector3d ColumnScan::mean_colour(int column, int from, int to) const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int n = 0;
  for (int row = std::max(from, 0); row <= std::min(to, grid_.rows() - 1); ++row, ++n) {
    const auto bgr = grid_.colour(column, row);
    sum += Eigen::Vector3d(bgr[0], bgr[1], bgr[2]);
  }
  return sum / std::max(n, 1);
}

ColumnResult ColumnScan::run(int column, const ColumnSpan& span, const Look& start) {
  floor_.start(start);
  foot_ = start;
  brightest_ = std::max({start.light, home_light_, lights_.brightest()});
  crossed_.crossing_count = 0;
  if (span.bottom_row < 0) return {};
  if (span.horizon_row >= span.bottom_row) return {.end = ColumnResult::End::above_horizon};
  const int top = std::max(span.top_row, span.horizon_row - kRowsPastHorizon);
  const Look foot = mean_look(column, span.bottom_row - kFloorShows + 1, span.bottom_row);
  if (!is_floor(foot)) {
    if (lights_.of(foot)) floor_.start(foot), foot_ = foot;
  }
  int evidence = 0;
  int first_odd = span.bottom_row;
  tone_.start(foot_);
  const int tone_tolerance =
      std::clamp(static_cast<int>(std::lround(kToneSigmas * texture_.colour_sigma)), kToneLeast, kToneMost);
  for (int row = span.bottom_row; row >= top; row -= row > scale_.coarse_row ? 2 : 1) {
    const Look look = grid_.look(column, row);
    const int begin = tone_.see(look, row, tone_tolerance);
    if (begin >= 0 && !is_vivid_ && has_other_tone(column, std::min(begin, span.bottom_row), row)) {
      return with_crossings(refined(column, begin, span));
    }
    const int odd = floor_.oddness(look, tolerance_);
    if (odd == 0 || is_known(look)) {
      evidence = std::max(0, evidence - 1);
      if (odd == 0) floor_.follow(look, 4);
      brightest_ = std::max(brightest_, floor_.look().light);
    } else {
      if (evidence == 0) first_odd = row;
      evidence += odd;
    }
    if (row >= span.bottom_row - kFootRows && evidence == 0) foot_ = floor_.look();
    if (evidence < kWalkAlarm) continue;
    const Verdict verdict = judge(column, begin_of_odd(column, first_odd, row), top);
    if (!verdict.floor_goes_on) return with_crossings(refined(column, verdict.row, span));
    row = verdict.row;
    evidence = 0;
    tone_.start(floor_.look());
  }
  if (span.horizon_row >= span.top_row + kRowsPastHorizon / 2)
    return with_crossings(from_above(column, span, top));
  return with_crossings({.end = ColumnResult::End::floor_to_top,
                         .row = (span.horizon_row < 0 ? span.top_row - 1 : span.horizon_row) + 0.5});
}

/// Whether what began at `begin` is a thing of another colour: too high for a line or a joint, no shade, and
/// no colour that the floor has had.
bool ColumnScan::has_other_tone(int column, int begin, int row) const {
  constexpr int kRows = 8;
  constexpr double kThing_m = 0.035;
  if (begin - row < kRows || as_obstacle_m(begin, row) < kThing_m) return false;
  if (!tone_.is_settled() || tones_.knows(tone_.mean())) return false;
  const Eigen::Vector3d below = mean_colour(column, begin + 2, begin + 1 + kRows);
  const Eigen::Vector3d above = mean_colour(column, row, begin - 2);
  return !is_shade_of(below, above, true);
}

/// The first row of what raised the alarm at `row`: a speck below it, with floor between, is not its own.
int ColumnScan::begin_of_odd(int column, int first_odd, int row) const {
  constexpr int kFloorBetween = 4;
  int begin = row;
  int floor_rows = 0;
  for (int r = row; r <= first_odd && floor_rows < kFloorBetween; ++r) {
    const bool floor = is_floor(grid_.look(column, r));
    floor_rows = floor ? floor_rows + 1 : 0;
    if (!floor) begin = r;
  }
  return begin;
}

ColumnResult ColumnScan::with_crossings(ColumnResult result) const {
  result.crossing_count = crossed_.crossing_count;
  result.crossings = crossed_.crossings;
  return result;
}

ColumnResult ColumnScan::ends_at(int column, int row, const ColumnSpan& span,
                                 const ColumnResult& before) const {
  ColumnResult out = refined(column, row, span);
  for (int k = 0; k < before.crossing_count; ++k) {
    const ColumnResult::Crossing& crossed = before.crossings[static_cast<std::size_t>(k)];
    if (crossed.to_row > row) out.crossings[static_cast<std::size_t>(out.crossing_count++)] = crossed;
  }
  return out;
}

double ColumnScan::as_obstacle_m(int from_row, int to_row) const {
  return scale_.height_m * (1 - scale_.depth_m[static_cast<std::size_t>(from_row)] /
                                    scale_.depth_m[static_cast<std::size_t>(std::max(to_row, 0))]);
}

/// Keeps what was crossed, to be judged by its neighbours. False when there is no room: then nobody would.
bool ColumnScan::cross(int from_row, int to_row, bool doubtful, bool patch, bool large) {
  constexpr double kWorthIt_m = 0.006;
  const double upright_m = as_obstacle_m(from_row, to_row);
  if (upright_m < kWorthIt_m) return true;
  if (crossed_.crossing_count == ColumnResult::kMostCrossings) return false;
  crossed_.crossings[static_cast<std::size_t>(crossed_.crossing_count++)] = {
      from_row, to_row, static_cast<float>(upright_m), doubtful, false, patch, large};
  return true;
}

bool ColumnScan::goes_up_beside(int column, int other, int foot_row, int strip_rows) const {
  constexpr double kWall_m = 0.1;  // a painted line that runs away from the robot looks less high
  constexpr int kTaller = 3;       // than the strip
  int rows = kTaller * strip_rows;
  while (rows < foot_row && as_obstacle_m(foot_row, foot_row - rows) < kWall_m) ++rows;
  if (strip_rows < 2 || foot_row - rows < 0) return false;
  for (const int row : {foot_row - 1, foot_row - rows})
    if (!grid_.sees(column, row) || !grid_.sees(other, row)) return false;
  const Look strip = mean_look(column, foot_row - strip_rows + 1, foot_row - 1);
  const auto alike = [&](const Look& look) {
    return std::abs(look.light - strip.light) <= 2 * tolerance_.light &&
           std::abs(look.red - strip.red) <= 2 * tolerance_.colour &&
           std::abs(look.blue - strip.blue) <= 2 * tolerance_.colour;
  };
  return alike(mean_look(other, foot_row - strip_rows + 1, foot_row - 1)) &&
         alike(mean_look(other, foot_row - rows, foot_row - strip_rows - 1));
}

bool ColumnScan::lies_between(int column, int one, int other, int from_row, int to_row) const {
  const Look a = mean_look(one, to_row, from_row);
  const Look b = mean_look(other, to_row, from_row);
  const Look look = mean_look(column, to_row, from_row);
  const auto between = [](int x, int p, int q, int slack) {
    return x >= std::min(p, q) - slack && x <= std::max(p, q) + slack;
  };
  return between(look.light, a.light, b.light, tolerance_.light) &&
         between(look.red, a.red, b.red, tolerance_.colour) &&
         between(look.blue, a.blue, b.blue, tolerance_.colour);
}

bool ColumnScan::differ_in_colour(int column, int other, int from_row, int to_row) const {
  constexpr int kClearly = 20;
  constexpr int kRows = 3;  // round the middle one: less is mixed with what lies below and above
  if (from_row - to_row < 2 * kRows) return false;
  const int middle = (from_row + to_row) / 2;
  const Look a = mean_look(column, middle - kRows / 2, middle + kRows / 2);
  const Look b = mean_look(other, middle - kRows / 2, middle + kRows / 2);
  return std::abs(a.red - b.red) > kClearly || std::abs(a.blue - b.blue) > kClearly;
}

double ColumnScan::change_between(int column, int other, int from_row, int to_row) const {
  int changed = 0;
  int rows = 0;
  const int light = std::max(5, tolerance_.light * 2 / 3);
  const int colour = std::max(4, tolerance_.colour * 2 / 3);
  for (int r = from_row; r > to_row; --r, ++rows) {
    if (!grid_.sees(column, r) || !grid_.sees(other, r)) continue;
    const Look a = grid_.look(column, r);
    const Look b = grid_.look(other, r);
    changed += std::abs(a.light - b.light) > light || std::abs(a.red - b.red) > colour ||
               std::abs(a.blue - b.blue) > colour;
  }
  return rows == 0 ? 0 : static_cast<double>(changed) / rows;
}

/// The floor's look went through the horizon: what stands there looks much like the floor. What is above the
/// horizon is no floor for certain; walked down from there, it ends where the floor begins.
ColumnResult ColumnScan::from_above(int column, const ColumnSpan& span, int top) const {
  const ColumnResult lost{.end = ColumnResult::End::through_horizon, .row = span.horizon_row + 0.5};
  LookFollower thing;
  thing.start(mean_look(column, top, span.horizon_row));
  int wander = 0;
  for (int row = top; row < span.horizon_row; ++row) {
    wander += std::abs(grid_.look(column, row + 1).light - grid_.look(column, row).light);
  }
  const int light = std::clamp(3 * wander / std::max(1, span.horizon_row - top), 3, 16);
  const Tolerance tolerance{light, std::max(3, light / 2)};
  int before = thing.look().light;
  int evidence = 0;
  int first_odd = 0;
  for (int row = span.horizon_row; row <= span.bottom_row; ++row) {
    const Look look = grid_.look(column, row);
    const bool rougher = std::abs(look.light - before) > light + 1;
    before = look.light;
    const int odd = std::max(thing.oddness(look, tolerance), rougher ? 1 : 0);
    if (odd == 0) {
      evidence = std::max(0, evidence - 1);
      thing.follow(look, 8);
    } else {
      if (evidence == 0) first_odd = row;
      evidence += 2 * odd;
    }
    if (evidence < 2 * kWalkAlarm) continue;
    ColumnResult result = refined(column, first_odd - 1, span);
    result.sigma_row = std::max(result.sigma_row, 1.5);
    return result;
  }
  return lost;
}

/// The boundary between `row` and the row below it to a part of a row: how many rows' worth of floor lie in a
/// window, each cell being a mixture of what lies below and above.
ColumnResult ColumnScan::refined(int column, int row, const ColumnSpan& span) const {
  if (row >= span.bottom_row - 1)
    return {.end = ColumnResult::End::not_floor_below, .row = span.bottom_row + 0.5};
  constexpr int kReach = 3;
  const int low = std::min(row + kReach, span.bottom_row);
  const int high = std::max(row - kReach, span.top_row);
  const Eigen::Vector3d floor = mean_colour(column, row + 2, std::min(row + 7, span.bottom_row));
  const Eigen::Vector3d thing = mean_colour(column, row - 5, row - 2);
  const Eigen::Vector3d step = thing - floor;
  const double contrast = step.norm();
  if (contrast < 6) return {.end = ColumnResult::End::boundary, .row = row + 0.5, .sigma_row = 2};
  double floor_rows = 0;
  for (int r = high; r <= low; ++r) {
    const auto c = grid_.colour(column, r);
    const double share = (Eigen::Vector3d(c[0], c[1], c[2]) - floor).dot(step) / (contrast * contrast);
    floor_rows += 1 - std::clamp(share, 0.0, 1.0);
  }
  return {.end = ColumnResult::End::boundary,
          .row = std::clamp(low + 0.5 - floor_rows, high - 0.5, low + 0.5),
          .sigma_row = 0.4 + 6 / contrast};
}

}  // namespace mirada::vision
