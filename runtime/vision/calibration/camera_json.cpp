#include "vision/calibration/camera_json.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "base/units.h"

namespace mirada::vision {
namespace {

using Json = nlohmann::ordered_json;

double rounded(double value, int digits) {
  const double by = std::pow(10, digits);
  return std::round(value * by) / by;
}

Json board_json(const BoardSpec& board) {
  Json out;
  const bool charuco = board.kind == BoardSpec::Kind::charuco;
  out["kind"] = charuco ? "charuco" : "chessboard";
  out["corner_columns"] = board.corner_columns;
  out["corner_rows"] = board.corner_rows;
  out["square_mm"] = rounded(board.square_m * 1e3, 4);
  if (charuco) out["marker_mm"] = rounded(board.marker_m * 1e3, 4);
  return out;
}

Json view_json(const SolvedView& view) {
  return {{"image", view.image},
          {"rms_px", rounded(view.rms_px, 4)},
          {"edge_px", rounded(view.edge_width_px, 2)},
          {"tilt_deg", rounded(deg(view.tilt_rad), 1)},
          {"distance_m", rounded(view.distance_m, 3)}};
}

Json quality_json(const Calibration& c, const BoardSpec& board) {
  Json out;
  out["rms_px"] = rounded(c.rms_px, 5);
  out["views"] = c.views.size();
  out["coverage"] = rounded(c.coverage, 3);
  out["sigma_fx_px"] = rounded(c.sigma_fx_px, 3);
  out["sigma_fy_px"] = rounded(c.sigma_fy_px, 3);
  out["sigma_cx_px"] = rounded(c.sigma_cx_px, 3);
  out["sigma_cy_px"] = rounded(c.sigma_cy_px, 3);
  out["seen_hfov_deg"] = rounded(deg(c.seen_hfov_rad), 2);
  out["seen_vfov_deg"] = rounded(deg(c.seen_vfov_rad), 2);
  out["board"] = board_json(board);
  out["images"] = Json::array();
  for (const SolvedView& view : c.views) out["images"].push_back(view_json(view));
  return out;
}

}  // namespace

nlohmann::ordered_json camera_json(const Calibration& calibration, const BoardSpec& board,
                                   const std::string& preset_id) {
  const CameraModel& camera = calibration.camera;
  const bool fisheye = camera.lens == CameraModel::Lens::fisheye;
  Json out;
  out["format"] = "mirada-camera";
  out["version"] = 1;
  out["name"] = camera.name;
  if (!preset_id.empty()) out["preset"] = preset_id;
  out["width_px"] = camera.width_px;
  out["height_px"] = camera.height_px;
  out["hfov_deg"] = rounded(deg(camera.hfov_rad()), 3);
  out["vfov_deg"] = rounded(deg(camera.vfov_rad()), 3);
  out["fx_px"] = camera.fx_px;
  out["fy_px"] = camera.fy_px;
  out["cx_px"] = camera.cx_px;
  out["cy_px"] = camera.cy_px;
  out["lens"] = fisheye ? "fisheye" : "brown";
  out["distortion"] =
      std::vector<double>(camera.distortion.begin(), camera.distortion.begin() + (fisheye ? 4 : 5));
  out["calibration"] = quality_json(calibration, board);
  return out;
}

}  // namespace mirada::vision
