#include "vision/specks.h"

#include <algorithm>
#include <cmath>

namespace mirada::vision {
namespace {

using End = ColumnResult::End;

constexpr int kSpeckColumns = 4;
constexpr int kSpeckRows = 14;

/// A narrow thing has two sides that go up from its foot; a speck, a vein of stone or a scratch has not.
bool has_sides(const ColumnScan& scan, int left, int right, const ColumnResult& result) {
  const int from = static_cast<int>(result.row) - 1;
  const int to = std::max(0, from - kSpeckRows);
  const auto side = [&](int inside, int outside, int farther) {
    return std::max(scan.change_between(inside, outside, from, to),
                    scan.change_between(inside, farther, from, to)) > kSideSeenShare;
  };
  // The picture's side hides a side.
  return (left < 2 || side(left, left - 1, left - 2)) &&
         (right + 2 >= scan.columns() || side(right, right + 1, right + 2));
}

bool ends_low(const ColumnResult& result) {
  return result.end == End::boundary || result.end == End::not_floor_below;
}

/// Whether columns left..right end nearer than what is beside them by so much that it is another thing. At
/// the picture's side one neighbour is enough.
bool stands_out(const std::vector<ColumnResult>& results, int left, int right) {
  constexpr double kJump_rows = 5;
  const int count = static_cast<int>(results.size());
  const auto at = [&](int column) -> const ColumnResult& {
    return results[static_cast<std::size_t>(column)];
  };
  for (int c = left; c <= right; ++c) {
    if (!ends_low(at(c))) return false;
    for (const int next : {left - 1, right + 1}) {
      if (next < 0 || next >= count) continue;
      if (at(next).end == End::nothing || at(next).end == End::above_horizon ||
          at(c).row <= at(next).row + kJump_rows)
        return false;
    }
  }
  return true;
}

/// Whether all columns look like a mixture of what is beside them: the rim of a shade or a tile.
bool is_blend(const ColumnScan& scan, int left, int right, const ColumnResult& result) {
  const int from = static_cast<int>(result.row);
  const bool below = result.end == End::not_floor_below;
  if (!below || left == 0 || right + 1 >= scan.columns()) return false;
  for (int c = left; c <= right; ++c)
    if (!scan.lies_between(c, left - 1, right + 1, from, std::max(0, from - kSpeckRows))) return false;
  return true;
}

/// Whether other columns near by end about as far up the picture, as they do along the foot of one thing that
/// is seen here and there only.
bool goes_on_beside(const std::vector<ColumnResult>& results, int left, int right, double row) {
  constexpr int kReach = 14;
  constexpr double kRows = 8;
  for (int c = left - kReach; c <= right + kReach; ++c) {
    const bool itself = c >= left - 1 && c <= right + 1;
    if (itself || c < 0 || c >= static_cast<int>(results.size())) continue;
    const double other = results[static_cast<std::size_t>(c)].low_row;
    if (other >= 0 && std::abs(other - row) <= kRows) return true;
  }
  return false;
}

}  // namespace

void drop_specks(const ColumnScan& scan, std::vector<ColumnResult>& results) {
  const int count = static_cast<int>(results.size());
  const auto at = [&](int column) -> ColumnResult& { return results[static_cast<std::size_t>(column)]; };
  for (ColumnResult& result : results) result.low_row = ends_low(result) ? result.row : -1;
  for (int width = 1; width <= kSpeckColumns; ++width) {
    for (int left = 0; left + width <= count; ++left) {
      const int right = left + width - 1;
      if (!stands_out(results, left, right)) continue;
      int nearest = left;
      for (int c = left; c <= right; ++c)
        if (at(c).row > at(nearest).row) nearest = c;
      const bool near = scan.is_careful_at(static_cast<int>(at(nearest).row));
      if ((near && goes_on_beside(results, left, right, at(nearest).row)) ||
          (has_sides(scan, left, right, at(nearest)) && !is_blend(scan, left, right, at(nearest))))
        continue;
      const bool left_is_nearer = right + 1 >= count || (left > 0 && at(left - 1).row > at(right + 1).row);
      const ColumnResult kept = left_is_nearer ? at(left - 1) : at(right + 1);
      for (int c = left; c <= right; ++c) {
        const double low_row = at(c).low_row;
        at(c) = kept;
        at(c).low_row = low_row;
      }
    }
  }
}

}  // namespace mirada::vision
