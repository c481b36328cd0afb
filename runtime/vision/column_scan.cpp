#include "vision/column_scan.h"

#include <algorithm>
#include <cmath>

namespace mirada::vision {
namespace {

constexpr int kAlarm = 6;            // evidence for "not floor" that ends the walk
constexpr int kRowsPastHorizon = 6;  // floor's look so far above the horizon is no floor
constexpr int kFloorIsBack = 5;      // rows of floor after an interruption
constexpr double kWidestLine_m = 0.12;
constexpr double kLowestObstacle_m = 0.035;

}  // namespace

void ColumnScan::prepare(const FloorTexture& texture, const ScanSettings& settings) {
  settings_ = settings;
  light_tolerance_ = std::clamp(static_cast<int>(std::lround(3.2 * texture.light_sigma)), 4, 24);
  colour_tolerance_ = std::clamp(static_cast<int>(std::lround(3.2 * texture.colour_sigma)), 4, 16);
}

ColumnScan::Match ColumnScan::match(const Look& look) const {
  const int light = std::abs(16 * look.light - light_16_);
  const int colour = std::max(std::abs(16 * look.red - red_16_), std::abs(16 * look.blue - blue_16_));
  if (light <= 16 * light_tolerance_ && colour <= 16 * colour_tolerance_) return Match::followed;
  if (looks_.knows(look)) return Match::known;
  const bool far_off = light > 32 * light_tolerance_ || colour > 32 * colour_tolerance_;
  return far_off ? Match::very_odd : Match::odd;
}

void ColumnScan::follow(const Look& look, int slowness) {
  light_16_ += (16 * look.light - light_16_) / slowness;
  red_16_ += (16 * look.red - red_16_) / slowness;
  blue_16_ += (16 * look.blue - blue_16_) / slowness;
}

/// The row from which the floor goes on after an interruption at `row`, or -1: then it was no line but an
/// obstacle.
int ColumnScan::row_where_floor_is_back(int column, int row, int top) const {
  const double from_m = depth_m_[static_cast<std::size_t>(row)];
  int floor_rows = 0;
  for (int r = row; r >= top; --r) {
    const double to_m = depth_m_[static_cast<std::size_t>(r)];
    const bool floor = match(grid_.look(column, r)) <= Match::known;
    floor_rows = floor ? floor_rows + 1 : 0;
    if (floor_rows == 0) {
      const double as_obstacle_m = settings_.camera_height_m * (1 - from_m / to_m);
      if (to_m - from_m > kWidestLine_m || as_obstacle_m > kLowestObstacle_m) return -1;
    }
    if (floor_rows >= kFloorIsBack) return r;
  }
  return -1;
}

ColumnResult ColumnScan::run(int column, const ColumnSpan& span, const Look& start) {
  light_16_ = 16 * start.light;
  red_16_ = 16 * start.red;
  blue_16_ = 16 * start.blue;
  foot_ = start;
  if (span.bottom_row < 0) return {};
  if (span.horizon_row >= span.bottom_row) return {.end = ColumnResult::End::above_horizon};
  const int top = std::max(0, span.horizon_row < 0 ? 0 : span.horizon_row - kRowsPastHorizon);
  int evidence = 0;
  int first_odd = span.bottom_row;
  for (int row = span.bottom_row; row >= top; --row) {
    const Look look = grid_.look(column, row);
    const Match how = match(look);
    if (how <= Match::known) {
      evidence = std::max(0, evidence - 1);
      follow(look, how == Match::followed ? 8 : 4);
    } else {
      if (evidence == 0) first_odd = row;
      evidence += how == Match::very_odd ? 2 : 1;
    }
    if (row == span.bottom_row - 12 && evidence == 0) foot_ = {light_16_ / 16, red_16_ / 16, blue_16_ / 16};
    if (evidence < kAlarm) continue;
    const int back = settings_.lines_are_obstacles ? -1 : row_where_floor_is_back(column, first_odd, top);
    if (back < 0) return refined(column, first_odd, span);
    row = back;
    evidence = 0;
  }
  const bool sees_past_horizon = span.horizon_row >= kRowsPastHorizon / 2;
  return {.end = sees_past_horizon ? ColumnResult::End::through_horizon : ColumnResult::End::floor_to_top,
          .row = span.horizon_row < 0 ? -0.5 : span.horizon_row + 0.5};
}

/// The boundary between `row` and the row below it to a part of a row: how many rows' worth of floor lie in a
/// window, each cell being a mixture of what lies below and above.
ColumnResult ColumnScan::refined(int column, int row, const ColumnSpan& span) const {
  if (row >= span.bottom_row - 1)
    return {.end = ColumnResult::End::not_floor_below, .row = span.bottom_row + 0.5};
  constexpr int kReach = 3;
  const auto mean = [&](int from, int to) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    int n = 0;
    for (int r = std::max(from, 0); r <= std::min(to, span.bottom_row); ++r, ++n) {
      const auto c = grid_.colour(column, r);
      sum += Eigen::Vector3d(c[0], c[1], c[2]);
    }
    return Eigen::Vector3d(sum / std::max(n, 1));
  };
  const int low = std::min(row + kReach, span.bottom_row);
  const int high = std::max(row - kReach, 0);
  const Eigen::Vector3d floor = mean(row + 2, row + 7);
  const Eigen::Vector3d thing = mean(row - 5, row - 2);
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
