#include <algorithm>

#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "model/points.h"
#include "world/messages.h"
#include "world/shapes.h"
#include "world/world_config.h"
#include "world/world_fields.h"

namespace mirada::world {
namespace {

using Eigen::Vector2d;

constexpr double kLeastStartRoom_m = 0.2;

Bounds read_bounds(JsonReader reader) {
  reader.only({"min_x_m", "min_y_m", "max_x_m", "max_y_m"});
  Bounds out;
  out.min_x_m = reader.number("min_x_m", -kFarthestPoint_m, kFarthestPoint_m);
  out.min_y_m = reader.number("min_y_m", -kFarthestPoint_m, kFarthestPoint_m);
  out.max_x_m = reader.number("max_x_m", -kFarthestPoint_m, kFarthestPoint_m);
  out.max_y_m = reader.number("max_y_m", -kFarthestPoint_m, kFarthestPoint_m);
  const double least = std::min(out.max_x_m - out.min_x_m, out.max_y_m - out.min_y_m);
  const double most = std::max(out.max_x_m - out.min_x_m, out.max_y_m - out.min_y_m);
  if (least < 0.5 || most > 30) {
    reader.fault("", messages::bounds_empty,
                 {{"min", "0.5"}, {"max", "30"}, {"value", number_text(least) + " x " + number_text(most)}});
  }
  return out;
}

LightConfig read_light(JsonReader reader) {
  reader.only({"level", "colour", "from_deg", "elevation_deg", "ambient", "gradient", "shadow"});
  LightConfig out;
  out.level = reader.number_or("level", 0.1, 2, out.level);
  out.colour = read_colour(reader, "colour", out.colour);
  out.from_rad = rad(reader.number_or("from_deg", -360, 360, deg(out.from_rad)));
  out.elevation_rad = rad(reader.number_or("elevation_deg", 15, 90, deg(out.elevation_rad)));
  out.ambient = reader.number_or("ambient", 0, 1, out.ambient);
  out.gradient = reader.number_or("gradient", 0, 0.8, out.gradient);
  out.shadow = reader.number_or("shadow", 0, 1, out.shadow);
  return out;
}

NoiseConfig read_noise(JsonReader reader) {
  reader.only({"sensor", "vignette", "wheel_scale", "wheel_slip_m"});
  NoiseConfig out;
  out.sensor = reader.number_or("sensor", 0, 30, out.sensor);
  out.vignette = reader.number_or("vignette", 0, 0.9, out.vignette);
  out.wheel_scale = reader.number_or("wheel_scale", 0, 0.1, out.wheel_scale);
  out.wheel_slip = reader.number_or("wheel_slip_m", 0, 0.05, out.wheel_slip);
  return out;
}

JitterConfig read_jitter(JsonReader reader) {
  reader.only({"start_m", "start_deg", "obstacles_m", "obstacles_deg", "light"});
  JitterConfig out;
  out.start_m = reader.number_or("start_m", 0, 2, out.start_m);
  out.start_rad = rad(reader.number_or("start_deg", 0, 180, deg(out.start_rad)));
  out.obstacles_m = reader.number_or("obstacles_m", 0, 1, out.obstacles_m);
  out.obstacles_rad = rad(reader.number_or("obstacles_deg", 0, 180, 0));
  out.light = reader.number_or("light", 0, 0.8, out.light);
  return out;
}

void read_sections(JsonReader& root, WorldConfig& out) {
  JsonReader name = root.object("name");
  name.only({"en", "es"});
  out.name_en = name.text("en");
  out.name_es = name.text("es");
  out.bounds = read_bounds(root.object("bounds"));
  JsonReader start = root.object("start");
  start.only({"x_m", "y_m", "heading_deg"});
  out.X_WR_start = read_pose(start);
  out.floor = read_floor(root.object("floor"));
  if (auto light = root.object_if_present("light")) out.light = read_light(*light);
  if (auto noise = root.object_if_present("noise")) out.noise = read_noise(*noise);
  if (auto jitter = root.object_if_present("jitter")) out.jitter = read_jitter(*jitter);
  if (auto background = root.object_if_present("background")) {
    background->only({"horizon_colour", "zenith_colour"});
    out.background.horizon = read_colour(*background, "horizon_colour", out.background.horizon);
    out.background.zenith = read_colour(*background, "zenith_colour", out.background.zenith);
  }
  constexpr std::size_t kMost = 200;
  for (JsonReader& reader : root.objects("lines", kMost)) out.lines.push_back(read_line(reader));
  for (JsonReader& reader : root.objects("walls", kMost)) out.walls.push_back(read_wall(reader));
  for (JsonReader& reader : root.objects("boxes", kMost)) out.boxes.push_back(read_box(reader));
  for (JsonReader& reader : root.objects("cylinders", kMost)) out.cylinders.push_back(read_cylinder(reader));
  for (JsonReader& reader : root.objects("people", 20)) out.people.push_back(read_person(reader));
  for (JsonReader& reader : root.objects("tags", kMost)) out.tags.push_back(read_tag(reader));
}

/// Checks that look at the whole room; only for a room whose parts are sound.
class RoomCheck {
 public:
  RoomCheck(const WorldConfig& world, Faults& faults) : world_(world), faults_(faults) {}

  void run() {
    inside("/start", {world_.X_WR_start.x_m, world_.X_WR_start.y_m});
    each("/boxes/", world_.boxes, [](const BoxConfig& b) { return Vector2d(b.X_WB.x_m, b.X_WB.y_m); });
    each("/cylinders/", world_.cylinders, [](const CylinderConfig& c) { return c.p_W_m; });
    each("/people/", world_.people, [](const PersonConfig& p) { return Vector2d(p.X_WP.x_m, p.X_WP.y_m); });
    for (std::size_t i = 0; i < world_.tags.size(); ++i) {
      inside("/tags/" + std::to_string(i), {world_.tags[i].X_WT.x_m, world_.tags[i].X_WT.y_m});
    }
    for (std::size_t i = 0; i < world_.walls.size(); ++i) {
      for (const Shape& shape : shapes_of(world_.walls[i])) clear_start("/walls/" + std::to_string(i), shape);
    }
  }

 private:
  template <class List, class Where>
  void each(const std::string& place, const List& list, Where where) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      inside(place + std::to_string(i), where(list[i]));
      clear_start(place + std::to_string(i), shape_of(list[i]));
    }
  }

  void inside(const std::string& place, const Vector2d& p) {
    const Bounds& b = world_.bounds;
    if (p.x() >= b.min_x_m && p.x() <= b.max_x_m && p.y() >= b.min_y_m && p.y() <= b.max_y_m) return;
    faults_.push_back(make_fault(place, messages::outside_bounds,
                                 {{"field", place},
                                  {"min_x", number_text(b.min_x_m)},
                                  {"max_x", number_text(b.max_x_m)},
                                  {"min_y", number_text(b.min_y_m)},
                                  {"max_y", number_text(b.max_y_m)}}));
  }

  void clear_start(const std::string& obstacle, const Shape& shape) {
    const Pose2& start = world_.X_WR_start;
    const double room = separation(rectangle(start, 0.002, 0.002), shape).distance_m;
    if (room >= kLeastStartRoom_m) return;
    faults_.push_back(make_fault("/start", messages::start_blocked,
                                 {{"value", number_text(std::max(room, 0.0))},
                                  {"obstacle", obstacle},
                                  {"min", number_text(kLeastStartRoom_m)}}));
  }

  const WorldConfig& world_;
  Faults& faults_;
};

}  // namespace

Result<WorldConfig> read_world(std::string_view json_text, const std::string& file_name, Faults* warnings) {
  Result<nlohmann::json> json = parse_json(json_text, file_name);
  if (!json) return json.faults();
  Faults faults;
  JsonReader root(*json, "", faults);
  WorldConfig out;
  const std::string format = root.text("format");
  if (!format.empty() && format != "mirada-world") {
    root.fault("format", messages::world_format, {{"value", format.substr(0, 40)}});
  }
  root.number("version", 1, 1);
  out.id = root.text("id");
  root.only({"format", "version", "id", "name", "bounds", "start", "floor", "lines", "walls", "boxes",
             "cylinders", "people", "tags", "light", "noise", "jitter", "background"});
  read_sections(root, out);
  if (!has_errors(faults)) RoomCheck(out, faults).run();
  if (has_errors(faults)) return faults;
  if (warnings) *warnings = std::move(faults);
  return out;
}

}  // namespace mirada::world
