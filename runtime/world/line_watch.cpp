#include "world/line_watch.h"

#include <algorithm>
#include <limits>

#include "world/shapes.h"

namespace mirada::world {
namespace {

using Eigen::Vector2d;

constexpr double kBeyond_m = 0.030;
constexpr Micros kFreeOfLine = kSecond;

/// How far a convex polygon reaches over a segment: the smaller of its two sides' extents, over the stretch
/// that lies beside the segment. Negative when it does not straddle it.
double straddle(const std::vector<Vector2d>& polygon, const Vector2d& a, const Vector2d& b) {
  const double length = (b - a).norm();
  if (length <= 0) return -1;
  const Vector2d along = (b - a) / length;
  const Vector2d left(-along.y(), along.x());
  double high = -std::numeric_limits<double>::infinity();
  double low = std::numeric_limits<double>::infinity();
  const auto take = [&](double t, double side) {
    if (t < 0 || t > length) return;
    high = std::max(high, side);
    low = std::min(low, side);
  };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d p = polygon[i] - a;
    const Vector2d q = polygon[(i + 1) % polygon.size()] - a;
    const double tp = p.dot(along), tq = q.dot(along), sp = p.dot(left), sq = q.dot(left);
    take(tp, sp);
    for (const double end : {0.0, length}) {
      if ((tp < end) != (tq < end)) take(end, sp + (sq - sp) * (end - tp) / (tq - tp));
    }
  }
  return std::min(high, -low);
}

}  // namespace

LineWatch::LineWatch(const std::vector<Vector2d>& footprint_R_m, const std::vector<LineConfig>& lines)
    : footprint_R_m_(footprint_R_m) {
  for (const Vector2d& p : footprint_R_m_) reach_m_ = std::max(reach_m_, p.norm());
  for (const LineConfig& line : lines) {
    Watched watched{line, line.points_m.front(), line.points_m.front()};
    for (const Vector2d& p : line.points_m) {
      watched.low_m = watched.low_m.cwiseMin(p);
      watched.high_m = watched.high_m.cwiseMax(p);
    }
    lines_.push_back(std::move(watched));
  }
}

void LineWatch::look(const Pose2& X_WR, Micros now) {
  const Vector2d at(X_WR.x_m, X_WR.y_m);
  std::vector<Vector2d> footprint;
  for (Watched& w : lines_) {
    double over = -1;
    if ((at - at.cwiseMax(w.low_m).cwiseMin(w.high_m)).norm() <= reach_m_) {
      if (footprint.empty()) footprint = transformed(X_WR, footprint_R_m_);
      for (std::size_t i = 0; i + 1 < w.line.points_m.size(); ++i) {
        over = std::max(over, straddle(footprint, w.line.points_m[i], w.line.points_m[i + 1]));
      }
    }
    if (over > 0) w.last_on = now;
    if (over > kBeyond_m + w.line.width_m / 2 && !w.counted) {
      ++crossings_;
      w.counted = true;
    } else if (over <= 0 && w.counted && now - w.last_on >= kFreeOfLine) {
      w.counted = false;
    }
  }
}

void LineWatch::reset() {
  crossings_ = 0;
  for (Watched& w : lines_) w.counted = false;
}

}  // namespace mirada::world
