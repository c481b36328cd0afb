#include "model/place.h"

#include <algorithm>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/json_reader.h"
#include "base/units.h"
#include "model/messages.h"
#include "model/points.h"

namespace mirada {
namespace fs = std::filesystem;
namespace {

constexpr int kMostTagId = 586;  // 36h11 has 587
constexpr std::size_t kMostTags = 200;
constexpr std::size_t kMostLines = 100;
constexpr std::size_t kMostCorners = 50;
constexpr double kShortestLine_m = 0.05;

Pose2 read_pose_in_place(JsonReader& reader) {
  Pose2 out;
  out.x_m = reader.number("x_m", -kFarthestPoint_m, kFarthestPoint_m);
  out.y_m = reader.number("y_m", -kFarthestPoint_m, kFarthestPoint_m);
  out.heading_rad = rad(reader.number("heading_deg", -360, 360));
  return out;
}

PlaceTag read_place_tag(JsonReader reader, const Place& place) {
  reader.only({"id", "x_m", "y_m", "heading_deg", "size_m"});
  PlaceTag out;
  const double id = reader.number("id", 0, kMostTagId);
  out.id = static_cast<int>(id);
  if (out.id != id) reader.fault("id", messages::place_tag_id, {{"value", number_text(id)}});
  if (place.tag(out.id) != nullptr)
    reader.fault("id", messages::place_tag_twice, {{"value", number_text(id)}});
  out.X_PT = read_pose_in_place(reader);
  out.size_m = reader.number_or("size_m", 0.01, 1, out.size_m);
  return out;
}

void read_straight_lines(JsonReader& reader, double width_m, std::vector<PlaceLine>& lines) {
  const std::vector<Eigen::Vector2d> points_m = read_points(reader, "points", 2, kMostCorners);
  if (points_m.size() != reader.json().at("points").size()) return;
  for (std::size_t i = 1; i < points_m.size(); ++i) {
    const double length_m = (points_m[i] - points_m[i - 1]).norm();
    if (length_m < kShortestLine_m) {
      reader.fault("points/" + std::to_string(i), messages::place_line_short,
                   {{"value", number_text(length_m)}, {"min", number_text(kShortestLine_m)}});
    }
    lines.push_back({points_m[i - 1], points_m[i], width_m});
  }
}

void read_place_line(JsonReader reader, Place& place) {
  reader.only({"points", "circle", "width_m"});
  const double width_m = reader.number_or("width_m", 0.01, 0.3, PlaceLine{}.width_m);
  if (std::optional<JsonReader> circle = reader.object_if_present("circle")) {
    circle->only({"x_m", "y_m", "radius_m"});
    const double x_m = circle->number("x_m", -kFarthestPoint_m, kFarthestPoint_m);
    const double y_m = circle->number("y_m", -kFarthestPoint_m, kFarthestPoint_m);
    place.circles.push_back({{x_m, y_m}, circle->number("radius_m", 0.2, 20), width_m});
  } else if (reader.has("points")) {
    read_straight_lines(reader, width_m, place.lines);
  } else {
    reader.fault("points", messages::points_or_circle);
  }
}

}  // namespace

const PlaceTag* Place::tag(int tag_id) const {
  const auto it = std::find_if(tags.begin(), tags.end(), [&](const PlaceTag& t) { return t.id == tag_id; });
  return it == tags.end() ? nullptr : &*it;
}

Result<Place> read_place(std::string_view json_text, const std::string& file_name, Faults* warnings) {
  Result<nlohmann::json> json = parse_json(json_text, file_name);
  if (!json) return json.faults();
  Faults faults;
  JsonReader root(*json, "", faults);
  root.only({"format", "version", "id", "name", "tags", "lines", "start"});
  Place out;
  const std::string format = root.text("format");
  if (!format.empty() && format != "mirada-place")
    root.fault("format", messages::place_format, {{"value", format.substr(0, 40)}});
  root.number("version", 1, 1);
  out.id = root.text("id");
  out.name_en = out.name_es = out.id;
  if (auto name = root.object_if_present("name")) {
    name->only({"en", "es"});
    out.name_en = name->text_or("en", out.id);
    out.name_es = name->text_or("es", out.name_en);
  }
  for (JsonReader& tag : root.objects("tags", kMostTags)) out.tags.push_back(read_place_tag(tag, out));
  for (JsonReader& line : root.objects("lines", kMostLines)) read_place_line(line, out);
  if (auto start = root.object_if_present("start")) {
    start->only({"x_m", "y_m", "heading_deg"});
    out.X_PR_start = read_pose_in_place(*start);
  }
  for (Fault& fault : faults) fault.place = file_name + fault.place;
  if (has_errors(faults)) return faults;
  if (warnings != nullptr) *warnings = std::move(faults);
  return out;
}

std::vector<std::string> shipped_places() {
  std::vector<std::string> ids;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(data_folder("runtime/model/places"), error)) {
    if (entry.path().extension() == ".json") ids.push_back(entry.path().stem().string());
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

Result<Place> place_by_name(const std::string& name) {
  const std::vector<std::string> ids = shipped_places();
  fs::path file(name);
  std::error_code error;
  if (std::find(ids.begin(), ids.end(), name) != ids.end()) {
    file = data_folder("runtime/model/places") / (name + ".json");
  } else if (!file.has_parent_path() && !file.has_extension() && !fs::exists(file, error)) {
    std::string known;
    for (const std::string& id : ids) known += (known.empty() ? "" : ", ") + id;
    return make_fault("place", messages::place_unknown, {{"name", name}, {"known", known}});
  }
  const Result<std::string> text = read_file(file, 1u << 20);
  if (!text) return text.faults();
  return read_place(*text, file.string());
}

}  // namespace mirada
