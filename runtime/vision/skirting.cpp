#include "vision/skirting.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirada::vision {
namespace {

using End = ColumnResult::End;
using LookMean = Eigen::Array3f;

constexpr double kLowestBoard_m = 0.015;
constexpr double kHighestBoard_m = 0.13;
constexpr double kHeightStep_m = 0.003;
constexpr int kBoardHeights = static_cast<int>((kHighestBoard_m - kLowestBoard_m) / kHeightStep_m) + 1;
constexpr double kJointWidth_m = 0.02;  // between tiles or planks: no foot
constexpr int kEveryColumn = 2;
constexpr double kSameWall_rows = 4;  // of neighbouring columns
constexpr int kNarrowestWall = 20;    // columns
constexpr int kFootEdgeRows = 3;      // above and below the foot
constexpr int kBoardFloorRows = 10;   // below the foot, at most
constexpr int kMostBoardRows = 120;
constexpr float kSmallestStep = 3.5F;  // Look units
constexpr float kJointStep = 2;
constexpr float kBoardVaries = 0.4F;  // Look units from column to column: more than noise
constexpr float kEvenBoard = 0.7F;    // of how much the floor before it varies
constexpr float kCertain = 5;         // times the standard error
constexpr float kSameSpot = 3;        // neighbouring columns that show the same spot of a floor
constexpr double kBoardVotes = 0.8;   // of the columns that are asked

/// Sums of the looks of one column, row by row downwards from where the floor was said to end.
class Downwards {
 public:
  Downwards(const PictureGrid& grid, int column, int first_row, int last_row) {
    sums_[0] = LookMean::Zero();
    count_ = std::min(last_row - first_row + 1, kMostBoardRows);
    for (int k = 0; k < count_; ++k) {
      const Look look = grid.look(column, first_row + k);
      sums_[static_cast<std::size_t>(k) + 1] =
          sums_[static_cast<std::size_t>(k)] + LookMean(static_cast<float>(look.light),
                                                        static_cast<float>(look.red),
                                                        static_cast<float>(look.blue));
    }
  }
  int count() const { return count_; }
  /// Of rows from..to - 1.
  LookMean mean(int from, int to) const {
    return (sums_[static_cast<std::size_t>(to)] - sums_[static_cast<std::size_t>(from)]) /
           static_cast<float>(to - from);
  }

 private:
  std::array<LookMean, kMostBoardRows + 1> sums_;
  int count_ = 0;
};

/// How the look changes at one height below the wall, over the columns.
struct Steps {
  LookMean edge = LookMean::Zero();    ///< sums: close to the foot
  LookMean whole = LookMean::Zero();   ///< the board against the floor before it
  LookMean across = LookMean::Zero();  ///< the same with a joint's width left out
  LookMean joint = LookMean::Zero();   ///< what lies between them against that floor
  LookMean squares = LookMean::Zero();
  float board_varies = 0;  ///< sum of the light's differences from column to column
  float floor_varies = 0;
  float last_board = 0;
  float last_floor = 0;
  int votes = 0;

  void add(const Downwards& column, int board_rows, int joint_rows) {
    const int below = board_rows + 1;
    const int beyond = below + joint_rows;
    const int floor_rows = std::min({kBoardFloorRows, board_rows, column.count() - beyond});
    if (board_rows <= kFootEdgeRows || floor_rows < kFootEdgeRows) return;
    const LookMean step =
        column.mean(board_rows - kFootEdgeRows, board_rows) - column.mean(below, below + kFootEdgeRows);
    edge += step;
    const float on_board = column.mean(1, board_rows)[0];
    const float on_floor = column.mean(beyond, beyond + floor_rows)[0];
    if (votes > 0) {
      board_varies += std::abs(on_board - last_board);
      floor_varies += std::abs(on_floor - last_floor);
    }
    last_board = on_board;
    last_floor = on_floor;
    across +=
        column.mean(board_rows - kFootEdgeRows, board_rows) - column.mean(beyond, beyond + kFootEdgeRows);
    squares += step * step;
    joint += column.mean(below - 1, beyond) - column.mean(beyond, beyond + floor_rows);
    whole += column.mean(1, board_rows) - column.mean(beyond, beyond + floor_rows);
    ++votes;
  }
  /// Darker or lighter than what lies on either side of it, as joints between tiles and planks are.
  bool is_joint() const {
    const LookMean low = whole.min(0) - kJointStep * static_cast<float>(votes);
    const LookMean high = whole.max(0) + kJointStep * static_cast<float>(votes);
    return (joint < low || joint > high).any();
  }
  /// Painted all alike along the wall, or nothing else is either: the next row of tiles varies as this one
  /// does.
  bool is_even() const {
    return floor_varies < kBoardVaries * static_cast<float>(votes) ||
           board_varies < kEvenBoard * floor_varies;
  }
  /// How clear a step there is; 0: none.
  float clearness(int asked) const {
    const auto n = static_cast<float>(votes);
    if (votes < kBoardVotes * asked || votes == 0 || is_joint() || !is_even()) return 0;
    const LookMean mean = edge / n;
    const LookMean sigma = (squares / n - mean * mean).max(1).sqrt();
    float best = 0;
    for (int i = 0; i < 3; ++i) {
      const float step = std::min({std::abs(mean[i]), std::abs(whole[i] / n), std::abs(across[i] / n)});
      const bool same_way = mean[i] * whole[i] > 0 && mean[i] * across[i] > 0;
      const bool certain = std::abs(mean[i]) > kCertain * sigma[i] * std::sqrt(kSameSpot / n);
      if (same_way && certain && step >= kSmallestStep) best = std::max(best, step);
    }
    return best;
  }
};

/// The first row from `row` on, at most `last`, that lies no farther off than `to_m`.
int row_at(const RowScale& scale, int row, int last, double to_m) {
  while (row < last && scale.depth_m[static_cast<std::size_t>(row)] > to_m) ++row;
  return row;
}

double foot_m(const RowScale& scale, int end_row, double height_m) {
  return scale.depth_m[static_cast<std::size_t>(end_row)] * (1 - height_m / scale.height_m);
}

int end_row(const ColumnResult& result) { return static_cast<int>(std::lround(result.row + 0.5)); }

/// Columns first..last end at one wall: the height of its board, or 0.
double board_height_m(const PictureGrid& grid, const RowScale& scale, const std::vector<ColumnSpan>& spans,
                      const std::vector<ColumnResult>& results, int first, int last) {
  std::array<Steps, kBoardHeights> steps;
  int asked = 0;
  for (int column = first; column <= last; column += kEveryColumn, ++asked) {
    const auto i = static_cast<std::size_t>(column);
    const int end = end_row(results[i]);
    const Downwards rows(grid, column, end, spans[i].bottom_row);
    int row = end;
    for (int h = 0; h < kBoardHeights; ++h) {
      const double at_m = foot_m(scale, end, kLowestBoard_m + h * kHeightStep_m);
      row = row_at(scale, row, spans[i].bottom_row, at_m);
      if (row >= spans[i].bottom_row) break;
      const int joint = row_at(scale, row, spans[i].bottom_row, at_m - kJointWidth_m);
      steps[static_cast<std::size_t>(h)].add(rows, row - end, joint - row);
    }
  }
  double best_m = 0;
  float clearest = 0;
  for (int h = 0; h < kBoardHeights; ++h) {
    const float clearness = steps[static_cast<std::size_t>(h)].clearness(asked);
    if (clearness <= clearest) continue;
    clearest = clearness;
    best_m = kLowestBoard_m + h * kHeightStep_m;
  }
  return best_m;
}

}  // namespace

void stop_at_skirting(const PictureGrid& grid, const RowScale& scale, const std::vector<ColumnSpan>& spans,
                      const ColumnScan& scan, std::vector<ColumnResult>& results) {
  const int count = static_cast<int>(results.size());
  if (scan.is_colourful()) return;
  const auto at = [&](int column) -> ColumnResult& { return results[static_cast<std::size_t>(column)]; };
  for (int first = 0; first < count;) {
    int last = first;
    while (last + 1 < count && at(last).end == End::boundary && at(last + 1).end == End::boundary &&
           std::abs(at(last + 1).row - at(last).row) < kSameWall_rows)
      ++last;
    if (last - first + 1 >= kNarrowestWall) {
      const double height_m = board_height_m(grid, scale, spans, results, first, last);
      for (int column = first; height_m > 0 && column <= last; ++column) {
        const ColumnSpan& span = spans[static_cast<std::size_t>(column)];
        const int end = end_row(at(column));
        const int row = row_at(scale, end, span.bottom_row, foot_m(scale, end, height_m)) - 1;
        at(column) = scan.ends_at(column, row, span, at(column));
      }
    }
    first = last + 1;
  }
}

}  // namespace mirada::vision
