#include "memory/segments.h"

#include <algorithm>
#include <cmath>

namespace mirada::memory {
namespace {

using Eigen::Vector2d;
using Chain = std::vector<const ObstaclePoint*>;

constexpr double kLink_m = 0.07;  // two places this near belong together, farther off with their distance
constexpr double kLinkShare = 0.06;
constexpr double kBend_m = 0.025;
constexpr double kSameLine_rad = 0.3;
constexpr std::size_t kOpenChains = 6;  // things one behind the other

struct Placed {
  double bearing_rad;
  double distance_m;
  const ObstaclePoint* point;
};

std::vector<Placed> by_bearing(const std::vector<ObstaclePoint>& points, const Pose2& X_OR) {
  std::vector<Placed> out;
  out.reserve(points.size());
  for (const ObstaclePoint& point : points) {
    const Vector2d to = point.p_O_m - Vector2d(X_OR.x_m, X_OR.y_m);
    out.push_back({wrap_rad(std::atan2(to.y(), to.x()) - X_OR.heading_rad), to.norm(), &point});
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Placed& a, const Placed& b) { return a.bearing_rad < b.bearing_rad; });
  return out;
}

std::vector<Chain> chains_of(const std::vector<Placed>& places) {
  std::vector<Chain> chains;
  for (const Placed& place : places) {
    const double link_m = kLink_m + kLinkShare * place.distance_m;
    Chain* best = nullptr;
    double best_m = link_m;
    const std::size_t first = chains.size() > kOpenChains ? chains.size() - kOpenChains : 0;
    for (std::size_t i = first; i < chains.size(); ++i) {
      const double gap_m = (chains[i].back()->p_O_m - place.point->p_O_m).norm();
      if (gap_m >= best_m) continue;
      best_m = gap_m;
      best = &chains[i];
    }
    if (best == nullptr) best = &chains.emplace_back();
    best->push_back(place.point);
  }
  return chains;
}

/// Where the chain [first, last] bends most; `first` when it is straight within tolerance.
std::size_t bend(const Chain& chain, std::size_t first, std::size_t last) {
  const Vector2d from = chain[first]->p_O_m;
  const Vector2d along = chain[last]->p_O_m - from;
  const double length = along.norm();
  std::size_t worst = first;
  double worst_m = 0;
  for (std::size_t i = first + 1; i < last; ++i) {
    const Vector2d to = chain[i]->p_O_m - from;
    const double off_m =
        length > 1e-6 ? std::abs(along.x() * to.y() - along.y() * to.x()) / length : to.norm();
    const double allowed_m = kBend_m + chain[i]->sigma_m;
    if (off_m <= allowed_m || off_m <= worst_m) continue;
    worst_m = off_m;
    worst = i;
  }
  return worst;
}

Segment piece(const Chain& chain, std::size_t first, std::size_t last, const DriftLedger& drift) {
  Segment out;
  out.from_O_m = chain[first]->p_O_m;
  out.to_O_m = chain[last]->p_O_m;
  out.points = static_cast<int>(last - first + 1);
  const ObstaclePoint& middle = *chain[(first + last) / 2];
  const Vector2d along = out.length_m() > 1e-6 ? Vector2d((out.to_O_m - out.from_O_m).normalized())
                                               : Vector2d(-middle.sight_O.y(), middle.sight_O.x());
  const Vector2d side(-along.y(), along.x());
  out.sigma_m = std::sqrt(side.dot(middle.covariance(drift) * side));
  out.seen_at = chain[first]->seen_at;
  for (std::size_t i = first; i <= last; ++i) out.seen_at = std::min(out.seen_at, chain[i]->seen_at);
  return out;
}

double angle_between(const Segment& a, const Segment& b) {
  const Vector2d u = a.to_O_m - a.from_O_m;
  const Vector2d v = b.to_O_m - b.from_O_m;
  return std::abs(std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v)));
}

void add(std::vector<Segment>& out, const Segment& next, bool same_chain) {
  if (same_chain && out.back().points > 2 && next.points > 2 &&
      angle_between(out.back(), next) < kSameLine_rad) {
    Segment& last = out.back();
    last.to_O_m = next.to_O_m;
    last.points += next.points;
    last.sigma_m = std::max(last.sigma_m, next.sigma_m);
    last.seen_at = std::min(last.seen_at, next.seen_at);
    return;
  }
  out.push_back(next);
}

void split(const Chain& chain, const DriftLedger& drift, std::vector<Segment>& out) {
  const std::size_t before = out.size();
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, chain.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    const std::size_t at = bend(chain, first, last);
    if (at == first) {
      add(out, piece(chain, first, last, drift), out.size() > before);
      continue;
    }
    open.emplace_back(at, last);
    open.emplace_back(first, at);
  }
}

}  // namespace

std::vector<Segment> segments_of(const ObstaclePoints& points, const DriftLedger& drift, const Pose2& X_OR) {
  std::vector<Segment> out;
  for (const Chain& chain : chains_of(by_bearing(points.all(), X_OR))) split(chain, drift, out);
  return out;
}

}  // namespace mirada::memory
