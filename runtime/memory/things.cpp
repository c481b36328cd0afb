#include "memory/things.h"

#include <algorithm>
#include <cmath>

namespace mirada::memory {
namespace {
constexpr double kBearingSigma_rad = rad(1.5);
}

void Things::observe(const ThingSeen& thing, const Pose2& X_OR, Micros t, const DriftLedger& drift) {
  auto known = std::find_if(all_.begin(), all_.end(), [&](const Thing& other) {
    return other.kind == thing.kind && other.id == thing.id;
  });
  if (known == all_.end()) {
    if (all_.size() >= kMost) {
      all_.erase(std::min_element(all_.begin(), all_.end(),
                                  [](const Thing& a, const Thing& b) { return a.seen_at < b.seen_at; }));
    }
    known = all_.insert(all_.end(), Thing{});
  }
  const double angle = X_OR.heading_rad + thing.bearing_rad;
  const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
  const Eigen::Vector2d side(-along.y(), along.x());
  const double across_m = kBearingSigma_rad * thing.distance_m;
  known->kind = thing.kind;
  known->id = thing.id;
  known->p_O_m = Eigen::Vector2d(X_OR.x_m, X_OR.y_m) + thing.distance_m * along;
  known->covariance = thing.sigma_m * thing.sigma_m * along * along.transpose() +
                      across_m * across_m * side * side.transpose();
  known->seen = drift.now();
  known->seen_at = t;
}

void Things::prune(Micros now) {
  std::erase_if(all_, [now](const Thing& thing) { return now - thing.seen_at > kLife; });
}

const Thing* Things::find(ThingKind kind, int id) const {
  const auto found = std::find_if(all_.begin(), all_.end(),
                                  [&](const Thing& thing) { return thing.kind == kind && thing.id == id; });
  return found == all_.end() ? nullptr : &*found;
}

}  // namespace mirada::memory
