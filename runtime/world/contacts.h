#pragma once
#include <vector>

#include <Eigen/Core>

#include "base/units.h"
#include "world/shapes.h"

namespace mirada::world {

/// Keeps the robot out of what stands in the room and counts contacts (counted once until free for 1.0 s).
class Contacts {
 public:
  Contacts(std::vector<Eigen::Vector2d> footprint_R_m, std::vector<Shape> shapes);

  /// Where the robot ends up that wanted to go from one pose to another: pushed out of whatever it would
  /// enter, or left where it was. `people` are shapes that may have moved.
  Pose2 move(const Pose2& from, const Pose2& wanted, const std::vector<Shape>& people, Micros now);
  void reset();

  int count() const { return count_; }
  bool touching() const { return touching_; }
  /// Everything of the footprint lies within this radius of the robot's origin.
  double reach_m() const { return reach_m_; }

 private:
  struct Bounded {
    Shape shape;
    Eigen::Vector2d middle_m;
    double reach_m;
  };
  static Bounded bounded(Shape shape);
  std::vector<const Shape*> near(const Pose2& pose, const std::vector<Bounded>& people) const;
  void note(bool touches, Micros now);

  std::vector<Eigen::Vector2d> footprint_R_m_;
  std::vector<Bounded> shapes_;
  double reach_m_ = 0;
  int count_ = 0;
  bool touching_ = false;
  bool counted_ = false;  ///< the present contact has been counted
  Micros last_touch_ = 0;
};

}  // namespace mirada::world
