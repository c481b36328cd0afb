#include "memory/ways.h"

#include <algorithm>
#include <cmath>

namespace mirada::memory {
namespace {

constexpr double kLeastFree_m = 0.45;
constexpr double kOfFarthest = 0.8;  // a way must be free for this part of the farthest
constexpr int kAll = Surroundings::kDirections;

/// Where the free run that holds direction i begins and ends: [first, first + length).
struct Run {
  int first;
  int length;
};

std::vector<Run> runs_of(const Surroundings& around, double needed_m) {
  const auto open = [&](int i) {
    return around.all()[static_cast<std::size_t>(i % kAll)].free_m >= needed_m;
  };
  int start = 0;
  while (start < kAll && open(start)) ++start;
  if (start == kAll) return {{0, kAll}};
  std::vector<Run> out;
  for (int i = start; i < start + kAll; ++i) {
    if (!open(i)) continue;
    Run run{i, 0};
    while (run.length < kAll && open(run.first + run.length)) ++run.length;
    out.push_back(run);
    i += run.length;
  }
  return out;
}

}  // namespace

std::vector<Way> ways(const VisualMemory& memory, double width_m, double most_m) {
  const Surroundings& around = memory.around();
  double farthest_m = 0;
  for (const Direction& direction : around.all()) farthest_m = std::max(farthest_m, direction.free_m);
  const double needed_m = std::max(kLeastFree_m, kOfFarthest * std::min(farthest_m, most_m));
  std::vector<Way> out;
  for (const Run& run : runs_of(around, needed_m)) {
    Way way;
    const double opening_rad = rad(run.length);
    way.width_m = run.length >= 180 ? 2 * needed_m : 2 * needed_m * std::sin(opening_rad / 2);
    way.bearing_rad = wrap_rad(rad(run.first) + opening_rad / 2 - rad(0.5));
    way.free_m = around.at(way.bearing_rad).free_m;
    const double right_m = around.at(rad(run.first - 2)).distance_m;
    const double left_m = around.at(rad(run.first + run.length + 1)).distance_m;
    way.edge_m = std::min(std::max(right_m, left_m), way.free_m);
    if (way.width_m >= width_m) out.push_back(way);
  }
  return out;
}

std::optional<double> widest_way(const VisualMemory& memory, double width_m, double most_m) {
  const std::vector<Way> all = ways(memory, width_m, most_m);
  const auto best = std::max_element(all.begin(), all.end(),
                                     [](const Way& a, const Way& b) { return a.width_m < b.width_m; });
  return best == all.end() ? std::nullopt : std::optional(best->bearing_rad);
}

std::optional<Way> gap_near(const VisualMemory& memory, double bearing_rad, double width_m, double most_m,
                            double within_rad) {
  const std::vector<Way> all = ways(memory, width_m, most_m);
  const auto off = [&](const Way& way) { return std::abs(wrap_rad(way.bearing_rad - bearing_rad)); };
  const auto best =
      std::min_element(all.begin(), all.end(), [&](const Way& a, const Way& b) { return off(a) < off(b); });
  return best == all.end() || off(*best) > within_rad ? std::nullopt : std::optional(*best);
}

}  // namespace mirada::memory
