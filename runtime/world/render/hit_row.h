#pragma once
#include "world/render/floor_row.h"
#include "world/render/scene_view.h"

namespace mirada::world {

/// What eight rays meet first, each as SceneView::hit finds it.
class HitRow {
 public:
  static constexpr int kRays = 8;

  /// Rays (x, y, 1) and the items that they may meet. Not called for rays behind the camera.
  MIRADA_LANES void find(const SceneView& view, const float* x, const float* y, const std::uint16_t* items,
                         std::size_t count) {
    aim(view, load_lanes<Floats>(x), load_lanes<Floats>(y));
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t item = items[i];
      if (item < view.quads.size()) {
        meet_quad(view, item);
      } else if (const Round& round = view.rounds[item - view.quads.size()]; round.cap) {
        meet_cap(view, round, item);
      } else {
        meet_round(view, round, item);
      }
    }
  }

  int id(int ray) const { return id_[ray]; }
  SceneView::Hit hit(int ray) const { return {id_[ray], t_[ray], u_[ray], v_[ray]}; }
  struct Places {
    Floats x_m, y_m, z_m;
  };
  /// Where the rays meet it, W frame.
  MIRADA_LANES Places places(const SceneView& view) const {
    return {view.at_m.x() + t_ * dx_, view.at_m.y() + t_ * dy_, view.at_m.z() + t_ * dz_};
  }
  /// The rays, a bit each, that meet the same as this one.
  MIRADA_LANES unsigned like(int ray) const { return bits(id_ == id_[ray]); }
  /// The rays, a bit each, that meet the ground where the floor's texture lies.
  MIRADA_LANES unsigned on_map(const FloorRow::Scene& floor) const {
    return bits(floor.covers(at_x_m_ + t_ * dx_, at_y_m_ + t_ * dy_));
  }

 private:
  MIRADA_LANES static unsigned bits(Ints where) {
    unsigned out = 0;
    for (int i = 0; i < kRays; ++i) out |= static_cast<unsigned>(where[i] & 1) << i;
    return out;
  }

  MIRADA_LANES void aim(const SceneView& view, Floats x, Floats y) {
    x_ = x;
    y_ = y;
    at_x_m_ = view.at_m.x();
    at_y_m_ = view.at_m.y();
    const Eigen::Matrix3f& r = view.rotation;
    dx_ = r(0, 0) * x + r(0, 1) * y + r(0, 2);
    dy_ = r(1, 0) * x + r(1, 1) * y + r(1, 2);
    dz_ = r(2, 0) * x + r(2, 1) * y + r(2, 2);
    const Ints down = dz_ < -1e-6F;
    t_ = down ? -view.at_m.z() / dz_ : all_lanes(1e9F);
    id_ = down ? all_lanes(SceneView::kFloor) : all_lanes(SceneView::kSky);
    u_ = v_ = all_lanes(0.0F);
  }

  MIRADA_LANES void take(Ints where, std::size_t item, Floats t) {
    t_ = where ? t : t_;
    id_ = where ? all_lanes(static_cast<int>(item) + SceneView::kFirstItem) : id_;
  }

  MIRADA_LANES void meet_quad(const SceneView& view, std::size_t item) {
    const QuadView& q = view.quads[item];
    const Quad& quad = view.stage->quads[item];
    const Floats towards = q.normal_C.x() * x_ + q.normal_C.y() * y_ + q.normal_C.z();
    const Floats t = q.plane / towards;
    const Floats u = q.right0 + t * (q.right_C.x() * x_ + q.right_C.y() * y_ + q.right_C.z());
    const Floats v = q.down0 + t * (q.down_C.x() * x_ + q.down_C.y() * y_ + q.down_C.z());
    const Ints here =
        (towards < -1e-7F) & (t < t_) & (u >= 0) & (u <= quad.width_m) & (v >= 0) & (v <= quad.height_m);
    take(here, item, t);
    u_ = here ? u : u_;
    v_ = here ? v : v_;
  }

  MIRADA_LANES void meet_cap(const SceneView& view, const Round& round, std::size_t item) {
    const Floats t = (round.high_m - view.at_m.z()) / dz_;
    const Floats px = (view.at_m.x() - round.x_m) + t * dx_;
    const Floats py = (view.at_m.y() - round.y_m) + t * dy_;
    take((dz_ < 0) & (px * px + py * py <= round.a) & (t >= SceneView::kNearest) & (t < t_), item, t);
  }

  MIRADA_LANES void meet_round(const SceneView& view, const Round& round, std::size_t item) {
    const float ox = view.at_m.x() - round.x_m;
    const float oy = view.at_m.y() - round.y_m;
    const float h = view.at_m.z();
    const Floats a = dx_ * dx_ + dy_ * dy_ - round.c * dz_ * dz_;
    const Floats b = ox * dx_ + oy * dy_ - (round.b / 2 + round.c * h) * dz_;
    const float c = ox * ox + oy * oy - round.a - h * (round.b + round.c * h);
    const Floats disc = b * b - a * c;
    const Floats t = (-b - root(most(disc, all_lanes(0.0F)))) / a;
    const Floats z = h + t * dz_;
    take((disc >= 0) & (a > 0) & (z >= round.low_m) & (z <= round.high_m) & (t >= SceneView::kNearest) &
             (t < t_),
         item, t);
  }

  Floats x_, y_, dx_, dy_, dz_;
  Floats t_, u_, v_;
  Ints id_;
  float at_x_m_, at_y_m_;
};

}  // namespace mirada::world
