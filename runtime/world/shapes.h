#pragma once
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "model/geometry.h"
#include "world/world_config.h"

namespace mirada::world {

/// What stands on the floor, seen from above: a point, a segment or a convex counter-clockwise polygon, grown
/// by a radius.
struct Shape {
  std::vector<Eigen::Vector2d> core_m;
  double radius_m = 0;
};

Shape shape_of(const BoxConfig& box);
Shape shape_of(const CylinderConfig& cylinder);
Shape shape_of(const PersonConfig& person);
/// One shape a segment.
std::vector<Shape> shapes_of(const WallConfig& wall);

/// How a convex polygon and a shape lie to each other.
struct Separation {
  double distance_m = 0;                            ///< negative: the depth that they overlap by
  Eigen::Vector2d away = Eigen::Vector2d::UnitX();  ///< unit vector that moves the polygon out of the shape
};

/// `polygon_m` is convex and counter-clockwise, in the same frame as the shape; at least one point.
Separation separation(const std::vector<Eigen::Vector2d>& polygon_m, const Shape& shape);

/// The corners of a rectangle length (x) by width (y) about a pose, counter-clockwise, in the pose's parent
/// frame.
std::vector<Eigen::Vector2d> rectangle(const Pose2& X_WB, double length_m, double width_m);

/// Points of one frame in its parent's.
std::vector<Eigen::Vector2d> transformed(const Pose2& X_AB, const std::vector<Eigen::Vector2d>& points_B_m);

}  // namespace mirada::world
