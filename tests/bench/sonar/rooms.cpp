// Distances against the truth in the simulator's rooms: the three that ship and rooms drawn by lot on every
// floor, seen from poses drawn by lot: sonar_rooms [POSES] [--dump FOLDER]. JSON out.
#include <cstdlib>

#include "base/random.h"
#include "score.h"
#include "vision/visual_sonar.h"
#include "world/shapes.h"
#include "world/simulation.h"

namespace mirada::bench {
namespace {

using world::WorldConfig;

std::vector<world::Shape> shapes_in(const WorldConfig& room) {
  std::vector<world::Shape> shapes;
  for (const auto& wall : room.walls) {
    for (world::Shape& shape : world::shapes_of(wall)) shapes.push_back(std::move(shape));
  }
  for (const auto& box : room.boxes) shapes.push_back(world::shape_of(box));
  for (const auto& cylinder : room.cylinders) shapes.push_back(world::shape_of(cylinder));
  for (const auto& person : room.people) shapes.push_back(world::shape_of(person));
  return shapes;
}

double clearance_m(const std::vector<world::Shape>& shapes, const Eigen::Vector2d& p) {
  double nearest_m = 10;
  for (const world::Shape& shape : shapes)
    nearest_m = std::min(nearest_m, world::separation({p}, shape).distance_m);
  return nearest_m;
}

/// Steps along the ray by what is free round each point.
double true_distance_m(const std::vector<world::Shape>& shapes, const Pose2& X_WR, double bearing_rad) {
  const double angle = X_WR.heading_rad + bearing_rad;
  const Eigen::Vector2d way(std::cos(angle), std::sin(angle));
  double distance_m = 0;
  while (distance_m < 6) {
    const double free_m = clearance_m(shapes, Eigen::Vector2d(X_WR.x_m, X_WR.y_m) + distance_m * way);
    if (free_m < 5e-4) return distance_m;
    distance_m += free_m;
  }
  return distance_m;
}

Pose2 draw_pose(const WorldConfig& room, const std::vector<world::Shape>& shapes, Random& random) {
  for (;;) {
    const Pose2 X_WR{random.uniform(room.bounds.min_x_m, room.bounds.max_x_m),
                     random.uniform(room.bounds.min_y_m, room.bounds.max_y_m), random.uniform(-3.1, 3.1)};
    if (clearance_m(shapes, {X_WR.x_m, X_WR.y_m}) > 0.25) return X_WR;
  }
}

/// A room of another kind than those that ship: what stands in it, its colours and its light by lot.
WorldConfig draw_room(world::FloorKind floor, int light, std::uint64_t seed) {
  Random random(seed, "room");
  const auto byte = [&](double low, double high) {
    return static_cast<std::uint8_t>(random.uniform(low, high));
  };
  const auto colour = [&](double low, double high) {
    return world::Colour{byte(low, high), byte(low, high), byte(low, high)};
  };
  WorldConfig room;
  room.id = "drawn";
  const double x = random.uniform(1.3, 2.6), y = random.uniform(1.3, 2.6);
  room.bounds = {-x, -y, x, y};
  const std::uint8_t gray = byte(70, 200);
  room.floor = {floor,
                {gray, static_cast<std::uint8_t>(gray * random.uniform(0.85, 1.0)),
                 static_cast<std::uint8_t>(gray * random.uniform(0.7, 1.0))},
                random.uniform(0.8, 1.3),
                random.uniform(0.6, 1.2)};
  if (floor == world::FloorKind::grass) room.floor.colour = {byte(30, 70), byte(100, 150), byte(30, 70)};
  if (floor == world::FloorKind::wood) room.floor.colour = {byte(120, 190), byte(90, 135), byte(50, 90)};
  world::WallConfig wall;
  wall.points_m = {{-x, -y}, {x, -y}, {x, y}, {-x, y}, {-x, -y}};
  wall.look = static_cast<world::WallLook>(random.integer(0, 3));
  wall.colour = random.uniform() < 0.5 ? world::Colour{byte(190, 235), byte(190, 235), byte(185, 230)}
                                       : colour(60, 230);
  wall.skirting_m = random.uniform() < 0.5 ? 0.07 : 0;
  room.walls.push_back(wall);
  const auto n_boxes = random.integer(2, 6);
  for (int i = 0; i < n_boxes; ++i) {
    room.boxes.push_back({{random.uniform(-x, x), random.uniform(-y, y), random.uniform(-3, 3)},
                          random.uniform(0.08, 0.5),
                          random.uniform(0.08, 0.5),
                          random.uniform(0.08, 0.7),
                          static_cast<world::BoxLook>(random.integer(0, 5)),
                          colour(25, 230)});
  }
  const auto n_posts = random.integer(0, 3);
  for (int i = 0; i < n_posts; ++i) {
    room.cylinders.push_back({{random.uniform(-x, x), random.uniform(-y, y)},
                              random.uniform(0.03, 0.2),
                              random.uniform(0.12, 0.9),
                              static_cast<world::CylinderLook>(random.integer(0, 3)),
                              colour(25, 230)});
  }
  room.light.shadow = light == 2 ? 0.6 : 0.3;
  room.light.level = light == 1 ? 0.4 : 1.0;
  room.light.gradient = light == 2 ? 0.4 : 0.15;
  room.light.elevation_rad = light == 2 ? 0.6 : 1.1;
  room.noise.sensor = light == 1 ? 4 : 2.5;
  return room;
}

Frame photograph(const WorldConfig& room, const RobotConfig& robot, std::uint64_t seed,
                 const NeckAngles& neck) {
  world::Simulation simulation(room, robot, seed);
  simulation.camera().enable(true);
  simulation.neck().aim(neck);
  Frame frame;
  for (int i = 0; i < 120; ++i) {
    simulation.step(10 * kMillisecond);
    if (i < 80) continue;  // the neck has arrived
    if (auto got = simulation.camera().poll()) frame = *got;
  }
  return frame;
}

Score run(WorldConfig room, const std::string& name, std::uint64_t seed, const RobotConfig& robot,
          const std::string& folder) {
  room.jitter = {0, 0, 0, 0, 0};
  for (auto& person : room.people) person.path_m.clear();
  const auto shapes = shapes_in(room);
  Random random(seed, "pose");
  room.X_WR_start = draw_pose(room, shapes, random);
  const NeckAngles neck{rad(random.uniform(-60, 60)), 0};
  const Frame frame = photograph(room, robot, seed, neck);
  vision::VisualSonar sonar(robot);
  const SonarPercept percept = sonar.look(frame, neck, {});
  Score score;
  score.pictures = 1;
  score.untrusted = !percept.floor_model_trusted;
  for (const SonarReading& reading : percept.readings) {
    judge(reading, true_distance_m(shapes, room.X_WR_start, reading.bearing_rad), score);
  }
  dump_picture(folder, name + "-" + std::to_string(seed), frame.bgr, percept, score);
  return score;
}

}  // namespace
}  // namespace mirada::bench

int main(int argc, char** argv) {
  using namespace mirada;
  const int poses = argc > 1 ? std::atoi(argv[1]) : 10;
  const std::string folder = argc > 3 && std::string(argv[2]) == "--dump" ? argv[3] : "";
  const auto robot = robot_by_name("mirada-sim");
  if (!robot) return 1;
  nlohmann::json out;
  bench::Score all;
  const auto add = [&](const std::string& name, auto&& room_for) {
    bench::Score score;
    for (int i = 1; i <= poses; ++i) {
      const auto seed = static_cast<std::uint64_t>(i);
      score.merge(bench::run(room_for(seed), name, seed, *robot, folder));
    }
    out["cells"][name] = bench::to_json(score);
    all.merge(score);
  };
  for (const std::string& id : world::shipped_worlds()) {
    const auto room = world::world_by_name(id);
    if (room) add(id, [&](std::uint64_t) { return *room; });
  }
  const char* kFloors[] = {"plain", "carpet", "wood", "tiles", "concrete", "grass"};
  const char* kLights[] = {"even", "dim", "low_sun"};
  for (int floor = 0; floor < 6; ++floor) {
    for (int light = 0; light < 3; ++light) {
      add(std::string(kFloors[floor]) + "-" + kLights[light], [&](std::uint64_t seed) {
        return bench::draw_room(static_cast<world::FloorKind>(floor), light,
                                seed + 1000 * static_cast<std::uint64_t>(3 * floor + light));
      });
    }
  }
  out["all"] = bench::to_json(all);
  std::puts(out.dump(1).c_str());
  return 0;
}
