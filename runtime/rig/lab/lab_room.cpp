#include "rig/lab/lab_room.h"

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "base/units.h"
#include "world/shapes.h"

namespace mirada::rig {
namespace {

using world::FloorKind;

constexpr double kRoomForRobot_m = 0.25;
constexpr int kStands = 4;
constexpr int kTries = 300;

constexpr std::pair<LabLight, const char*> kLights[] = {
    {LabLight::even, "even"}, {LabLight::side, "side"}, {LabLight::dim, "dim"}};
constexpr std::pair<FloorKind, const char*> kFloors[] = {
    {FloorKind::plain, "plain"}, {FloorKind::carpet, "carpet"},     {FloorKind::wood, "wood"},
    {FloorKind::tiles, "tiles"}, {FloorKind::concrete, "concrete"}, {FloorKind::grass, "grass"}};

std::uint8_t channel(double value) { return static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0)); }

/// A colour of this brightness; `colourful` is how far the channels part.
world::Colour any_colour(Random& random, double darkest, double brightest, double colourful) {
  const double light = random.uniform(darkest, brightest);
  return {channel(light + random.uniform(-colourful, colourful)),
          channel(light + random.uniform(-colourful, colourful)),
          channel(light + random.uniform(-colourful, colourful))};
}

world::FloorConfig any_floor(FloorKind kind, Random& random) {
  world::FloorConfig floor;
  floor.kind = kind;
  switch (kind) {
    case FloorKind::grass: {
      const double light = random.uniform(80, 130);
      floor.colour = {channel(light * 0.6), channel(light), channel(light * 0.5)};
      break;
    }
    case FloorKind::wood: {
      const double light = random.uniform(110, 200);
      floor.colour = {channel(light), channel(light * random.uniform(0.7, 0.85)),
                      channel(light * random.uniform(0.4, 0.65))};
      break;
    }
    default:
      floor.colour = any_colour(random, 90, 200, 25);
  }
  floor.scale = random.uniform(0.7, 1.4);
  floor.contrast = random.uniform(0.6, 1.1);
  return floor;
}

world::LightConfig any_light(LabLight kind, Random& random) {
  world::LightConfig light;
  light.from_rad = random.uniform(-std::numbers::pi, std::numbers::pi);
  switch (kind) {
    case LabLight::even:
      light.level = random.uniform(0.9, 1.1);
      light.ambient = random.uniform(0.7, 0.85);
      light.gradient = random.uniform(0, 0.2);
      light.shadow = random.uniform(0.05, 0.25);
      break;
    case LabLight::side:
      light.level = random.uniform(0.9, 1.15);
      light.elevation_rad = random.uniform(0.45, 0.9);
      light.ambient = random.uniform(0.45, 0.6);
      light.gradient = random.uniform(0.2, 0.45);
      light.shadow = random.uniform(0.45, 0.65);
      break;
    case LabLight::dim:
      light.level = random.uniform(0.4, 0.6);
      light.colour = any_colour(random, 215, 240, 15);
      light.ambient = random.uniform(0.6, 0.75);
      light.gradient = random.uniform(0.1, 0.3);
      light.shadow = random.uniform(0.2, 0.4);
      break;
  }
  return light;
}

std::vector<world::Shape> shapes_in(const world::WorldConfig& room) {
  std::vector<world::Shape> out;
  for (const auto& wall : room.walls) {
    for (world::Shape& shape : world::shapes_of(wall)) out.push_back(std::move(shape));
  }
  for (const auto& box : room.boxes) out.push_back(world::shape_of(box));
  for (const auto& cylinder : room.cylinders) out.push_back(world::shape_of(cylinder));
  return out;
}

bool free_at(const Eigen::Vector2d& p_W_m, double radius_m, const std::vector<world::Shape>& shapes) {
  const std::vector<Eigen::Vector2d> square =
      world::rectangle({p_W_m.x(), p_W_m.y(), 0}, 2 * radius_m, 2 * radius_m);
  return std::all_of(shapes.begin(), shapes.end(), [&](const world::Shape& shape) {
    return world::separation(square, shape).distance_m > 0;
  });
}

void add_walls(world::WorldConfig& room, double half_x_m, double half_y_m, Random& random) {
  world::WallConfig wall;
  const Eigen::Vector2d corners[] = {
      {-half_x_m, -half_y_m}, {half_x_m, -half_y_m}, {half_x_m, half_y_m}, {-half_x_m, half_y_m}};
  wall.points_m.assign(std::begin(corners), std::end(corners));
  wall.points_m.push_back(corners[0]);
  wall.look = static_cast<world::WallLook>(random.integer(0, 3));
  wall.colour = any_colour(random, 100, 235, 30);
  if (random.uniform() < 0.5) wall.skirting_m = random.uniform(0.04, 0.1);
  wall.skirting = any_colour(random, 60, 245, 15);
  wall.pictures = random.uniform() < 0.3;
  room.walls.push_back(wall);
}

void add_obstacle(world::WorldConfig& room, double half_x_m, double half_y_m, Random& random) {
  const auto shapes = shapes_in(room);
  for (int i = 0; i < kTries; ++i) {
    const Eigen::Vector2d p_W_m(random.uniform(-half_x_m + 0.3, half_x_m - 0.3),
                                random.uniform(-half_y_m + 0.3, half_y_m - 0.3));
    if (!free_at(p_W_m, 0.45, shapes)) continue;
    if (random.uniform() < 0.6) {
      world::BoxConfig box;
      box.X_WB = {p_W_m.x(), p_W_m.y(), random.uniform(0, std::numbers::pi)};
      box.length_m = random.uniform(0.1, 0.5);
      box.width_m = random.uniform(0.08, 0.4);
      box.height_m = random.uniform(0.08, 0.8);
      box.look = static_cast<world::BoxLook>(random.integer(0, 5));
      box.colour = any_colour(random, 30, 235, 70);
      room.boxes.push_back(box);
    } else {
      world::CylinderConfig cylinder;
      cylinder.p_W_m = p_W_m;
      cylinder.radius_m = random.uniform(0.03, 0.2);
      cylinder.height_m = random.uniform(0.1, 0.9);
      cylinder.look = static_cast<world::CylinderLook>(random.integer(0, 3));
      cylinder.colour = any_colour(random, 30, 235, 70);
      room.cylinders.push_back(cylinder);
    }
    return;
  }
}

void add_line(world::WorldConfig& room, double half_x_m, double half_y_m, Random& random) {
  world::LineConfig line;
  for (int i = 0; i < 2; ++i) {
    line.points_m.emplace_back(random.uniform(-half_x_m, half_x_m), random.uniform(-half_y_m, half_y_m));
  }
  line.width_m = random.uniform(0.02, 0.06);
  line.colour = random.uniform() < 0.7 ? world::Colour{240, 240, 240} : any_colour(random, 20, 220, 60);
  room.lines.push_back(line);
}

void choose_stands(LabRoom& lab, double half_x_m, double half_y_m, Random& random) {
  const auto shapes = shapes_in(lab.world);
  for (int i = 0; i < kTries && lab.stands.size() < kStands; ++i) {
    const Eigen::Vector2d p_W_m(random.uniform(-half_x_m, half_x_m), random.uniform(-half_y_m, half_y_m));
    const double heading_rad = random.uniform(-std::numbers::pi, std::numbers::pi);
    if (free_at(p_W_m, kRoomForRobot_m, shapes)) lab.stands.push_back({p_W_m.x(), p_W_m.y(), heading_rad});
  }
}

}  // namespace

const char* to_string(LabLight light) {
  for (const auto& [value, name] : kLights) {
    if (value == light) return name;
  }
  return "";
}

const char* to_string(world::FloorKind floor) {
  for (const auto& [value, name] : kFloors) {
    if (value == floor) return name;
  }
  return "";
}

std::optional<LabLight> lab_light_from(std::string_view name) {
  for (const auto& [value, known] : kLights) {
    if (known == name) return value;
  }
  return std::nullopt;
}

std::optional<world::FloorKind> lab_floor_from(std::string_view name) {
  for (const auto& [value, known] : kFloors) {
    if (known == name) return value;
  }
  return std::nullopt;
}

LabRoom lab_room(world::FloorKind floor, LabLight light, std::uint64_t seed) {
  Random random(seed, std::string("lab/") + to_string(floor) + "/" + to_string(light));
  LabRoom lab;
  const double half_x_m = random.uniform(1.3, 2.4);
  const double half_y_m = random.uniform(1.2, 2.0);
  lab.world.id = "lab";
  lab.world.bounds = {-half_x_m - 0.1, -half_y_m - 0.1, half_x_m + 0.1, half_y_m + 0.1};
  lab.world.floor = any_floor(floor, random);
  lab.world.light = any_light(light, random);
  lab.world.noise.sensor = light == LabLight::dim ? random.uniform(3, 5) : random.uniform(1.5, 3);
  lab.world.noise.vignette = random.uniform(0.05, 0.3);
  add_walls(lab.world, half_x_m, half_y_m, random);
  const auto obstacles = random.integer(5, 9);
  for (int i = 0; i < obstacles; ++i) add_obstacle(lab.world, half_x_m, half_y_m, random);
  if (random.uniform() < 0.33) {
    const auto lines = random.integer(1, 3);
    for (int i = 0; i < lines; ++i) add_line(lab.world, half_x_m, half_y_m, random);
  }
  choose_stands(lab, half_x_m, half_y_m, random);
  return lab;
}

}  // namespace mirada::rig
