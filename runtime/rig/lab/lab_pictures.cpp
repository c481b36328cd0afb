#include "rig/lab/lab_pictures.h"

#include <cmath>
#include <limits>
#include <map>
#include <memory>

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "base/files.h"
#include "base/json_reader.h"
#include "base/units.h"
#include "rig/lab/lab_distances.h"
#include "rig/lab/messages.h"
#include "vision/ground_projection.h"

namespace mirada::rig {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kFarthest_m = 100;
constexpr std::uintmax_t kMaxPictureFile_bytes = 256u << 20;
constexpr double kPictureMatch_rad = rad(0.51);

KnownBearing read_bearing(JsonReader& json) {
  json.only({"bearing_deg", "distance_m", "clear_m"});
  KnownBearing out;
  out.bearing_rad = rad(json.number("bearing_deg", -180, 180));
  if (json.has("distance_m") == json.has("clear_m"))
    json.fault("distance_m", messages::lab_distance_or_clear);
  out.distance_m = kInfinity;
  if (json.has("distance_m")) {
    out.distance_m = out.free_m = json.number("distance_m", 0.01, kFarthest_m);
  } else if (json.has("clear_m")) {
    out.free_m = json.number("clear_m", 0.01, kFarthest_m);
  }
  return out;
}

KnownPicture read_picture(JsonReader& json, const std::filesystem::path& folder) {
  json.only({"image", "robot", "pan_deg", "tilt_deg", "sequence", "floor", "light", "bearings"});
  KnownPicture out;
  out.image = folder / json.text("image");
  out.robot = json.text_or("robot", "");
  out.neck = {rad(json.number_or("pan_deg", -180, 180, 0)), rad(json.number_or("tilt_deg", -90, 90, 0))};
  out.sequence = json.text_or("sequence", "");
  out.floor = json.text_or("floor", "?");
  out.light = json.text_or("light", "?");
  for (JsonReader& bearing : json.objects("bearings", 1000)) out.bearings.push_back(read_bearing(bearing));
  if (out.bearings.empty()) json.fault("bearings", messages::lab_no_bearings);
  return out;
}

/// A robot named in truth.json: a file beside it, a file, or an id.
Result<RobotConfig> find_robot(const std::string& name, const std::filesystem::path& folder) {
  std::error_code error;
  if (std::filesystem::exists(folder / name, error)) return load_robot(folder / name);
  return robot_by_name(name);
}

Result<cv::Mat> read_picture_file(const std::filesystem::path& file) {
  auto bytes = read_file(file, kMaxPictureFile_bytes);
  if (!bytes) return bytes.faults();
  cv::Mat bgr;
  try {
    const cv::Mat raw(1, static_cast<int>(bytes->size()), CV_8UC1, bytes->data());
    if (!bytes->empty()) bgr = cv::imdecode(raw, cv::IMREAD_COLOR | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception&) {
    bgr.release();
  }
  if (bgr.empty()) return make_fault(file.string(), messages::lab_no_picture);
  return bgr;
}

const SonarReading* nearest_reading(const SonarPercept& seen, double bearing_rad) {
  const SonarReading* best = nullptr;
  double best_rad = kPictureMatch_rad;
  for (const SonarReading& reading : seen.readings) {
    const double off_rad = std::abs(wrap_rad(reading.bearing_rad - bearing_rad));
    if (off_rad >= best_rad) continue;
    best_rad = off_rad;
    best = &reading;
  }
  return best;
}

void score_picture(const KnownPicture& picture, const RobotConfig& robot, const cv::Mat& bgr,
                   const SonarPercept& seen, std::vector<LabSample>& out) {
  const CameraModel camera = robot.camera.scaled_to(bgr.cols, bgr.rows);
  const vision::GroundProjection ground(robot, camera, picture.neck);
  const std::vector<double> paper = paper_readings(robot, camera, seen);
  for (const KnownBearing& known : picture.bearings) {
    const SonarReading* reading = nearest_reading(seen, known.bearing_rad);
    LabSample sample;
    sample.picture = picture.image.filename().string();
    sample.floor = picture.floor;
    sample.light = picture.light;
    sample.off_axis_rad = known.bearing_rad - picture.neck.pan_rad;
    sample.truth_m = known.distance_m;
    sample.free_m = known.free_m;
    if (std::isfinite(known.distance_m)) {
      const Eigen::Vector2d foot_R_m(known.distance_m * std::cos(known.bearing_rad),
                                     known.distance_m * std::sin(known.bearing_rad));
      const auto pixel = ground.pixel(foot_R_m);
      sample.foot_seen = pixel && pixel->y() <= bgr.rows - 1 && pixel->x() >= 0 && pixel->x() <= bgr.cols - 1;
    }
    if (reading) sample.reading = *reading;
    sample.paper_m = reading ? paper[static_cast<std::size_t>(reading - seen.readings.data())]
                             : std::numeric_limits<double>::quiet_NaN();
    out.push_back(sample);
  }
}

/// One robot with its eyes; the learnt floor lives as long as a sequence.
struct Watcher {
  RobotConfig robot;
  std::unique_ptr<vision::VisualSonar> sonar;
  std::string sequence;
};

}  // namespace

Result<std::vector<KnownPicture>> read_truth(const std::filesystem::path& folder, Faults* warnings) {
  const std::filesystem::path file = folder / "truth.json";
  auto text = read_file(file);
  if (!text) return text.faults();
  auto parsed = parse_json(*text, file.string());
  if (!parsed) return parsed.faults();
  Faults faults;
  std::vector<KnownPicture> out;
  JsonReader json(*parsed, "", faults);
  json.only({"format", "version", "robot", "pictures"});
  const std::string format = json.text_or("format", "mirada-truth");
  if (format != "mirada-truth") json.fault("format", messages::lab_format, {{"value", format.substr(0, 40)}});
  json.number_or("version", 1, 1, 1);
  const std::string robot = json.text_or("robot", "");
  for (JsonReader& picture : json.objects("pictures", 100'000)) {
    out.push_back(read_picture(picture, folder));
    if (out.back().robot.empty()) out.back().robot = robot;
  }
  if (out.empty()) json.fault("pictures", messages::lab_no_pictures);
  for (Fault& fault : faults) fault.place = file.string() + fault.place;
  if (has_errors(faults)) return faults;
  if (warnings) warnings->insert(warnings->end(), faults.begin(), faults.end());
  return out;
}

Result<std::vector<LabSample>> look_at_pictures(const std::vector<KnownPicture>& pictures,
                                                const std::string& robot, const std::filesystem::path& folder,
                                                const vision::SonarSettings& settings) {
  std::map<std::string, Watcher> watchers;
  Faults faults;
  std::vector<LabSample> out;
  Frame frame;
  for (const KnownPicture& picture : pictures) {
    const std::string name = picture.robot.empty() ? robot : picture.robot;
    if (!watchers.contains(name)) {
      Watcher& fresh = watchers[name];
      auto found = find_robot(name, folder);
      if (!found) {
        faults.insert(faults.end(), found.faults().begin(), found.faults().end());
        continue;
      }
      fresh.robot = std::move(*found);
      fresh.sonar = std::make_unique<vision::VisualSonar>(fresh.robot, settings);
    }
    Watcher& watcher = watchers[name];
    if (!watcher.sonar) continue;
    auto bgr = read_picture_file(picture.image);
    if (!bgr) {
      faults.insert(faults.end(), bgr.faults().begin(), bgr.faults().end());
      continue;
    }
    frame.bgr = std::move(*bgr);
    if (picture.sequence.empty() || picture.sequence != watcher.sequence) watcher.sonar->forget();
    watcher.sequence = picture.sequence;
    ++frame.number;
    frame.t_exposure += 500 * kMillisecond;
    score_picture(picture, watcher.robot, frame.bgr, watcher.sonar->look(frame, picture.neck, {}), out);
  }
  if (!faults.empty()) return faults;
  return out;
}

}  // namespace mirada::rig
