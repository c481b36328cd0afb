#include "rig/lab/lab_truth.h"

#include <cmath>
#include <limits>

#include "world/shapes.h"

namespace mirada::rig {
namespace {

using Eigen::Vector2d;

constexpr double kNever = std::numeric_limits<double>::infinity();

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

double to_edge_m(const Vector2d& from, const Vector2d& along, const Vector2d& a, const Vector2d& b) {
  const Vector2d side = b - a;
  const double turn = cross(along, side);
  if (std::abs(turn) < 1e-12) return kNever;
  const double reach = cross(a - from, side) / turn;
  const double where = cross(a - from, along) / turn;
  return reach >= 0 && where >= 0 && where <= 1 ? reach : kNever;
}

double to_circle_m(const Vector2d& from, const Vector2d& along, const Vector2d& middle, double radius_m) {
  const Vector2d to = middle - from;
  const double ahead = to.dot(along);
  const double inside = radius_m * radius_m - (to.squaredNorm() - ahead * ahead);
  if (inside < 0) return kNever;
  const double reach = ahead - std::sqrt(inside);
  return reach >= 0 ? reach : kNever;
}

}  // namespace

LabTruth::LabTruth(const world::WorldConfig& room) {
  for (const auto& cylinder : room.cylinders) circles_.push_back({cylinder.p_W_m, cylinder.radius_m});
  std::vector<world::Shape> shapes;
  for (const auto& box : room.boxes) shapes.push_back(world::shape_of(box));
  for (const auto& wall : room.walls) {
    for (world::Shape& shape : world::shapes_of(wall)) shapes.push_back(std::move(shape));
  }
  for (const world::Shape& shape : shapes) {
    for (std::size_t i = 0; i < shape.core_m.size(); ++i) {
      edges_.push_back({shape.core_m[i], shape.core_m[(i + 1) % shape.core_m.size()]});
    }
  }
}

double LabTruth::distance_m(const Pose2& X_WR, double bearing_rad) const {
  const Vector2d from(X_WR.x_m, X_WR.y_m);
  const double heading_rad = X_WR.heading_rad + bearing_rad;
  const Vector2d along(std::cos(heading_rad), std::sin(heading_rad));
  double nearest_m = kNever;
  for (const Edge& edge : edges_) nearest_m = std::min(nearest_m, to_edge_m(from, along, edge.a, edge.b));
  for (const Circle& circle : circles_) {
    nearest_m = std::min(nearest_m, to_circle_m(from, along, circle.middle, circle.radius_m));
  }
  return nearest_m;
}

}  // namespace mirada::rig
