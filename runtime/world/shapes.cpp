#include "world/shapes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace mirada::world {
namespace {

using Eigen::Vector2d;
using Points = std::vector<Vector2d>;

Vector2d nearest_on_segment(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d ab = b - a;
  const double length2 = ab.squaredNorm();
  if (length2 <= 0) return a;
  return a + std::clamp((p - a).dot(ab) / length2, 0.0, 1.0) * ab;
}

struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

Interval extent(const Points& points, const Vector2d& axis) {
  Interval out;
  for (const Vector2d& p : points) {
    const double along = p.dot(axis);
    out.low = std::min(out.low, along);
    out.high = std::max(out.high, along);
  }
  return out;
}

/// Separating-axis test on the edges of `edges_of`: keeps the axis along which leaving `other` is shortest.
void least_overlap(const Points& edges_of, const Points& polygon, const Points& other, Separation& best) {
  const std::size_t n = edges_of.size();
  for (std::size_t i = 0; i < n && n > 1; ++i) {
    const Vector2d edge = edges_of[(i + 1) % n] - edges_of[i];
    if (edge.squaredNorm() <= 0) continue;
    const Vector2d normal = Vector2d(edge.y(), -edge.x()).normalized();
    for (const Vector2d& axis : {normal, Vector2d(-normal)}) {
      const double gap = extent(polygon, axis).low - extent(other, axis).high;
      if (gap > best.distance_m) best = {gap, axis};
    }
  }
}

void nearest_feature(const Points& corners, const Points& edges_of, double sign, Separation& best) {
  const std::size_t n = edges_of.size();
  for (const Vector2d& corner : corners) {
    for (std::size_t i = 0; i < n; ++i) {
      const Vector2d towards = corner - nearest_on_segment(corner, edges_of[i], edges_of[(i + 1) % n]);
      const double distance = towards.norm();
      if (distance < best.distance_m && distance > 0) best = {distance, sign * towards / distance};
    }
  }
}

}  // namespace

Shape shape_of(const BoxConfig& box) { return {rectangle(box.X_WB, box.length_m, box.width_m), 0}; }
Shape shape_of(const CylinderConfig& cylinder) { return {{cylinder.p_W_m}, cylinder.radius_m}; }
Shape shape_of(const PersonConfig& person) {
  return {{Vector2d(person.X_WP.x_m, person.X_WP.y_m)}, person.radius_m};
}

std::vector<Shape> shapes_of(const WallConfig& wall) {
  std::vector<Shape> out;
  for (std::size_t i = 0; i + 1 < wall.points_m.size(); ++i) {
    out.push_back({{wall.points_m[i], wall.points_m[i + 1]}, 0});
  }
  return out;
}

Separation separation(const Points& polygon_m, const Shape& shape) {
  assert(!polygon_m.empty() && !shape.core_m.empty());
  Separation out{-std::numeric_limits<double>::infinity(), Vector2d::UnitX()};
  least_overlap(polygon_m, polygon_m, shape.core_m, out);
  least_overlap(shape.core_m, polygon_m, shape.core_m, out);
  if (out.distance_m > 0 || !std::isfinite(out.distance_m)) {
    out.distance_m = std::numeric_limits<double>::infinity();
    nearest_feature(polygon_m, shape.core_m, 1.0, out);
    nearest_feature(shape.core_m, polygon_m, -1.0, out);
  }
  out.distance_m -= shape.radius_m;
  return out;
}

Points rectangle(const Pose2& X_WB, double length_m, double width_m) {
  const double x = length_m / 2;
  const double y = width_m / 2;
  return transformed(X_WB, {{x, -y}, {x, y}, {-x, y}, {-x, -y}});
}

Points transformed(const Pose2& X_AB, const Points& points_B_m) {
  const double c = std::cos(X_AB.heading_rad);
  const double s = std::sin(X_AB.heading_rad);
  Points out;
  out.reserve(points_B_m.size());
  for (const Vector2d& p : points_B_m) {
    out.emplace_back(X_AB.x_m + c * p.x() - s * p.y(), X_AB.y_m + s * p.x() + c * p.y());
  }
  return out;
}

}  // namespace mirada::world
