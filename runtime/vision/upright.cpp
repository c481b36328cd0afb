#include "vision/upright.h"

#include <algorithm>
#include <cmath>

#include "vision/specks.h"

namespace mirada::vision {
namespace {

using Crossing = ColumnResult::Crossing;
using End = ColumnResult::End;

constexpr int kRun = 6;                // columns from a side inwards that tell how tall it is there
constexpr double kTallAtOnce = 0.45;   // of the tallest in the run, in the outermost column
constexpr double kTallAfterOne = 0.6;  // in the one beside it
constexpr double kRound = 0.6;         // a large ball's sides rise more slowly
constexpr double kOverlap = 0.4;
constexpr double kAlike = 0.35;  // a side that falls off faster is upright
constexpr double kVaries = 0.12;
constexpr double kSeenShare = 0.35;  // of the side
constexpr float kWorthIt_m = 0.025;  // lower things are passed over
constexpr float kStrip_m = 0.012;    // of a wall, below a picture that hangs on it
constexpr float kShadow_m = 0.04F;   // of a thing on the floor before it, as high as if it stood
constexpr double kSameFoot_rows = 4;
constexpr int kBeyondRows = 6;
constexpr int kFewOf = 3;      // one column in so many that was not crossed says nothing
constexpr int kNarrowest = 3;  // columns of a patch that can be judged

int height(const Crossing& c) { return c.from_row - c.to_row; }

bool overlap(const Crossing& a, const Crossing& b) {
  const int shared = std::min(a.from_row, b.from_row) - std::max(a.to_row, b.to_row);
  const int lower = std::min(height(a), height(b));
  return shared >= kOverlap * lower && lower >= kAlike * std::max(height(a), height(b));
}

/// What was crossed in the column beside as a part of the same thing. A book that lies where a painted line
/// goes on is no part of the line.
const Crossing* beside(const ColumnScan& scan, const Crossing& c, int column, int other_column,
                       const ColumnResult& next) {
  for (int i = 0; i < next.crossing_count; ++i) {
    const Crossing& other = next.crossings[static_cast<std::size_t>(i)];
    if (!overlap(c, other)) continue;
    const int from_row = std::min(c.from_row, other.from_row);
    const int to_row = std::max(c.to_row, other.to_row);
    if (!scan.differ_in_colour(column, other_column, from_row, to_row)) return &other;
  }
  return nullptr;
}

enum class Side {
  upright,
  slanting,
  unknown,
  joined,    ///< the neighbouring column ends at its foot
  continued  ///< and what ends it there looks the same: a wall goes on behind the picture that hangs on it
};

/// How high what was crossed would be if it stood upright, over its columns: the same everywhere for a board
/// or a box, another everywhere for what lies on the floor.
struct Heights {
  double sum = 0, squares = 0;
  int count = 0;
  int tallest_rows = 0;

  void add(const Crossing& c) {
    const double m = static_cast<double>(c.upright_m);
    sum += m, squares += m * m, ++count;
    tallest_rows = std::max(tallest_rows, height(c));
  }
  bool vary() const {
    const double mean = sum / count;
    return count >= kRun && squares / count - mean * mean > kVaries * kVaries * mean * mean;
  }
};

/// How many columns from `start` on by `step` end one beside the other.
int columns_at_foot(const std::vector<ColumnResult>& results, int start, int step) {
  const int count = static_cast<int>(results.size());
  int columns = 1;
  for (int c = start + step; c >= 0 && c < count; c += step, ++columns) {
    const ColumnResult& next = results[static_cast<std::size_t>(c)];
    const ColumnResult& before = results[static_cast<std::size_t>(c - step)];
    if (next.end != End::boundary || std::abs(next.row - before.row) >= kSameFoot_rows) break;
  }
  return columns;
}

/// Walks from `start` by `step` columns as far as the crossed thing goes; says what its side is like.
Side side_of(const ColumnScan& scan, const std::vector<ColumnResult>& results,
             const std::vector<ColumnSpan>& spans, int start, int step, const Crossing& crossing, int& last,
             Heights& heights) {
  const Crossing* before[kRun] = {&crossing};
  int known = 1;
  int column = start;
  const int count = static_cast<int>(results.size());
  for (int next = start + step; next >= 0 && next < count; next += step) {
    const Crossing* c = beside(scan, *before[0], next - step, next, results[static_cast<std::size_t>(next)]);
    if (!c) break;
    std::move_backward(before, before + kRun - 1, before + kRun);
    before[0] = c;
    heights.add(*c);
    known = std::min(known + 1, kRun);
    column = next;
  }
  last = column;
  const int outside = column + step;
  if (outside < 0 || outside >= count) return Side::unknown;
  const ColumnResult& next = results[static_cast<std::size_t>(outside)];
  const Crossing& end = *before[0];
  if (next.end == End::boundary && std::abs(next.row - end.from_row) < kSameFoot_rows) {
    int strip = height(end);
    for (int i = 0; i < known; ++i) strip = std::min(strip, height(*before[i]));
    const auto goes_up = [&](int other) {
      return other >= 0 && other < count && scan.goes_up_beside(column, other, end.from_row, strip);
    };
    if (goes_up(outside) || goes_up(outside + step)) return Side::continued;
    const bool trusts = !scan.is_careful_at(end.from_row) || scan.is_colourful();
    // Cut off by the picture's side, it could not show the floor beyond.
    if (spans[static_cast<std::size_t>(outside)].top_row + kBeyondRows > end.to_row && trusts)
      return Side::unknown;
    const int crossed = heights.count;
    const bool few = trusts && columns_at_foot(results, outside, step) * kFewOf <= crossed;
    return few ? Side::unknown : Side::joined;
  }
  const bool ends = next.end != End::floor_to_top && next.end != End::through_horizon;
  const int seen_to =
      std::max(ends ? static_cast<int>(next.row) : 0, spans[static_cast<std::size_t>(outside)].top_row);
  const int to_row = std::max(end.to_row, seen_to);
  if (end.from_row - to_row < kSeenShare * height(end)) return Side::unknown;
  int tallest = 0;
  for (int i = 0; i < known; ++i) tallest = std::max(tallest, height(*before[i]));
  // The picture's foot cuts it off, aslant if it lies on the floor.
  if (end.from_row >= spans[static_cast<std::size_t>(column)].bottom_row)
    tallest = std::max(tallest, heights.tallest_rows);
  const double round = end.large ? kRound : 1;
  const bool tall = height(end) >= round * kTallAtOnce * tallest ||
                    (known > 1 && height(*before[1]) >= round * kTallAfterOne * tallest && tallest > 0);
  if (!tall) return Side::slanting;
  const int inside = column - step * (known > 1);
  const int far = outside + step >= 0 && outside + step < count ? outside + step : outside;
  const double change = std::max(scan.change_between(inside, outside, end.from_row, to_row),
                                 scan.change_between(inside, far, end.from_row, to_row));
  return change > kSideSeenShare ? Side::upright : Side::unknown;
}

enum class Kind { thing, flat, unsure };

Kind kind_of_patch(const ColumnScan& scan, const std::vector<ColumnResult>& results,
                   const std::vector<ColumnSpan>& spans, int column, const Crossing& crossing) {
  int left = column;
  int right = column;
  Heights heights;
  heights.add(crossing);
  const Side a = side_of(scan, results, spans, column, -1, crossing, left, heights);
  const Side b = side_of(scan, results, spans, column, 1, crossing, right, heights);
  const int columns = right - left + 1;
  const bool continued = a == Side::continued || b == Side::continued;
  if (continued && crossing.patch && crossing.upright_m > kStrip_m) return Kind::thing;
  const bool joined = continued || a == Side::joined || b == Side::joined;
  const bool slants = a == Side::slanting || b == Side::slanting;
  const bool stands = a == Side::upright || b == Side::upright || continued;
  if (crossing.large && !stands && columns >= 2 * kRun && slants && heights.vary()) return Kind::flat;
  if (crossing.upright_m < kWorthIt_m) return Kind::unsure;
  if (a == Side::slanting || b == Side::slanting)
    return a == Side::upright || b == Side::upright || joined || columns < kRun ? Kind::unsure : Kind::flat;
  const ColumnResult& result = results[static_cast<std::size_t>(column)];
  const bool shadow_at_foot =
      !crossing.patch && result.end == End::boundary && std::abs(result.row - crossing.to_row) < 2;
  const bool wide = columns * 2 >= static_cast<int>(results.size());
  if (shadow_at_foot && !wide && crossing.upright_m < kShadow_m && !scan.is_careful_at(crossing.from_row))
    return Kind::unsure;
  if (crossing.patch && joined) return Kind::thing;
  if (crossing.patch && columns < kNarrowest) return Kind::unsure;
  if (a == Side::upright && b == Side::upright) return Kind::thing;
  const bool one = (a == Side::upright && b == Side::unknown) || (b == Side::upright && a == Side::unknown);
  if (one && columns >= kRun && !heights.vary()) return Kind::thing;
  const bool doubtful = crossing.doubtful && !(a == b && heights.vary());
  return doubtful || (crossing.patch && a != b) ? Kind::thing : Kind::unsure;
}

Kind kind_of(const ColumnScan& scan, const std::vector<ColumnResult>& results,
             const std::vector<ColumnSpan>& spans, int column, const Crossing& crossing) {
  const Kind kind = kind_of_patch(scan, results, spans, column, crossing);
  return crossing.large && kind != Kind::flat ? Kind::thing : kind;
}
}  // namespace

void stop_at_upright(const ColumnScan& scan, const std::vector<ColumnSpan>& spans,
                     std::vector<ColumnResult>& results) {
  // All are judged before any is changed: a column that ends hides its neighbour's side.
  const int count = static_cast<int>(results.size());
  for (int column = 0; column < count; ++column) {
    ColumnResult& result = results[static_cast<std::size_t>(column)];
    result.stop = -1;
    for (int i = 0; i < result.crossing_count && result.stop < 0; ++i) {
      Crossing& crossing = result.crossings[static_cast<std::size_t>(i)];
      const Kind kind = kind_of(scan, results, spans, column, crossing);
      crossing.flat = kind == Kind::flat;
      if (kind == Kind::thing) result.stop = i;
    }
  }
  for (int column = 0; column < count; ++column) {
    ColumnResult& result = results[static_cast<std::size_t>(column)];
    if (result.stop < 0) continue;
    const int row = result.crossings[static_cast<std::size_t>(result.stop)].from_row;
    result = scan.ends_at(column, row, spans[static_cast<std::size_t>(column)], {});
  }
  drop_specks(scan, results);
}

}  // namespace mirada::vision
