#include "world/scene_json.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "base/units.h"

namespace mirada::world {
namespace {

using nlohmann::json;

/// Tenths of a millimetre are enough to draw; shorter text is faster to send.
double rounded(double value) { return std::round(value * 1e4) / 1e4; }

json points_json(const std::vector<Eigen::Vector2d>& points) {
  json out = json::array();
  for (const Eigen::Vector2d& p : points) out.push_back({rounded(p.x()), rounded(p.y())});
  return out;
}

json pose_json(const Pose2& pose) {
  return {{"x_m", rounded(pose.x_m)},
          {"y_m", rounded(pose.y_m)},
          {"heading_deg", rounded(deg(pose.heading_rad))}};
}

json fixed_json(const WorldConfig& world) {
  const Bounds& b = world.bounds;
  json out = {
      {"bounds",
       {{"min_x_m", b.min_x_m}, {"min_y_m", b.min_y_m}, {"max_x_m", b.max_x_m}, {"max_y_m", b.max_y_m}}},
      {"floor_colour", to_hex(world.floor.colour)}};
  json lines = json::array(), walls = json::array(), boxes = json::array(), cylinders = json::array();
  for (const LineConfig& line : world.lines) {
    lines.push_back(
        {{"points", points_json(line.points_m)}, {"width_m", line.width_m}, {"colour", to_hex(line.colour)}});
  }
  for (const WallConfig& wall : world.walls) {
    walls.push_back({{"points", points_json(wall.points_m)}, {"colour", to_hex(wall.colour)}});
  }
  for (const BoxConfig& box : world.boxes) {
    json entry = pose_json(box.X_WB);
    entry.update({{"length_m", box.length_m}, {"width_m", box.width_m}, {"colour", to_hex(box.colour)}});
    boxes.push_back(std::move(entry));
  }
  for (const CylinderConfig& c : world.cylinders) {
    cylinders.push_back({{"x_m", rounded(c.p_W_m.x())},
                         {"y_m", rounded(c.p_W_m.y())},
                         {"radius_m", c.radius_m},
                         {"colour", to_hex(c.colour)}});
  }
  out.update({{"lines", lines}, {"walls", walls}, {"boxes", boxes}, {"cylinders", cylinders}});
  return out;
}

}  // namespace

SceneWriter::SceneWriter(const WorldConfig& placed, const RobotConfig& robot)
    : footprint_(points_json(robot.footprint_R_m).dump()), hfov_deg_(rounded(deg(robot.camera.hfov_rad()))) {
  fixed_ = fixed_json(placed).dump();
  fixed_.pop_back();
  for (const PersonConfig& person : placed.people) {
    person_radius_m_.push_back(person.radius_m);
    person_colour_.push_back(to_hex(person.shirt));
  }
}

std::string SceneWriter::write(const Truth& truth, const std::vector<Pose2>& people) const {
  json persons = json::array();
  for (std::size_t i = 0; i < people.size(); ++i) {
    json entry = pose_json(people[i]);
    entry.update({{"radius_m", rounded(person_radius_m_[i])}, {"colour", person_colour_[i]}});
    persons.push_back(std::move(entry));
  }
  json robot = pose_json(truth.X_WR);
  robot.update(
      {{"pan_deg", rounded(deg(truth.neck.pan_rad))}, {"hfov_deg", hfov_deg_}, {"contact", truth.touching}});
  std::string robot_text = robot.dump();
  robot_text.pop_back();
  return fixed_ + ",\"people\":" + persons.dump() + ",\"robot\":" + robot_text +
         ",\"footprint\":" + footprint_ + "},\"contacts\":" + std::to_string(truth.contacts) +
         ",\"path_m\":" + json(rounded(truth.path_m)).dump() + "}";
}

}  // namespace mirada::world
