#include "world/render/stage.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <opencv2/imgproc.hpp>

#include "world/render/paint.h"
#include "world/shapes.h"

namespace mirada::world {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3f;

constexpr double kFloorMargin_m = 0.2;    // floor beyond the bounds, for filtering at their edge
constexpr double kMostFloorTexels = 4e6;  // one room's floor, level 0
constexpr double kFinestFloor_per_m = 500;

double texels_per_m(double length_m, double wanted_per_m, double most_px) {
  return std::min(wanted_per_m, most_px / std::max(length_m, 0.01));
}

Vector3f flat(const Vector2d& v, double z = 0) { return {float(v.x()), float(v.y()), float(z)}; }

/// Whether any of the room lies to the right of a line from a to b: a face that looks out of it is never
/// seen.
bool in_view(const Bounds& bounds, const Vector2d& a, const Vector2d& b) {
  const Vector2d right(b.y() - a.y(), a.x() - b.x());
  for (const double x : {bounds.min_x_m, bounds.max_x_m}) {
    for (const double y : {bounds.min_y_m, bounds.max_y_m}) {
      if (right.dot(Vector2d(x, y) - a) > 1e-6) return true;
    }
  }
  return false;
}

cv::Vec3f tint(const Lamp& lamp) { return {lamp.tint_bgr.x(), lamp.tint_bgr.y(), lamp.tint_bgr.z()}; }

}  // namespace

Lamp lamp_of(const LightConfig& light) {
  const double c = std::cos(light.elevation_rad);
  const Vector3f towards(float(c * std::cos(light.from_rad)), float(c * std::sin(light.from_rad)),
                         float(std::sin(light.elevation_rad)));
  return {towards, float(light.ambient), float(light.level),
          Vector3f(light.colour.b, light.colour.g, light.colour.r) / 255.0F};
}

Stage::Stage(const WorldConfig& placed, std::uint64_t seed) : lamp(lamp_of(placed.light)) {
  add_floor(placed, seed);
  add_walls(placed, seed);
  add_boxes(placed, seed);
  add_cylinders(placed, seed);
  add_tags(placed);
  add_people(placed, seed);
  add_sky(placed);
}

std::size_t Stage::keep(const cv::Mat& bgr) {
  textures.emplace_back(bgr);
  return textures.size() - 1;
}

void Stage::add_floor(const WorldConfig& world, std::uint64_t seed) {
  const Bounds& b = world.bounds;
  const double wide = b.max_x_m - b.min_x_m + 2 * kFloorMargin_m;
  const double deep = b.max_y_m - b.min_y_m + 2 * kFloorMargin_m;
  const double per_m = std::min(kFinestFloor_per_m, std::sqrt(kMostFloorTexels / (wide * deep)));
  const paint::FloorFrame frame{b.min_x_m - kFloorMargin_m, b.max_y_m + kFloorMargin_m, per_m};
  Random random(seed, "floor paint");
  cv::Mat floor =
      paint::floor_pattern(world.floor, {cvCeil(wide * per_m), cvCeil(deep * per_m)}, per_m, random);
  paint::paint_lines(floor, frame, world.lines, random);
  paint::light_gradient(floor, world.light);
  paint::cast_shadows(floor, frame, world);
  paint::light(floor, lamp.on(Vector3f::UnitZ()), tint(lamp));
  floor_min_x_m = float(frame.min_x_m);
  floor_max_y_m = float(frame.max_y_m);
  floor_texels_per_m = float(per_m);
  floor_texture = keep(floor);
}

void Stage::upright(const Vector2d& a, const Vector2d& b, double height_m, const cv::Mat& bgr) {
  const double length = (b - a).norm();
  if (length <= 0) return;
  const Vector2d along = (b - a) / length;
  const Vector3f normal = flat({along.y(), -along.x()});
  cv::Mat lit = bgr.clone();
  paint::light(lit, lamp.on(normal), tint(lamp));
  quads.push_back({flat(a, height_m), flat(along), -Vector3f::UnitZ(), normal, float(length), float(height_m),
                   keep(lit)});
}

void Stage::add_walls(const WorldConfig& world, std::uint64_t seed) {
  Random random(seed, "wall paint");
  for (const WallConfig& wall : world.walls) {
    for (std::size_t i = 0; i + 1 < wall.points_m.size(); ++i) {
      const Vector2d& a = wall.points_m[i];
      const Vector2d& b = wall.points_m[i + 1];
      const double length = (b - a).norm();
      const double per_m = texels_per_m(std::max(length, wall.height_m), 250, 1500);
      const cv::Mat side = paint::wall(wall, length, per_m, random);
      if (in_view(world.bounds, a, b)) upright(a, b, wall.height_m, side);
      if (in_view(world.bounds, b, a)) upright(b, a, wall.height_m, side);
    }
  }
}

void Stage::add_boxes(const WorldConfig& world, std::uint64_t seed) {
  Random random(seed, "box paint");
  for (const BoxConfig& box : world.boxes) {
    const double per_m = texels_per_m(std::max({box.length_m, box.width_m, box.height_m}), 500, 512);
    const std::vector<Vector2d> foot = rectangle(box.X_WB, box.length_m, box.width_m);
    for (std::size_t i = 0; i < 4; ++i) {
      const double length = i % 2 == 0 ? box.width_m : box.length_m;
      upright(foot[i], foot[(i + 1) % 4], box.height_m, paint::box_side(box, length, per_m, random));
    }
    cv::Mat top = paint::box_top(box, per_m, random);
    paint::light(top, lamp.on(Vector3f::UnitZ()), tint(lamp));
    const Vector2d x(std::cos(box.X_WB.heading_rad), std::sin(box.X_WB.heading_rad));
    quads.push_back({flat(foot[2], box.height_m), flat(x), flat({x.y(), -x.x()}), Vector3f::UnitZ(),
                     float(box.length_m), float(box.width_m), keep(top)});
  }
}

void Stage::add_tags(const WorldConfig& world) {
  constexpr double kPaper_m = 0.004;  // in front of what it hangs on
  for (const TagConfig& config : world.tags) {
    const double side = config.size_m * paint::kTagCells / (paint::kTagCells - 2);
    const Vector2d ahead(std::cos(config.X_WT.heading_rad), std::sin(config.X_WT.heading_rad));
    const Vector2d along(-ahead.y(), ahead.x());
    const Vector2d corner = Vector2d(config.X_WT.x_m, config.X_WT.y_m) + kPaper_m * ahead - side / 2 * along;
    cv::Mat print = paint::tag(config.id);
    paint::light(print, lamp.on(flat(ahead)), tint(lamp));
    quads.push_back({flat(corner, config.z_m + side / 2), flat(along), -Vector3f::UnitZ(), flat(ahead),
                     float(side), float(side), keep(print)});
  }
}

void Stage::tube(const Vector2d& at, double radius_m, double low_m, double high_m, const cv::Mat& bgr) {
  Round side{};
  side.x_m = float(at.x());
  side.y_m = float(at.y());
  side.a = float(radius_m * radius_m);
  side.low_m = float(low_m);
  side.high_m = float(high_m);
  side.reach_m = float(radius_m);
  side.texture = keep(bgr);
  rounds.push_back(side);
}

void Stage::add_cylinders(const WorldConfig& world, std::uint64_t seed) {
  Random random(seed, "cylinder paint");
  for (const CylinderConfig& c : world.cylinders) {
    const double per_m = texels_per_m(std::max(6.3 * c.radius_m, c.height_m), 400, 700);
    const bool plant = c.look == CylinderLook::plant;
    CylinderConfig pot = c;
    if (plant) pot.height_m = std::min(c.height_m * 0.45, 0.35);
    tube(c.p_W_m, c.radius_m, 0, pot.height_m, paint::cylinder(pot, per_m, random));
    Round cap = rounds.back();
    cap.cap = true;
    cap.texture = keep(paint::plain({8, 8}, plant ? Colour{72, 54, 40} : paint::shade(c.colour, 1.05)));
    rounds.push_back(cap);
    if (!plant) continue;
    Round crown = rounds[rounds.size() - 2];
    const double middle = (pot.height_m + c.height_m) / 2;
    const double half = c.height_m - middle + 0.02;
    const double flatness = c.radius_m * c.radius_m / (half * half);
    crown.a = float(c.radius_m * c.radius_m - flatness * middle * middle);
    crown.b = float(2 * flatness * middle);
    crown.c = float(-flatness);
    crown.low_m = float(pot.height_m);
    crown.high_m = float(c.height_m + 0.02);
    crown.texture = keep(paint::leaves({512, 256}, {70, 128, 62}, random));
    rounds.push_back(crown);
  }
}

void Stage::add_people(const WorldConfig& world, std::uint64_t seed) {
  Random random(seed, "person paint");
  int index = 0;
  for (const PersonConfig& person : world.people) {
    const double h = person.height_m;
    const double r = person.radius_m;
    const std::size_t first = rounds.size();
    const Vector2d at(person.X_WP.x_m, person.X_WP.y_m);
    tube(at, r, 0, 0.5 * h, paint::clothes(person, 0, 0.5, random));
    // Heads differ little in size, whatever the height (docs/faces.md); a doll's is smaller.
    const double head_size = 0.93 + 0.055 * h;
    const double rz = std::min(0.12 * head_size, 0.145 * h);
    const double rx = std::min(0.095 * head_size, 0.114 * h);
    // Shoulders: an ellipsoid's upper half on the trunk, up to the chin.
    const double top = h - 2 * rz + 0.05 * std::min(h, 1.2);
    tube(at, r, 0.5 * h, top, paint::clothes(person, 0.5, top / h, random));
    Round& shoulders = rounds.back();
    const double rise = top - 0.5 * h;
    const double k = r * r / (rise * rise);
    shoulders.a = float(r * r - k * 0.25 * h * h);
    shoulders.b = float(k * h);
    shoulders.c = float(-k);
    Round head = rounds.back();
    const double middle = h - rz;
    const double q = rx * rx / (rz * rz);
    head.a = float(rx * rx - q * middle * middle);
    head.b = float(2 * q * middle);
    head.c = float(-q);
    head.low_m = float(middle - rz);
    head.high_m = float(h);
    head.reach_m = float(rx);
    head.head = true;
    head.texture = keep(paint::face(person, random));
    head.back_texture = keep(paint::head_back(person, random));
    rounds.push_back(head);
    for (std::size_t i = first; i < rounds.size(); ++i) {
      rounds[i].person = index;
      rounds[i].heading_rad = float(person.X_WP.heading_rad);
    }
    ++index;
  }
}

void Stage::add_sky(const WorldConfig& world) {
  const auto steps = static_cast<int>(kSkySteps * 2);
  const double level = std::min(1.0, 0.4 + 0.6 * world.light.level);
  for (int i = 0; i < steps; ++i) {
    const double up = std::min(1.0, i / (steps * 0.4));
    const Colour c = paint::shade(paint::mix(world.background.horizon, world.background.zenith, up), level);
    sky.push_back(0xFF000000U | (std::uint32_t{c.r} << 16) | (std::uint32_t{c.g} << 8) | c.b);
  }
}

}  // namespace mirada::world
