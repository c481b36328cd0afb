#include "memory/route.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace mirada::memory {
namespace {

using Eigen::Vector2d;

constexpr int kCells = 96;
constexpr double kSquare_m = 0.1;
constexpr int kUnknownCost = 30;
constexpr int kFreeCost = 10;
constexpr int kTightCost = 25;  // added where it is tight
constexpr double kTight_m = 0.08;
constexpr int kBlocked = -1;

/// The floor around the robot as squares with a price.
class Grid {
 public:
  Grid(const VisualMemory& memory, double radius_m)
      : here_(memory.X_OR().x_m, memory.X_OR().y_m), price_(kCells * kCells, kUnknownCost) {
    for (int i = 0; i < kCells * kCells; ++i) {
      const Vector2d p = middle(i);
      if (memory.floor().seen_at(p.x(), p.y()) >= 0) price_[static_cast<std::size_t>(i)] = kFreeCost;
    }
    for (const ObstaclePoint& point : memory.points().all()) block(point.p_O_m, radius_m);
    // Wherever the robot stands, it can leave.
    const int start = index(here_);
    if (start >= 0) price_[static_cast<std::size_t>(start)] = kUnknownCost;
  }

  int index(const Vector2d& p) const {
    const int x = static_cast<int>(std::floor((p.x() - here_.x()) / kSquare_m + kCells / 2.0));
    const int y = static_cast<int>(std::floor((p.y() - here_.y()) / kSquare_m + kCells / 2.0));
    return x < 0 || y < 0 || x >= kCells || y >= kCells ? -1 : y * kCells + x;
  }
  Vector2d middle(int i) const {
    return here_ + kSquare_m * Vector2d(i % kCells - kCells / 2 + 0.5, i / kCells - kCells / 2 + 0.5);
  }
  /// Its floor was looked at and nothing stands there.
  bool seen(int i) const { return price(i) == kFreeCost || price(i) == kFreeCost + kTightCost; }
  int price(int i) const { return price_[static_cast<std::size_t>(i)]; }
  const Vector2d& here() const { return here_; }

 private:
  void block(const Vector2d& p, double radius_m) {
    const int reach = static_cast<int>((radius_m + kTight_m) / kSquare_m) + 1;
    const int x = static_cast<int>(std::floor((p.x() - here_.x()) / kSquare_m + kCells / 2.0));
    const int y = static_cast<int>(std::floor((p.y() - here_.y()) / kSquare_m + kCells / 2.0));
    for (int dy = -reach; dy <= reach; ++dy) {
      for (int dx = -reach; dx <= reach; ++dx) {
        if (x + dx < 0 || y + dy < 0 || x + dx >= kCells || y + dy >= kCells) continue;
        const int i = (y + dy) * kCells + x + dx;
        const double off_m = (middle(i) - p).norm();
        int& price = price_[static_cast<std::size_t>(i)];
        if (off_m < radius_m) price = kBlocked;
        if (off_m < radius_m + kTight_m && price != kBlocked && price <= kUnknownCost) price += kTightCost;
      }
    }
  }

  Vector2d here_;
  std::vector<int> price_;
};

struct Reached {
  std::vector<int> cost;
  std::vector<int> from;
};

Reached spread(const Grid& grid, int start) {
  constexpr int kNever = 1 << 30;
  Reached out{std::vector<int>(kCells * kCells, kNever), std::vector<int>(kCells * kCells, -1)};
  using Open = std::pair<int, int>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  out.cost[static_cast<std::size_t>(start)] = 0;
  open.emplace(0, start);
  while (!open.empty()) {
    const auto [cost, at] = open.top();
    open.pop();
    if (cost > out.cost[static_cast<std::size_t>(at)]) continue;
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const int x = at % kCells + dx;
        const int y = at / kCells + dy;
        if ((dx == 0 && dy == 0) || x < 0 || y < 0 || x >= kCells || y >= kCells) continue;
        const int next = y * kCells + x;
        if (grid.price(next) == kBlocked) continue;
        const int total = cost + grid.price(next) * (dx != 0 && dy != 0 ? 14 : 10) / 10;
        if (total >= out.cost[static_cast<std::size_t>(next)]) continue;
        out.cost[static_cast<std::size_t>(next)] = total;
        out.from[static_cast<std::size_t>(next)] = at;
        open.emplace(total, next);
      }
    }
  }
  return out;
}

std::vector<Vector2d> steps_to(const Grid& grid, const Reached& reached, int start, int end) {
  std::vector<Vector2d> out;
  for (int i = end; i != start && i >= 0; i = reached.from[static_cast<std::size_t>(i)])
    out.push_back(grid.middle(i));
  std::reverse(out.begin(), out.end());
  return out;
}

}  // namespace

Route route_to(const VisualMemory& memory, const Vector2d& goal_O_m, double radius_m) {
  const Grid grid(memory, radius_m);
  const int start = grid.index(grid.here());
  const Reached reached = spread(grid, start);
  int end = start;
  double nearest_m = (grid.middle(start) - goal_O_m).norm();
  for (int i = 0; i < kCells * kCells; ++i) {
    if (reached.from[static_cast<std::size_t>(i)] < 0) continue;
    const double off_m = (grid.middle(i) - goal_O_m).norm();
    if (off_m >= nearest_m) continue;
    nearest_m = off_m;
    end = i;
  }
  Route out{steps_to(grid, reached, start, end), 0};
  const bool there = nearest_m < kSquare_m;
  if (there) out.steps_O_m.push_back(goal_O_m);
  out.misses_by_m = there ? 0 : nearest_m;
  return out;
}

Route route_to_best(const VisualMemory& memory, double radius_m,
                    const std::function<double(const Vector2d&)>& worth_m) {
  const Grid grid(memory, radius_m);
  const int start = grid.index(grid.here());
  const Reached reached = spread(grid, start);
  int end = start;
  double most_m = 0;
  for (int i = 0; i < kCells * kCells; ++i) {
    if (reached.from[static_cast<std::size_t>(i)] < 0 || !grid.seen(i)) continue;
    const double way_m = reached.cost[static_cast<std::size_t>(i)] * kSquare_m / kFreeCost;
    const double gain_m = worth_m(grid.middle(i)) - way_m;
    if (gain_m <= most_m) continue;
    most_m = gain_m;
    end = i;
  }
  return {steps_to(grid, reached, start, end), 0};
}

}  // namespace mirada::memory
