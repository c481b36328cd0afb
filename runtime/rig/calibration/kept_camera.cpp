#include "rig/calibration/kept_camera.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "base/files.h"
#include "model/camera_file.h"
#include "rig/messages.h"
#include "rig/own_folder.h"

namespace mirada::rig {
namespace fs = std::filesystem;
namespace {

constexpr double kSameShape = 0.01;

/// What the robot's file names as its calibration, "" if nothing.
std::string named_calibration(const fs::path& robot_file) {
  const auto text = read_file(robot_file, 4u << 20);
  if (!text) return "";
  const auto json = nlohmann::json::parse(*text, nullptr, false);
  if (!json.is_object() || !json.contains("camera") || !json["camera"].is_object()) return "";
  const auto& camera = json["camera"];
  const auto named = camera.find("calibration");
  return named != camera.end() && named->is_string() ? named->get<std::string>() : "";
}

std::string size_text(int width_px, int height_px) {
  return std::to_string(width_px) + "x" + std::to_string(height_px);
}

fs::path free_name(const fs::path& file) {
  std::error_code error;
  for (int n = 1;; ++n) {
    fs::path candidate =
        file.parent_path() / (file.stem().string() + ".before-" + std::to_string(n) + ".json");
    if (!fs::exists(candidate, error)) return candidate;
  }
}

}  // namespace

fs::path kept_camera_file(const std::string& robot, bool simulated) {
  const std::vector<std::string> ids = shipped_robots();
  const char* ending = simulated ? ".simulated.camera.json" : ".camera.json";
  if (std::find(ids.begin(), ids.end(), robot) != ids.end())
    return own_folder() / "cameras" / (robot + ending);
  const fs::path file(robot);
  if (!simulated) {
    if (const std::string named = named_calibration(file); !named.empty()) return file.parent_path() / named;
  }
  return file.parent_path() / (file.stem().string() + ending);
}

Status use_kept_camera(const fs::path& file, RobotConfig& robot) {
  std::error_code error;
  if (!fs::exists(file, error)) return Ok{};
  const auto camera = load_camera_file(file);
  if (!camera) {
    Faults faults{
        make_fault(file.string(), messages::kept_camera_broken, {{"file", file.filename().string()}})};
    faults.insert(faults.end(), camera.faults().begin(), camera.faults().end());
    return faults;
  }
  const CameraModel& own = robot.camera;
  const double shape =
      static_cast<double>(own.width_px) * camera->height_px / own.height_px / camera->width_px;
  if (std::abs(shape - 1) > kSameShape) {
    return make_fault(file.string(), messages::kept_camera_other_size,
                      {{"theirs", size_text(camera->width_px, camera->height_px)},
                       {"ours", size_text(own.width_px, own.height_px)}});
  }
  if (!own.name.empty() && !camera->name.empty() && own.name != camera->name) {
    return make_fault(file.string(), messages::kept_camera_other_name,
                      {{"theirs", camera->name}, {"ours", own.name}});
  }
  robot.camera = camera->scaled_to(own.width_px, own.height_px);
  return Ok{};
}

Result<std::optional<fs::path>> keep_camera(const fs::path& file, const std::string& camera_json) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  std::optional<fs::path> before;
  if (fs::exists(file, error)) {
    before = free_name(file);
    const auto old = read_file(file);
    if (!old) return old.faults();
    const Status kept = write_file_atomically(*before, *old);
    if (!kept) return kept.faults();
  }
  const Status written = write_file_atomically(file, camera_json);
  if (!written) return written.faults();
  return before;
}

}  // namespace mirada::rig
