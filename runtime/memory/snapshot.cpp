#include "memory/snapshot.h"

#include <cmath>

namespace mirada::memory {
namespace {
constexpr std::size_t kEvery = 5;  // directions
}

Snapshot snapshot_of(const VisualMemory& memory) {
  Snapshot out;
  out.version = memory.version();
  out.X_OR = memory.X_OR();
  out.now = memory.now();
  out.places.reserve(memory.points().all().size());
  for (const ObstaclePoint& point : memory.points().all()) {
    const double sigma_m = std::sqrt(point.covariance(memory.drift()).trace() / 2);
    out.places.push_back({point.p_O_m, sigma_m, memory.now() - point.seen_at});
  }
  for (const Thing& thing : memory.things().all()) {
    const Eigen::Matrix2d now = thing.covariance + memory.drift().covariance(thing.seen, thing.p_O_m);
    out.things.push_back(
        {thing.kind, thing.id, thing.p_O_m, std::sqrt(now.trace() / 2), memory.now() - thing.seen_at});
  }
  for (Segment& segment : segments_of(memory.points(), memory.drift(), memory.X_OR())) {
    if (segment.points > 1) out.segments.push_back(std::move(segment));
  }
  const auto& all = memory.around().all();
  for (std::size_t i = 0; i < all.size(); i += kEvery) out.free_m.push_back(all[i].free_m);
  return out;
}

}  // namespace mirada::memory
