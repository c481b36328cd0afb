#include "vision/obstacle_hold.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

namespace mirada::vision {
namespace {

using End = ColumnResult::End;

constexpr std::size_t kMost = 256;
constexpr double kFarthest_m = 0.7;  // from the lens
constexpr int kSeenToHold = 3;       // pictures
constexpr int kLongestUnseen = 60;   // pictures
constexpr double kSlack_m = 0.03;
constexpr double kSlackShare = 0.12;
constexpr double kFoot_m = 0.03;  // the look is that of so much of its lower end
constexpr int kHeldLight = 20;
constexpr int kHeldColour = 9;
constexpr double kOneThing_m = 0.06;
constexpr int kWidestGap = 4;  // columns
constexpr double kHeldSigma_rows = 2;

bool still_looks(const Look& a, const Look& b) {
  return std::abs(a.light - b.light) <= kHeldLight && std::abs(a.red - b.red) <= kHeldColour &&
         std::abs(a.blue - b.blue) <= kHeldColour;
}

Eigen::Vector2d moved_by(const Pose2& X, const Eigen::Vector2d& p) {
  return {X.x_m + std::cos(X.heading_rad) * p.x() - std::sin(X.heading_rad) * p.y(),
          X.y_m + std::sin(X.heading_rad) * p.x() + std::cos(X.heading_rad) * p.y()};
}

}  // namespace

/// One picture and where it was taken.
struct ObstacleHold::View {
  const PictureGrid& grid;
  const std::vector<ColumnSpan>& spans;
  const GroundProjection& ground;
  Pose2 X_OR;
  Pose2 X_RO;

  Eigen::Vector2d lens() const { return ground.X_RC().translation().head<2>(); }
  const ColumnSpan& span(int column) const { return spans[static_cast<std::size_t>(column)]; }

  /// Column and (fractional) row of a point on the floor; nothing beside the picture.
  struct Cell {
    int column;
    double row;
  };
  std::optional<Cell> cell(const Eigen::Vector2d& p_R_m) const {
    const auto pixel = ground.pixel(p_R_m);
    if (!pixel) return std::nullopt;
    const int column = grid.column_at(pixel->x(), pixel->y());
    if (column < 0 || span(column).bottom_row < 4) return std::nullopt;
    return Cell{column, (pixel->y() + 0.5) / grid.pixels_down() - 0.5};
  }

  /// Where on the floor a column's answer lies, from the lens; nothing where it has none.
  std::optional<double> distance_m(int column, const ColumnResult& result) const {
    if (result.end == End::nothing || result.end == End::above_horizon) return std::nullopt;
    if (result.end == End::through_horizon || result.end == End::floor_to_top) return 1e3;
    const auto p = ground.floor_point_of_ray(grid.ray_C(column, result.row));
    return p ? (*p - lens()).norm() : 1e3;
  }

  /// The mean look of the lowest kFoot_m of what stands at p_R_m.
  Look look_above(const Eigen::Vector2d& p_R_m, const Cell& at) const {
    const double h = ground.height_m();
    const auto top = h > 2 * kFoot_m ? cell(lens() + (p_R_m - lens()) * (h / (h - kFoot_m))) : std::nullopt;
    const int low = std::clamp(static_cast<int>(std::lround(at.row)) - 1, 2, span(at.column).bottom_row);
    const int wanted = top ? static_cast<int>(std::lround(top->row)) : low - 4;
    const int high = std::clamp(wanted, span(at.column).top_row, low - 2);
    Look sum{0, 0, 0};
    for (int row = high; row <= low; ++row) {
      const Look look = grid.look(at.column, row);
      sum = {sum.light + look.light, sum.red + look.red, sum.blue + look.blue};
    }
    const int n = low - high + 1;
    return {sum.light / n, sum.red / n, sum.blue / n};
  }

  ColumnResult blocked_at(int column, double row) const {
    const int bottom = span(column).bottom_row;
    if (row >= bottom) return {End::not_floor_below, static_cast<double>(bottom), 1};
    return {End::boundary, row, kHeldSigma_rows};
  }
};

ObstacleHold::ObstacleHold() { held_.reserve(kMost); }

void ObstacleHold::forget() { held_.clear(); }

/// Finds it in this picture; one that something else has taken the place of loses what it was seen.
void ObstacleHold::follow(const View& view, std::vector<ColumnResult>& results, Held& held) const {
  held.put_back = false;
  held.column = -1;
  const Eigen::Vector2d p_R_m = moved_by(view.X_RO, held.p_O_m);
  const auto at = view.cell(p_R_m);
  if (!at) {
    ++held.unseen;
    return;
  }
  held.unseen = 0;
  held.column = at->column;
  held.row = at->row;
  ColumnResult& result = results[static_cast<std::size_t>(at->column)];
  const auto now_m = view.distance_m(at->column, result);
  if (!now_m) return;
  const double expected_m = (p_R_m - view.lens()).norm();
  const double slack_m = kSlack_m + kSlackShare * expected_m;
  const bool below = at->row >= view.span(at->column).bottom_row;
  if (*now_m <= expected_m + slack_m) {
    if (*now_m < expected_m - slack_m || result.end != End::boundary) return;
    const auto p = view.ground.floor_point_of_ray(view.grid.ray_C(at->column, result.row));
    if (!p) return;
    ++held.seen;
    held.p_O_m = moved_by(view.X_OR, *p);
    held.row = result.row;
    held.look = view.look_above(*p, {at->column, result.row});
    return;
  }
  if (held.seen < kSeenToHold || (!below && !still_looks(held.look, view.look_above(p_R_m, *at)))) {
    held.seen = 0;
    return;
  }
  held.put_back = true;
  result = view.blocked_at(at->column, at->row);
}

/// The columns between two parts of one thing are its own too: nearer by, fewer of its points than columns
/// are held.
void ObstacleHold::put_back_between(const View& view, std::vector<ColumnResult>& results) {
  std::ranges::sort(held_, {}, &Held::column);
  for (std::size_t i = 1; i < held_.size(); ++i) {
    const Held& a = held_[i - 1];
    const Held& b = held_[i];
    const bool one = a.column >= 0 && b.seen >= kSeenToHold && a.seen >= kSeenToHold &&
                     (a.put_back || b.put_back) && b.column - a.column <= kWidestGap &&
                     (a.p_O_m - b.p_O_m).norm() < kOneThing_m;
    if (!one) continue;
    for (int column = a.column + 1; column < b.column; ++column) {
      const double part = static_cast<double>(column - a.column) / (b.column - a.column);
      const double row = a.row + part * (b.row - a.row);
      ColumnResult& result = results[static_cast<std::size_t>(column)];
      const bool ends = result.end == End::boundary || result.end == End::not_floor_below;
      if (!ends || result.row < row) result = view.blocked_at(column, row);
    }
  }
}

void ObstacleHold::take_new(const View& view, const std::vector<ColumnResult>& results) {
  taken_.assign(results.size(), 0);
  for (const Held& held : held_) {
    if (held.column >= 0) taken_[static_cast<std::size_t>(held.column)] = 1;
  }
  for (std::size_t i = 0; i < results.size() && held_.size() < kMost; ++i) {
    if (taken_[i] || results[i].end != End::boundary) continue;
    const int column = static_cast<int>(i);
    const auto p = view.ground.floor_point_of_ray(view.grid.ray_C(column, results[i].row));
    if (!p || (*p - view.lens()).norm() > kFarthest_m) continue;
    Held held;
    held.p_O_m = moved_by(view.X_OR, *p);
    held.look = view.look_above(*p, {column, results[i].row});
    held.seen = 1;
    held_.push_back(held);
  }
}

void ObstacleHold::apply(const PictureGrid& grid, const std::vector<ColumnSpan>& spans,
                         const GroundProjection& ground, const Pose2& X_OR,
                         std::vector<ColumnResult>& results) {
  const View view{grid, spans, ground, X_OR, inverse(X_OR)};
  for (Held& held : held_) follow(view, results, held);
  std::erase_if(held_, [](const Held& held) { return held.seen == 0 || held.unseen > kLongestUnseen; });
  put_back_between(view, results);
  take_new(view, results);
}

}  // namespace mirada::vision
