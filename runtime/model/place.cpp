#include "model/place.h"

#include <algorithm>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/json_reader.h"
#include "base/units.h"
#include "model/messages.h"

namespace mirada {
namespace fs = std::filesystem;
namespace {

constexpr double kFarthestInPlace_m = 50;
constexpr int kMostTagId = 586;  // 36h11 has 587
constexpr std::size_t kMostTags = 200;

Pose2 read_pose_in_place(JsonReader& reader) {
  Pose2 out;
  out.x_m = reader.number("x_m", -kFarthestInPlace_m, kFarthestInPlace_m);
  out.y_m = reader.number("y_m", -kFarthestInPlace_m, kFarthestInPlace_m);
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
  root.only({"format", "version", "id", "name", "tags", "start"});
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
