#include "memory/free_floor.h"

#include <algorithm>
#include <cmath>

namespace mirada::memory {
namespace {

constexpr Micros kTick = 10 * kMillisecond;
constexpr double kStepPart = 0.7;  // of a cell, so that no square on the way is missed by much

/// floor(), which is a call where the processor's own rounding may not be counted on.
std::int32_t cell_of(double at_m) {
  constexpr double kPer_m = 1 / FreeFloor::kCell_m;
  const double at = at_m * kPer_m;
  const auto towards_0 = static_cast<std::int32_t>(at);
  return towards_0 - (static_cast<double>(towards_0) > at ? 1 : 0);
}

}  // namespace

void FreeFloor::centre(double x_m, double y_m, Micros now, double tyre_m) {
  middle_x_ = cell_of(x_m);
  middle_y_ = cell_of(y_m);
  now_ = now;
  tyre_m_ = tyre_m;
}

void FreeFloor::mark(double x_m, double y_m, Mark mark) {
  const std::int32_t x = cell_of(x_m);
  const std::int32_t y = cell_of(y_m);
  if (std::abs(x - middle_x_) >= kSide / 2 || std::abs(y - middle_y_) >= kSide / 2) return;
  if (mark == Mark::before && seen_at(x_m, y_m) >= 0) return;
  cells_[slot(x, y)] = {x, y, static_cast<std::int32_t>(now_ / kTick), static_cast<float>(tyre_m_), mark};
}

void FreeFloor::mark_ray(double x_m, double y_m, double direction_rad, double length_m, Mark mark) {
  const double step_x = std::cos(direction_rad);
  const double step_y = std::sin(direction_rad);
  for (double at = 0; at < length_m; at += kStepPart * kCell_m)
    this->mark(x_m + at * step_x, y_m + at * step_y, mark);
}

const FreeFloor::Cell* FreeFloor::known_at(double x_m, double y_m) const {
  const std::int32_t x = cell_of(x_m);
  const std::int32_t y = cell_of(y_m);
  const Cell& cell = cells_[slot(x, y)];
  if (cell.seen_cs < 0 || cell.x != x || cell.y != y) return nullptr;
  const Micros seen = cell.seen_cs * kTick;
  if (now_ - seen > kLife || tyre_m_ - static_cast<double>(cell.tyre_m) > kLongestTyre_m) return nullptr;
  return &cell;
}

Micros FreeFloor::seen_at(double x_m, double y_m) const {
  const Cell* cell = known_at(x_m, y_m);
  return cell != nullptr && cell->mark == Mark::seen ? cell->seen_cs * kTick : -1;
}

bool FreeFloor::likely_at(double x_m, double y_m) const { return known_at(x_m, y_m) != nullptr; }

void FreeFloor::forget() { std::fill(cells_.begin(), cells_.end(), Cell{}); }

}  // namespace mirada::memory
