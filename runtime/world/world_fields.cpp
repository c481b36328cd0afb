#include "world/world_fields.h"

#include <cmath>
#include <numbers>

#include <nlohmann/json.hpp>

#include "model/messages.h"
#include "model/points.h"
#include "world/messages.h"

namespace mirada::world {
namespace {

using Eigen::Vector2d;
using nlohmann::json;

std::string shown(const json& value) {
  return value.dump(-1, ' ', false, json::error_handler_t::replace).substr(0, 40);
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

bool is_colour(const std::string& text) {
  if (text.size() != 7 || text[0] != '#') return false;
  for (std::size_t i = 1; i < 7; ++i) {
    if (hex_digit(text[i]) < 0) return false;
  }
  return true;
}

template <class Look>
Look look_of(JsonReader& reader, std::initializer_list<std::string_view> names) {
  if (!reader.has("look")) return static_cast<Look>(0);
  const std::string chosen = reader.choice("look", names);
  int index = 0;
  for (const std::string_view name : names) {
    if (name == chosen) return static_cast<Look>(index);
    ++index;
  }
  return static_cast<Look>(0);
}

std::vector<Vector2d> circle_points(JsonReader circle) {
  circle.only({"x_m", "y_m", "radius_m"});
  const double x = circle.number("x_m", -kFarthestPoint_m, kFarthestPoint_m);
  const double y = circle.number("y_m", -kFarthestPoint_m, kFarthestPoint_m);
  const double radius = circle.number("radius_m", 0.02, 20);
  constexpr int kSides = 64;
  std::vector<Vector2d> out;
  for (int i = 0; i <= kSides; ++i) {
    const double angle = 2 * std::numbers::pi * (i % kSides) / kSides;
    out.emplace_back(x + radius * std::cos(angle), y + radius * std::sin(angle));
  }
  return out;
}

}  // namespace

std::string to_hex(Colour colour) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string out = "#";
  for (const std::uint8_t channel : {colour.r, colour.g, colour.b}) {
    out += kDigits[channel >> 4];
    out += kDigits[channel & 15];
  }
  return out;
}

Colour read_colour(JsonReader& reader, std::string_view field, Colour fallback) {
  if (!reader.has(field)) return fallback;
  const json& value = reader.json().at(std::string(field));
  if (!value.is_string() || !is_colour(value.get_ref<const std::string&>())) {
    reader.fault(field, messages::colour_needed, {{"value", shown(value)}});
    return fallback;
  }
  const std::string& text = value.get_ref<const std::string&>();
  const auto channel = [&](std::size_t at) {
    return static_cast<std::uint8_t>(hex_digit(text[at]) * 16 + hex_digit(text[at + 1]));
  };
  return {channel(1), channel(3), channel(5)};
}

Pose2 read_pose(JsonReader& reader) {
  Pose2 out;
  out.x_m = reader.number("x_m", -kFarthestPoint_m, kFarthestPoint_m);
  out.y_m = reader.number("y_m", -kFarthestPoint_m, kFarthestPoint_m);
  out.heading_rad = rad(reader.number_or("heading_deg", -360, 360, 0));
  return out;
}

FloorConfig read_floor(JsonReader reader) {
  reader.only({"kind", "colour", "scale", "contrast"});
  constexpr std::string_view kKinds[] = {"plain", "carpet", "wood", "tiles", "concrete", "grass"};
  FloorConfig out;
  const std::string kind =
      reader.choice("kind", {kKinds[0], kKinds[1], kKinds[2], kKinds[3], kKinds[4], kKinds[5]});
  for (int i = 0; i < 6; ++i) {
    if (kKinds[i] == kind) out.kind = static_cast<FloorKind>(i);
  }
  constexpr Colour kUsual[] = {{150, 150, 150}, {150, 140, 125}, {176, 128, 82},
                               {200, 196, 188}, {150, 150, 146}, {58, 128, 56}};
  out.colour = read_colour(reader, "colour", kUsual[static_cast<int>(out.kind)]);
  out.scale = reader.number_or("scale", 0.25, 4, 1);
  out.contrast = reader.number_or("contrast", 0, 3, 1);
  return out;
}

LineConfig read_line(JsonReader reader) {
  reader.only({"points", "circle", "width_m", "colour"});
  LineConfig out;
  if (std::optional<JsonReader> circle = reader.object_if_present("circle")) {
    out.points_m = circle_points(*circle);
  } else if (reader.has("points")) {
    out.points_m = read_points(reader, "points", 2, 1000);
  } else {
    reader.fault("points", mirada::messages::points_or_circle);
  }
  out.width_m = reader.number_or("width_m", 0.005, 1, out.width_m);
  out.colour = read_colour(reader, "colour", out.colour);
  return out;
}

WallConfig read_wall(JsonReader reader) {
  reader.only({"points", "height_m", "look", "colour", "skirting_m", "skirting_colour", "pictures"});
  WallConfig out;
  out.points_m = read_points(reader, "points", 2, 1000);
  out.height_m = reader.number_or("height_m", 0.02, 5, out.height_m);
  out.look = look_of<WallLook>(reader, {"paint", "wallpaper", "brick", "board"});
  out.colour = read_colour(reader, "colour", out.colour);
  out.skirting_m = reader.number_or("skirting_m", 0, 0.5, out.skirting_m);
  out.skirting = read_colour(reader, "skirting_colour", out.skirting);
  out.pictures = reader.truth_or("pictures", false);
  return out;
}

BoxConfig read_box(JsonReader reader) {
  reader.only({"x_m", "y_m", "heading_deg", "length_m", "width_m", "height_m", "look", "colour"});
  BoxConfig out;
  out.X_WB = read_pose(reader);
  out.length_m = reader.number("length_m", 0.01, 20);
  out.width_m = reader.number("width_m", 0.01, 20);
  out.height_m = reader.number("height_m", 0.01, 5);
  out.look = look_of<BoxLook>(reader, {"plain", "wood", "cardboard", "books", "drawers", "crate", "poster"});
  out.colour = read_colour(reader, "colour", out.colour);
  return out;
}

CylinderConfig read_cylinder(JsonReader reader) {
  reader.only({"x_m", "y_m", "radius_m", "height_m", "look", "colour"});
  CylinderConfig out;
  const Pose2 pose = read_pose(reader);
  out.p_W_m = {pose.x_m, pose.y_m};
  out.radius_m = reader.number("radius_m", 0.005, 5);
  out.height_m = reader.number("height_m", 0.01, 5);
  out.look = look_of<CylinderLook>(reader, {"plain", "stripes", "wood", "plant"});
  out.colour = read_colour(reader, "colour", out.colour);
  return out;
}

PersonConfig read_person(JsonReader reader) {
  reader.only({"x_m", "y_m", "heading_deg", "height_m", "radius_m", "shirt_colour", "hair_colour",
               "skin_colour", "face", "path", "speed_mps", "watches_robot"});
  PersonConfig out;
  out.X_WP = read_pose(reader);
  out.height_m = reader.number_or("height_m", 0.25, 2.2, out.height_m);
  out.radius_m = reader.number_or("radius_m", 0.03, 0.6, out.height_m * 0.125);
  out.shirt = read_colour(reader, "shirt_colour", out.shirt);
  out.face = static_cast<int>(reader.number_or("face", 0, 9999, out.face));
  wear_own_colours(out);
  out.hair = read_colour(reader, "hair_colour", out.hair);
  out.skin = read_colour(reader, "skin_colour", out.skin);
  out.path_m = read_points(reader, "path", 0, 100);
  out.speed_mps = reader.number_or("speed_mps", 0.01, 1.5, out.speed_mps);
  out.watches_robot = reader.truth_or("watches_robot", false);
  return out;
}

TagConfig read_tag(JsonReader reader) {
  reader.only({"id", "x_m", "y_m", "z_m", "heading_deg", "size_m"});
  TagConfig out;
  out.id = static_cast<int>(reader.number("id", 0, 586));
  out.X_WT = read_pose(reader);
  out.z_m = reader.number_or("z_m", 0.01, 3, out.z_m);
  out.size_m = reader.number_or("size_m", 0.01, 1, out.size_m);
  return out;
}

}  // namespace mirada::world
