#include <algorithm>

#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/json_reader.h"
#include "model/messages.h"
#include "model/robot_config.h"
#include "model/robot_sections.h"

namespace mirada {
namespace fs = std::filesystem;
namespace {

constexpr std::uintmax_t kMaxRobotFile_bytes = 4u << 20;

void read_head(JsonReader& json, const std::string& file_name, RobotConfig& robot) {
  const nlohmann::json& all = json.json();
  if (json.has("format") && all.at("format") != "mirada-robot") {
    json.fault("format", messages::robot_wrong_format, {{"value", short_json(all.at("format"))}});
  }
  if (json.has("version") && all.at("version") != 1) {
    json.fault("version", messages::robot_wrong_version, {{"value", short_json(all.at("version"))}});
  }
  robot.id = json.text_or("id", fs::path(file_name).stem().string());
  robot.name_en = robot.name_es = robot.id;
  if (auto name = json.object_if_present("name")) {
    name->only({"en", "es"});
    robot.name_en = name->text_or("en", robot.id);
    robot.name_es = name->text_or("es", robot.name_en);
  }
}

void read_latency(JsonReader& json, LatencyConfig& latency) {
  json.only({"frame_ms", "sonar_ms", "faces_ms", "identity_ms"});
  const auto field = [&](const char* name, Micros fallback) {
    return micros(json.number_or(name, 0, 5000, seconds(fallback) * 1e3) * 1e-3);
  };
  latency.frame_us = field("frame_ms", latency.frame_us);
  latency.sonar_us = field("sonar_ms", latency.sonar_us);
  latency.faces_us = field("faces_ms", latency.faces_us);
  latency.identity_us = field("identity_ms", latency.identity_us);
}

CheckConfig read_check(JsonReader& json) {
  json.only({"tag_mm", "tag_id"});
  CheckConfig check;
  check.tag_m = json.number("tag_mm", 5, 1000) * 1e-3;
  check.tag_id = static_cast<int>(json.number_or("tag_id", 0, 586, -1));
  return check;
}

/// Faults inside the file carry the file's name too, so that a list from several files can be read.
void name_file(Faults& faults, const std::string& file_name) {
  for (Fault& fault : faults) {
    if (fault.place != file_name) fault.place = file_name + fault.place;
  }
}

}  // namespace

Result<RobotConfig> read_robot(std::string_view json_text, const std::string& file_name, Faults* warnings) {
  auto parsed = parse_json(json_text, file_name);
  if (!parsed) return parsed.faults();
  Faults faults;
  Faults file_faults;
  RobotConfig robot;
  JsonReader json(*parsed, "", faults);
  if (parsed->is_object()) {
    json.only({"$schema", "format", "version", "id", "name", "footprint_m", "drive", "camera", "neck",
               "mount", "latency", "check", "lines_are_obstacles"});
    read_head(json, file_name, robot);
    JsonReader camera = json.object("camera");
    read_camera(camera, fs::path(file_name).parent_path(), robot, file_faults);
    read_body(json, robot);
    read_chain(json, robot);
    if (auto latency = json.object_if_present("latency")) read_latency(*latency, robot.latency);
    if (auto check = json.object_if_present("check")) robot.check = read_check(*check);
    robot.lines_are_obstacles = json.truth_or("lines_are_obstacles", false);
  }
  name_file(faults, file_name);
  faults.insert(faults.end(), file_faults.begin(), file_faults.end());
  if (has_errors(faults)) return faults;
  if (warnings) warnings->insert(warnings->end(), faults.begin(), faults.end());
  return robot;
}

Result<RobotConfig> load_robot(const fs::path& file, Faults* warnings) {
  auto text = read_file(file, kMaxRobotFile_bytes);
  if (!text) return text.faults();
  return read_robot(*text, file.string(), warnings);
}

std::vector<std::string> shipped_robots() {
  std::vector<std::string> ids;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(data_folder("runtime/model/robots"), error)) {
    if (entry.path().extension() == ".json") ids.push_back(entry.path().stem().string());
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

Result<RobotConfig> robot_by_name(const std::string& id_or_path, Faults* warnings) {
  const std::vector<std::string> ids = shipped_robots();
  if (std::find(ids.begin(), ids.end(), id_or_path) != ids.end()) {
    return load_robot(data_folder("runtime/model/robots") / (id_or_path + ".json"), warnings);
  }
  std::error_code error;
  const fs::path path(id_or_path);
  if (path.has_parent_path() || path.has_extension() || fs::exists(path, error))
    return load_robot(path, warnings);
  std::string known;
  for (const std::string& id : ids) known += (known.empty() ? "" : ", ") + id;
  return make_fault("robot", messages::robot_unknown, {{"robot", id_or_path}, {"known", known}});
}

}  // namespace mirada
