#include <cmath>

#include <nlohmann/json.hpp>

#include "model/camera_file.h"
#include "model/messages.h"
#include "model/robot_sections.h"

namespace mirada {
namespace {

constexpr double kMinFocal_px = 10;
constexpr double kMaxFocal_px = 20'000;
/// How far width : height may differ between two sizes of one picture.
constexpr double kSameAspect = 0.01;

double focal_from_view(double view_rad, int size_px) { return size_px / (2 * std::tan(view_rad / 2)); }

void read_view(JsonReader& json, CameraModel& camera) {
  const bool has_view = json.has("hfov_deg");
  const double hfov_deg = has_view ? json.number("hfov_deg", 1, 175) : 0;
  if (json.has("fx_px")) {
    camera.fx_px = json.number("fx_px", kMinFocal_px, kMaxFocal_px);
    const double seen_deg = deg(camera.hfov_rad());
    if (has_view && hfov_deg > 0 && std::abs(seen_deg - hfov_deg) > 0.05 * hfov_deg) {
      json.fault("hfov_deg", messages::camera_view_twice,
                 {{"value", number_text(hfov_deg, 1)}, {"seen", number_text(seen_deg, 1)}});
    }
  } else if (has_view) {
    camera.fx_px = focal_from_view(rad(hfov_deg), camera.width_px);
  } else {
    json.fault("hfov_deg", messages::camera_view_missing);
  }
  camera.fy_px = json.number_or("fy_px", kMinFocal_px, kMaxFocal_px, camera.fx_px);
  if (json.has("vfov_deg") && !json.has("fy_px")) {
    camera.fy_px = focal_from_view(rad(json.number("vfov_deg", 1, 175)), camera.height_px);
  }
}

void read_lens(JsonReader& json, CameraModel& camera) {
  if (json.has("lens") && json.choice("lens", {"brown", "fisheye"}) == "fisheye") {
    camera.lens = CameraModel::Lens::fisheye;
  }
  if (!json.has("distortion")) return;
  const std::size_t most = camera.lens == CameraModel::Lens::fisheye ? 4 : 5;
  const std::vector<double> values = json.numbers("distortion", 1, most, -100, 100);
  std::copy(values.begin(), values.end(), camera.distortion.begin());
}

/// A calibration that covered little may fold in the far corners (nothing is seen there then); never before
/// the edges.
void check_edges(JsonReader& json, const CameraModel& camera) {
  const double right = camera.width_px - 1.0;
  const double bottom = camera.height_px - 1.0;
  const Eigen::Vector2d middles[] = {
      {0, camera.cy_px}, {right, camera.cy_px}, {camera.cx_px, 0}, {camera.cx_px, bottom}};
  for (const Eigen::Vector2d& pixel : middles) {
    if (camera.unproject(pixel)) continue;
    const std::string text = number_text(pixel.x(), 0) + ", " + number_text(pixel.y(), 0);
    json.fault("distortion", messages::camera_distortion_folds, {{"pixel", text}});
    return;
  }
}

constexpr const char* kLensFields[] = {"vfov_deg", "fx_px", "fy_px", "cx_px", "cy_px", "lens", "distortion"};

std::string size_text(int width_px, int height_px) {
  return std::to_string(width_px) + "x" + std::to_string(height_px);
}

/// What robot.json says of the camera beside the calibration must belong to the same camera.
void check_same_camera(JsonReader& json, const CameraModel& measured) {
  for (const char* field : kLensFields) {
    if (json.has(field)) json.fault(field, messages::camera_said_twice);
  }
  const std::string name = json.text_or("name", measured.name);
  if (!measured.name.empty() && name != measured.name) {
    json.fault("calibration", messages::camera_file_other_camera,
               {{"theirs", measured.name}, {"ours", name}});
  }
  if (!json.has("hfov_deg")) return;
  const double hfov_deg = json.number("hfov_deg", 1, 175);
  const double seen_deg = deg(measured.hfov_rad());
  if (hfov_deg > 0 && std::abs(seen_deg - hfov_deg) > 0.05 * hfov_deg) {
    json.fault("calibration", messages::camera_file_other_view,
               {{"value", number_text(hfov_deg, 1)}, {"seen", number_text(seen_deg, 1)}});
  }
}

void take_calibration(JsonReader& json, const std::filesystem::path& folder, CameraModel& camera,
                      Faults& file_faults) {
  const std::string file = json.text("calibration");
  if (file.empty()) return;
  auto measured = load_camera_file(folder / file, &file_faults);
  if (!measured) {
    file_faults.insert(file_faults.end(), measured.faults().begin(), measured.faults().end());
    return;
  }
  check_same_camera(json, *measured);
  const int width_px = static_cast<int>(json.number_or("width_px", 16, 10'000, measured->width_px));
  const int height_px = static_cast<int>(json.number_or("height_px", 16, 10'000, measured->height_px));
  const double aspect = static_cast<double>(width_px) * measured->height_px / height_px / measured->width_px;
  if (std::abs(aspect - 1) > kSameAspect) {
    json.fault("calibration", messages::camera_file_other_size,
               {{"theirs", size_text(measured->width_px, measured->height_px)},
                {"ours", size_text(width_px, height_px)}});
  }
  camera = measured->scaled_to(width_px, height_px);
}

}  // namespace

void read_camera_model(JsonReader& json, CameraModel& camera) {
  camera.name = json.text_or("name", "");
  camera.width_px = static_cast<int>(json.number_or("width_px", 16, 10'000, 320));
  camera.height_px = static_cast<int>(json.number_or("height_px", 16, 10'000, 240));
  read_view(json, camera);
  const double w = camera.width_px;
  const double h = camera.height_px;
  camera.cx_px = json.number_or("cx_px", 0, w - 1, (w - 1) / 2);
  camera.cy_px = json.number_or("cy_px", 0, h - 1, (h - 1) / 2);
  read_lens(json, camera);
  check_edges(json, camera);
}

void read_camera(JsonReader& json, const std::filesystem::path& folder, RobotConfig& robot,
                 Faults& file_faults) {
  json.only({"name", "width_px", "height_px", "hfov_deg", "vfov_deg", "fx_px", "fy_px", "cx_px", "cy_px",
             "lens", "distortion", "calibration", "fps"});
  if (json.has("calibration")) {
    take_calibration(json, folder, robot.camera, file_faults);
  } else {
    read_camera_model(json, robot.camera);
  }
  robot.camera_fps = json.number_or("fps", 1, 240, robot.camera_fps);
}

}  // namespace mirada
