#include <cmath>

#include <nlohmann/json.hpp>

#include "model/messages.h"
#include "model/robot_sections.h"

namespace mirada {
namespace {

constexpr double kMinFocal_px = 10;
constexpr double kMaxFocal_px = 20'000;

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

}  // namespace

void read_camera(JsonReader& json, RobotConfig& robot) {
  json.only({"name", "width_px", "height_px", "hfov_deg", "vfov_deg", "fx_px", "fy_px", "cx_px", "cy_px",
             "lens", "distortion", "fps"});
  CameraModel& camera = robot.camera;
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
  robot.camera_fps = json.number_or("fps", 1, 240, robot.camera_fps);
}

}  // namespace mirada
