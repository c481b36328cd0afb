#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "model/messages.h"
#include "model/robot_sections.h"

namespace mirada {
namespace {

constexpr double kFarthestCorner_m = 2;

bool is_corner(const nlohmann::json& value) {
  const auto fits = [](const nlohmann::json& number) {
    return number.is_number() && std::abs(number.get<double>()) <= kFarthestCorner_m;
  };
  return value.is_array() && value.size() == 2 && fits(value[0]) && fits(value[1]);
}

double turn_at(const std::vector<Eigen::Vector2d>& polygon, std::size_t i) {
  const std::size_t n = polygon.size();
  const Eigen::Vector2d in = polygon[(i + 1) % n] - polygon[i];
  const Eigen::Vector2d out = polygon[(i + 2) % n] - polygon[(i + 1) % n];
  return std::atan2(in.x() * out.y() - in.y() * out.x(), in.dot(out));
}

/// Which corner breaks "turns to one side, once round"; nothing when the polygon is convex. Clockwise is
/// turned over.
std::optional<std::size_t> make_counter_clockwise(std::vector<Eigen::Vector2d>& polygon) {
  double total_rad = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) total_rad += turn_at(polygon, i);
  if (total_rad < 0) std::reverse(polygon.begin(), polygon.end());
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (turn_at(polygon, i) < -1e-9) return (i + 1) % polygon.size();
  }
  if (std::abs(std::abs(total_rad) - 2 * std::numbers::pi) > 1e-6) return 0;
  return std::nullopt;
}

void read_footprint(JsonReader& json, RobotConfig& robot) {
  robot.footprint_R_m = {{0.1, 0.09}, {-0.1, 0.09}, {-0.1, -0.09}, {0.1, -0.09}};
  if (!json.has("footprint_m")) return;
  const nlohmann::json& list = json.json().at("footprint_m");
  if (!list.is_array() || list.size() < 3 || list.size() > 64 ||
      !std::all_of(list.begin(), list.end(), is_corner)) {
    json.fault("footprint_m", messages::footprint_points, {{"value", short_json(list)}});
    return;
  }
  std::vector<Eigen::Vector2d> corners;
  for (const nlohmann::json& corner : list)
    corners.emplace_back(corner[0].get<double>(), corner[1].get<double>());
  if (const auto bad = make_counter_clockwise(corners)) {
    json.fault("footprint_m", messages::footprint_not_convex, {{"corner", std::to_string(*bad + 1)}});
    return;
  }
  robot.footprint_R_m = std::move(corners);
}

void read_drive(JsonReader& json, DriveConfig& drive) {
  json.only({"track_m", "wheel_radius_m", "max_wheel_mps", "max_accel_mps2", "cruise_mps", "turn_degps"});
  drive.track_m = json.number_or("track_m", 0.02, 2, drive.track_m);
  drive.wheel_radius_m = json.number_or("wheel_radius_m", 0.005, 1, drive.wheel_radius_m);
  drive.max_wheel_mps = json.number_or("max_wheel_mps", 0.01, 5, drive.max_wheel_mps);
  drive.max_accel_mps2 = json.number_or("max_accel_mps2", 0.05, 50, drive.max_accel_mps2);
  drive.cruise_mps = json.number_or("cruise_mps", 0.005, 5, std::min(drive.cruise_mps, drive.max_wheel_mps));
  if (drive.cruise_mps > drive.max_wheel_mps) {
    json.fault("cruise_mps", messages::faster_than_possible,
               {{"value", number_text(drive.cruise_mps)}, {"max", number_text(drive.max_wheel_mps)}});
  }
  const double fastest_degps = deg(2 * drive.max_wheel_mps / drive.track_m);
  drive.turn_radps =
      rad(json.number_or("turn_degps", 1, 1080, std::min(deg(drive.turn_radps), fastest_degps)));
}

}  // namespace

void read_body(JsonReader& json, RobotConfig& robot) {
  read_footprint(json, robot);
  if (auto drive = json.object_if_present("drive")) read_drive(*drive, robot.drive);
}

}  // namespace mirada
