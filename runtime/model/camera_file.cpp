#include "model/camera_file.h"

#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/json_reader.h"
#include "model/messages.h"
#include "model/robot_sections.h"

namespace mirada {
namespace {

constexpr std::uintmax_t kMaxCameraFile_bytes = 4u << 20;

void read_head(JsonReader& json) {
  const nlohmann::json& all = json.json();
  if (json.text("format") != "mirada-camera" && all.contains("format") && all.at("format").is_string()) {
    json.fault("format", messages::camera_file_wrong_format, {{"value", short_json(all.at("format"))}});
  }
  if (json.has("version") && all.at("version") != 1) {
    json.fault("version", messages::robot_wrong_version, {{"value", short_json(all.at("version"))}});
  }
  // A calibration always knows these; robot.json may leave them out.
  for (const char* field : {"width_px", "height_px", "fx_px"}) json.number(field, 10, 20'000);
}

}  // namespace

Result<CameraModel> read_camera_file(std::string_view json_text, const std::string& file_name,
                                     Faults* warnings) {
  auto parsed = parse_json(json_text, file_name);
  if (!parsed) return parsed.faults();
  Faults faults;
  CameraModel camera;
  JsonReader json(*parsed, "", faults);
  if (parsed->is_object()) {
    json.only({"$schema", "format", "version", "name", "preset", "width_px", "height_px", "hfov_deg",
               "vfov_deg", "fx_px", "fy_px", "cx_px", "cy_px", "lens", "distortion", "calibration"});
    read_head(json);
    if (!has_errors(faults)) read_camera_model(json, camera);
  }
  for (Fault& fault : faults) fault.place = file_name + fault.place;
  if (has_errors(faults)) return faults;
  if (warnings) warnings->insert(warnings->end(), faults.begin(), faults.end());
  return camera;
}

Result<CameraModel> load_camera_file(const std::filesystem::path& file, Faults* warnings) {
  auto text = read_file(file, kMaxCameraFile_bytes);
  if (!text) return text.faults();
  return read_camera_file(*text, file.string(), warnings);
}

}  // namespace mirada
