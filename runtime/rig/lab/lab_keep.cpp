#include "rig/lab/lab_keep.h"

#include <cmath>
#include <optional>

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "base/files.h"
#include "base/units.h"
#include "rig/lab/messages.h"
#include "vision/ground_projection.h"

namespace mirada::rig {
namespace {

using Json = nlohmann::ordered_json;

double rounded(double value) { return std::round(value * 1e4) / 1e4; }

Json robot_json(const RobotConfig& robot) {
  const CameraModel& camera = robot.camera;
  const bool fisheye = camera.lens == CameraModel::Lens::fisheye;
  const std::vector<double> bend(camera.distortion.begin(), camera.distortion.begin() + (fisheye ? 4 : 5));
  return {{"format", "mirada-robot"},
          {"version", 1},
          {"camera",
           {{"width_px", camera.width_px},
            {"height_px", camera.height_px},
            {"fx_px", camera.fx_px},
            {"fy_px", camera.fy_px},
            {"cx_px", camera.cx_px},
            {"cy_px", camera.cy_px},
            {"lens", fisheye ? "fisheye" : "brown"},
            {"distortion", bend}}},
          {"neck",
           {{"forward_m", robot.neck.p_RN_m.x()},
            {"left_m", robot.neck.p_RN_m.y()},
            {"pan", {{"min_deg", deg(robot.neck.pan.min_rad)}, {"max_deg", deg(robot.neck.pan.max_rad)}}}}},
          {"mount",
           {{"forward_m", robot.neck.p_PT_m.x() + robot.mount.p_TM_m.x()},
            {"left_m", robot.neck.p_PT_m.y() + robot.mount.p_TM_m.y()},
            {"height_m", robot.neck.p_PT_m.z() + robot.mount.p_TM_m.z()},
            {"tilt_deg", deg(robot.mount.tilt_rad)},
            {"yaw_deg", deg(robot.mount.yaw_rad)},
            {"roll_deg", deg(robot.mount.roll_rad)},
            {"sigma_tilt_deg", deg(robot.mount.sigma_tilt_rad)},
            {"sigma_height_m", robot.mount.sigma_height_m},
            {"sigma_pan_deg", deg(robot.mount.sigma_pan_rad)}}}};
}

void mark(cv::Mat& bgr, const vision::GroundProjection& ground, double bearing_rad, double distance_m,
          const cv::Scalar& colour) {
  if (!std::isfinite(distance_m)) return;
  const auto pixel = ground.pixel({distance_m * std::cos(bearing_rad), distance_m * std::sin(bearing_rad)});
  if (!pixel) return;
  cv::circle(bgr, {cvRound(pixel->x()), cvRound(pixel->y())}, 1, colour, cv::FILLED);
}

}  // namespace

struct LabKeeper::Impl {
  std::filesystem::path folder;
  RobotConfig robot;
  Json pictures = Json::array();
  std::optional<Fault> fault;

  void write_picture(const std::string& name, const cv::Mat& bgr) {
    std::vector<uchar> bytes;
    cv::imencode(".png", bgr, bytes);
    keep(write_file_atomically(folder / name,
                               std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size())));
  }
  void keep(const Status& written) {
    if (!written && !fault) fault = written.faults().front();
  }
};

LabKeeper::LabKeeper(std::filesystem::path folder, const RobotConfig& robot)
    : impl_(std::make_unique<Impl>()) {
  impl_->folder = std::move(folder);
  impl_->robot = robot;
  std::error_code error;
  std::filesystem::create_directories(impl_->folder, error);
  if (error) {
    impl_->fault = make_fault(impl_->folder.string(), messages::lab_no_folder, {{"reason", error.message()}});
  }
}

LabKeeper::~LabKeeper() = default;

void LabKeeper::add(const LabShot& shot) {
  if (impl_->fault || shot.samples.empty()) return;
  const vision::GroundProjection ground(impl_->robot, impl_->robot.camera, shot.neck);
  cv::Mat said = shot.bgr.clone();
  Json bearings = Json::array();
  for (const LabSample& sample : shot.samples) {
    const double bearing_rad = sample.reading.bearing_rad;
    Json bearing = {{"bearing_deg", rounded(deg(bearing_rad))}};
    const bool obstacle = std::isfinite(sample.truth_m);
    bearing[obstacle ? "distance_m" : "clear_m"] = obstacle ? rounded(sample.truth_m) : 100;
    bearings.push_back(bearing);
    mark(said, ground, bearing_rad, sample.truth_m, {0, 255, 0});
    mark(said, ground, bearing_rad, sample.reading.distance_m, {0, 0, 255});
  }
  impl_->write_picture(shot.name + ".png", shot.bgr);
  impl_->write_picture(shot.name + "-said.png", said);
  impl_->pictures.push_back({{"image", shot.name + ".png"},
                             {"pan_deg", rounded(deg(shot.neck.pan_rad))},
                             {"sequence", shot.room},
                             {"floor", shot.samples.front().floor},
                             {"light", shot.samples.front().light},
                             {"bearings", bearings}});
}

Status LabKeeper::finish() {
  const Json truth = {
      {"format", "mirada-truth"}, {"version", 1}, {"robot", "robot.json"}, {"pictures", impl_->pictures}};
  if (!impl_->fault) {
    impl_->keep(write_file_atomically(impl_->folder / "truth.json", truth.dump(1) + "\n"));
    impl_->keep(write_file_atomically(impl_->folder / "robot.json", robot_json(impl_->robot).dump(2) + "\n"));
  }
  if (impl_->fault) return *impl_->fault;
  return Ok{};
}

}  // namespace mirada::rig
