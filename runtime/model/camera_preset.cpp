#include "model/camera_preset.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/json_reader.h"
#include "base/units.h"
#include "model/messages.h"

namespace mirada {
namespace fs = std::filesystem;
namespace {

constexpr double kSameShape = 0.015;

CameraMode read_mode(JsonReader& json) {
  json.only({"width_px", "height_px", "hfov_deg", "vfov_deg", "note"});
  CameraMode mode;
  mode.width_px = static_cast<int>(json.number("width_px", 16, 20'000));
  mode.height_px = static_cast<int>(json.number("height_px", 16, 20'000));
  mode.hfov_rad = rad(json.number("hfov_deg", 1, 175));
  mode.vfov_rad = rad(json.number("vfov_deg", 1, 175));
  return mode;
}

Result<CameraPreset> load_preset(const fs::path& file) {
  auto text = read_file(file, 1u << 20);
  if (!text) return text.faults();
  auto parsed = parse_json(*text, file.string());
  if (!parsed) return parsed.faults();
  Faults faults;
  CameraPreset preset;
  JsonReader json(*parsed, "", faults);
  json.only({"format", "version", "name", "sensor", "tolerance", "modes", "sources"});
  preset.id = file.stem().string();
  preset.name_en = preset.name_es = preset.id;
  if (auto name = json.object_if_present("name")) {
    preset.name_en = name->text_or("en", preset.id);
    preset.name_es = name->text_or("es", preset.name_en);
  }
  preset.tolerance = json.number_or("tolerance", 0.005, 0.9, preset.tolerance);
  for (JsonReader& mode : json.objects("modes", 100)) preset.modes.push_back(read_mode(mode));
  if (preset.modes.empty()) json.fault("modes", messages::preset_modes_missing);
  for (Fault& fault : faults) fault.place = file.string() + fault.place;
  if (has_errors(faults)) return faults;
  return preset;
}

}  // namespace

const CameraMode* CameraPreset::nearest_mode(int width_px, int height_px, double hfov_rad) const {
  const CameraMode* best = nullptr;
  for (const CameraMode& mode : modes) {
    const double shape = static_cast<double>(width_px) * mode.height_px / height_px / mode.width_px;
    if (std::abs(shape - 1) > kSameShape) continue;
    if (!best || std::abs(mode.hfov_rad - hfov_rad) < std::abs(best->hfov_rad - hfov_rad)) best = &mode;
  }
  return best;
}

bool CameraPreset::agrees(const CameraMode& mode, double hfov_rad) const {
  return std::abs(hfov_rad / mode.hfov_rad - 1) <= tolerance;
}

std::vector<std::string> shipped_cameras() {
  std::vector<std::string> ids;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(data_folder("runtime/model/cameras"), error)) {
    if (entry.path().extension() == ".json") ids.push_back(entry.path().stem().string());
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

Result<CameraPreset> camera_preset(const std::string& id_or_path) {
  const std::vector<std::string> ids = shipped_cameras();
  if (std::find(ids.begin(), ids.end(), id_or_path) != ids.end()) {
    return load_preset(data_folder("runtime/model/cameras") / (id_or_path + ".json"));
  }
  const fs::path path(id_or_path);
  if (path.has_parent_path() || path.has_extension()) return load_preset(path);
  std::string known;
  for (const std::string& id : ids) known += (known.empty() ? "" : ", ") + id;
  return make_fault("camera", messages::preset_unknown, {{"camera", id_or_path}, {"known", known}});
}

}  // namespace mirada
