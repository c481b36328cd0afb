#include "world/render/scene_view.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirada::world {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kNear_m = 0.003F;  // distances below this count as this
constexpr float kAheadLeast_m = 1e-3F;
constexpr float kEverywhere = 1e9F;

float distance_to_segment(const Vector2f& a, const Vector2f& b) {
  const Vector2f ab = b - a;
  const float length2 = ab.squaredNorm();
  const float along = length2 > 0 ? std::clamp(-a.dot(ab) / length2, 0.0F, 1.0F) : 0.0F;
  return (a + along * ab).norm();
}

bool encloses_origin(const Vector2f* points, std::size_t count) {
  if (count < 3) return false;
  bool left = true, right = true;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector2f& a = points[i];
    const Vector2f& b = points[(i + 1) % count];
    const float cross = a.x() * b.y() - a.y() * b.x();
    left = left && cross >= 0;
    right = right && cross <= 0;
  }
  return left || right;
}

/// The range of left/ahead over a convex outline (points are {ahead, left}), cut off just before the camera's
/// side.
void azimuths(const Vector2f* points, std::size_t count, Directions& out) {
  for (std::size_t i = 0; i < count; ++i) {
    const Vector2f& a = points[i];
    const Vector2f& b = points[(i + 1) % count];
    const auto take = [&](const Vector2f& p) {
      out.q_low = std::min(out.q_low, p.y() / p.x());
      out.q_high = std::max(out.q_high, p.y() / p.x());
    };
    if (a.x() >= kAheadLeast_m) take(a);
    if ((a.x() < kAheadLeast_m) != (b.x() < kAheadLeast_m)) {
      const float share = (kAheadLeast_m - a.x()) / (b.x() - a.x());
      take({kAheadLeast_m, a.y() + share * (b.y() - a.y())});
    }
  }
}

/// The same of a disc.
void disc_azimuths(const Vector2f& middle, float reach, Directions& out) {
  const float distance = middle.norm();
  if (distance <= reach * 1.001F) {
    out.q_low = -kEverywhere;
    out.q_high = kEverywhere;
    return;
  }
  const float towards = std::atan2(middle.y(), middle.x());
  const float half = std::asin(reach / distance);
  constexpr float kSide = 1.5697F;  // just below a right angle
  if (towards - half > kSide || towards + half < -kSide) return;
  out.q_low = towards - half < -kSide ? -kEverywhere : std::tan(towards - half);
  out.q_high = towards + half > kSide ? kEverywhere : std::tan(towards + half);
}

}  // namespace

SceneView::SceneView(const Stage& stage_seen) : stage(&stage_seen) {}

void SceneView::look(const RayTable& rays, const Eigen::Isometry3d& X_WC, const std::vector<Pose2>& people) {
  rotation = X_WC.linear().cast<float>();
  at_m = X_WC.translation().cast<float>();
  pixel_x = 1 / rays.fx_px;
  pixel_y = 1 / rays.fy_px;
  // Looking straight down or up the picture's own up serves as heading.
  Vector2f ahead = rotation.col(2).head<2>();
  if (ahead.norm() < 0.05F) ahead = -rotation.col(1).head<2>();
  ahead.normalize();
  ahead_x = ahead.x();
  ahead_y = ahead.y();
  items.clear();
  seen.clear();
  view_quads();
  view_rounds(people);
}

void SceneView::view_quads() {
  quads.resize(stage->quads.size());
  for (std::size_t i = 0; i < quads.size(); ++i) {
    const Quad& quad = stage->quads[i];
    QuadView& view = quads[i];
    const Vector3f from = quad.corner_m - at_m;
    view.plane = quad.normal.dot(from);
    if (view.plane >= -1e-5F) continue;
    view.normal_C = rotation.transpose() * quad.normal;
    view.right_C = rotation.transpose() * quad.right;
    view.down_C = rotation.transpose() * quad.down;
    view.right0 = -quad.right.dot(from);
    view.down0 = -quad.down.dot(from);
    const Vector2f corner = quad.corner_m.head<2>();
    const Vector2f across = quad.right.head<2>() * quad.width_m;
    const Vector2f back = quad.down.head<2>() * quad.height_m;
    const bool upright = quad.normal.z() == 0;
    const std::array<Vector2f, 4> foot = {corner, corner + across, corner + across + back, corner + back};
    add_item(i, foot.data(), upright ? 2 : 4, 0,
             upright ? quad.corner_m.z() - quad.height_m : quad.corner_m.z(), quad.corner_m.z());
  }
}

void SceneView::view_rounds(const std::vector<Pose2>& people) {
  rounds = stage->rounds;
  for (std::size_t i = 0; i < rounds.size(); ++i) {
    Round& round = rounds[i];
    if (round.person >= 0) {
      const Pose2& pose = people[static_cast<std::size_t>(round.person)];
      round.x_m = static_cast<float>(pose.x_m);
      round.y_m = static_cast<float>(pose.y_m);
      round.heading_rad = static_cast<float>(pose.heading_rad);
    }
    round.ahead_x = std::cos(round.heading_rad);
    round.ahead_y = std::sin(round.heading_rad);
    if (round.cap && round.high_m >= at_m.z()) continue;
    const Vector2f middle(round.x_m, round.y_m);
    add_item(quads.size() + i, &middle, 1, round.reach_m, round.cap ? round.high_m : round.low_m,
             round.high_m);
  }
}

void SceneView::add_item(std::size_t item, const Vector2f* foot_m, std::size_t count, float reach_m,
                         float low_m, float high_m) {
  std::array<Vector2f, 4> points = {Vector2f::Zero(), Vector2f::Zero(), Vector2f::Zero(),
                                    Vector2f::Zero()};  // {ahead, left} of the camera
  float nearest = kEverywhere;
  float farthest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector2f p = foot_m[i] - at_m.head<2>();
    points[i] = {p.x() * ahead_x + p.y() * ahead_y, p.y() * ahead_x - p.x() * ahead_y};
    farthest = std::max(farthest, p.norm());
  }
  for (std::size_t i = 0; i < count; ++i) {
    nearest = std::min(nearest, distance_to_segment(points[i], points[(i + 1) % count]));
  }
  Directions out{kEverywhere, -kEverywhere, 0, 0, 0};
  if (reach_m > 0) {
    disc_azimuths(points[0], reach_m, out);
  } else {
    azimuths(points.data(), count, out);
  }
  if (encloses_origin(points.data(), count)) nearest = 0;
  out.nearest_m = std::max(nearest - reach_m, kNear_m);
  farthest += reach_m;
  const float low = low_m - at_m.z();
  const float high = high_m - at_m.z();
  out.s_low = low / (low < 0 ? out.nearest_m : farthest);
  out.s_high = high / (high > 0 ? out.nearest_m : farthest);
  items.push_back(static_cast<std::uint16_t>(item));
  seen.push_back(out);
}

}  // namespace mirada::world
