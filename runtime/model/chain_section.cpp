#include <algorithm>

#include <nlohmann/json.hpp>

#include "model/messages.h"
#include "model/robot_sections.h"

namespace mirada {
namespace {

constexpr double kFarthest_m = 2;

JointConfig read_joint(JsonReader& json, double limit_deg) {
  JointConfig joint;
  const double min_deg = json.number_or("min_deg", -limit_deg, limit_deg, 0);
  const double max_deg = json.number_or("max_deg", -limit_deg, limit_deg, std::max(0.0, min_deg));
  if (max_deg < min_deg) {
    json.fault("max_deg", messages::range_reversed,
               {{"value", number_text(max_deg)}, {"min", number_text(min_deg)}});
  }
  joint.min_rad = rad(min_deg);
  joint.max_rad = rad(std::max(min_deg, max_deg));
  joint.max_radps = rad(json.number_or("max_degps", 1, 5000, 286));
  return joint;
}

/// Gives the height of the tilt axis above the floor (0 when it is not said: then it is the lens's own
/// business).
double read_neck(JsonReader& json, NeckConfig& neck) {
  json.only({"forward_m", "left_m", "pan", "tilt"});
  neck.p_RN_m.x() = json.number_or("forward_m", -kFarthest_m, kFarthest_m, 0);
  neck.p_RN_m.y() = json.number_or("left_m", -kFarthest_m, kFarthest_m, 0);
  if (auto pan = json.object_if_present("pan")) {
    pan->only({"min_deg", "max_deg", "max_degps"});
    neck.pan = read_joint(*pan, 180);
  }
  auto tilt = json.object_if_present("tilt");
  if (!tilt) return 0;
  tilt->only({"min_deg", "max_deg", "max_degps", "forward_m", "left_m", "height_m"});
  neck.tilt = read_joint(*tilt, 90);
  neck.p_PT_m.x() = tilt->number_or("forward_m", -kFarthest_m, kFarthest_m, 0);
  neck.p_PT_m.y() = tilt->number_or("left_m", -kFarthest_m, kFarthest_m, 0);
  neck.p_PT_m.z() = tilt->number("height_m", 0, 3);
  return neck.p_PT_m.z();
}

void read_mount(JsonReader& json, MountConfig& mount, double axis_height_m) {
  json.only({"forward_m", "left_m", "height_m", "tilt_deg", "yaw_deg", "roll_deg", "sigma_tilt_deg",
             "sigma_height_m", "sigma_pan_deg"});
  mount.p_TM_m.x() = json.number_or("forward_m", -kFarthest_m, kFarthest_m, 0);
  mount.p_TM_m.y() = json.number_or("left_m", -kFarthest_m, kFarthest_m, 0);
  mount.p_TM_m.z() = json.number("height_m", 0.01, 3) - axis_height_m;
  mount.tilt_rad = rad(json.number("tilt_deg", -45, 90));
  mount.yaw_rad = rad(json.number_or("yaw_deg", -180, 180, 0));
  mount.roll_rad = rad(json.number_or("roll_deg", -180, 180, 0));
  mount.sigma_tilt_rad = rad(json.number_or("sigma_tilt_deg", 0, 10, deg(mount.sigma_tilt_rad)));
  mount.sigma_height_m = json.number_or("sigma_height_m", 0, 0.5, mount.sigma_height_m);
  mount.sigma_pan_rad = rad(json.number_or("sigma_pan_deg", 0, 20, deg(mount.sigma_pan_rad)));
}

void check_above_floor(JsonReader& json, const RobotConfig& robot) {
  for (const double tilt_rad : {robot.neck.tilt.min_rad, robot.neck.tilt.max_rad}) {
    const double height_m = robot.X_RC({0, tilt_rad}).translation().z();
    if (height_m > 0) continue;
    json.fault("height_m", messages::camera_underground,
               {{"tilt_deg", number_text(deg(tilt_rad), 1)}, {"height_m", number_text(height_m)}});
    return;
  }
}

}  // namespace

void read_chain(JsonReader& json, RobotConfig& robot) {
  double axis_height_m = 0;
  if (auto neck = json.object_if_present("neck")) axis_height_m = read_neck(*neck, robot.neck);
  JsonReader mount = json.object("mount");
  read_mount(mount, robot.mount, axis_height_m);
  if (mount.has("height_m")) check_above_floor(mount, robot);
}

}  // namespace mirada
