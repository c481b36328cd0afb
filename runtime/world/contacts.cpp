#include "world/contacts.h"

#include <algorithm>
#include <limits>

namespace mirada::world {
namespace {

using Eigen::Vector2d;

constexpr double kTouch_m = 0.0005;  // nearer than this is a touch
constexpr double kClear_m = 1e-6;    // left between two things after pushing
constexpr Micros kFree = kSecond;    // a contact is over when the robot was free this long
constexpr int kPushes = 8;

Separation nearest(const std::vector<Vector2d>& footprint_W_m, const std::vector<const Shape*>& shapes) {
  Separation out{std::numeric_limits<double>::infinity(), Vector2d::UnitX()};
  for (const Shape* shape : shapes) {
    const Separation s = separation(footprint_W_m, *shape);
    if (s.distance_m < out.distance_m) out = s;
  }
  return out;
}

}  // namespace

Contacts::Contacts(std::vector<Vector2d> footprint_R_m, std::vector<Shape> shapes)
    : footprint_R_m_(std::move(footprint_R_m)) {
  for (const Vector2d& p : footprint_R_m_) reach_m_ = std::max(reach_m_, p.norm());
  for (Shape& shape : shapes) shapes_.push_back(bounded(std::move(shape)));
}

Contacts::Bounded Contacts::bounded(Shape shape) {
  Vector2d middle = Vector2d::Zero();
  for (const Vector2d& p : shape.core_m) middle += p / static_cast<double>(shape.core_m.size());
  double reach = 0;
  for (const Vector2d& p : shape.core_m) reach = std::max(reach, (p - middle).norm());
  reach += shape.radius_m;
  return {std::move(shape), middle, reach};
}

std::vector<const Shape*> Contacts::near(const Pose2& pose, const std::vector<Bounded>& people) const {
  constexpr double kMargin_m = 0.05;
  std::vector<const Shape*> out;
  for (const auto* list : {&shapes_, &people}) {
    for (const Bounded& b : *list) {
      const double reach = b.reach_m + reach_m_ + kMargin_m;
      if ((b.middle_m - Vector2d(pose.x_m, pose.y_m)).squaredNorm() < reach * reach) out.push_back(&b.shape);
    }
  }
  return out;
}

Pose2 Contacts::move(const Pose2& from, const Pose2& wanted, const std::vector<Shape>& people, Micros now) {
  std::vector<Bounded> moving;
  for (const Shape& person : people) moving.push_back(bounded(person));
  const std::vector<const Shape*> shapes = near(wanted, moving);

  Pose2 pose = wanted;
  Separation gap = nearest(transformed(pose, footprint_R_m_), shapes);
  bool touches = gap.distance_m < kTouch_m;
  for (int i = 0; i < kPushes && gap.distance_m < 0; ++i) {
    const Vector2d push = (kClear_m - gap.distance_m) * gap.away;
    pose.x_m += push.x();
    pose.y_m += push.y();
    gap = nearest(transformed(pose, footprint_R_m_), shapes);
  }
  if (gap.distance_m < 0) pose = from;
  note(touches, now);
  return pose;
}

void Contacts::note(bool touches, Micros now) {
  touching_ = touches;
  if (touches) {
    if (!counted_) ++count_;
    counted_ = true;
    last_touch_ = now;
  } else if (counted_ && now - last_touch_ >= kFree) {
    counted_ = false;
  }
}

void Contacts::reset() {
  count_ = 0;
  touching_ = false;
  counted_ = false;
}

}  // namespace mirada::world
