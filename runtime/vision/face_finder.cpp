#include "vision/face_finder.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <tuple>

#include <opencv2/imgproc.hpp>
#include <opencv2/objdetect.hpp>

#include "vision/ground_projection.h"
#include "vision/messages.h"

namespace mirada::vision {
namespace {

constexpr const char* kFolders[] = {"/usr/share/opencv4/haarcascades", "/usr/share/opencv/haarcascades",
                                    "/usr/local/share/opencv4/haarcascades"};
constexpr const char* kFile = "haarcascade_frontalface_alt2.xml";
constexpr double kScaleStep = 1.15;
constexpr int kNeighbours = 3;
constexpr double kSmallestShare = 0.1;  // of the picture's height
constexpr int kWorkWidth_px = 320;      // larger pictures are looked at in this size
constexpr double kNominalDistance_m = 1.5;

std::string cascade_file() {
  std::error_code error;
  for (const char* folder : kFolders) {
    const std::filesystem::path file = std::filesystem::path(folder) / kFile;
    if (std::filesystem::exists(file, error)) return file.string();
  }
  return std::string(kFolders[0]) + "/" + kFile;
}

/// A face has no foot on the floor to measure: its bearing is that of a point on its ray as far away as
/// people stand.
double bearing_of(const Eigen::Vector3d& ray_R, const Eigen::Isometry3d& X_RC) {
  const Eigen::Vector2d away = ray_R.head<2>().normalized();
  const Eigen::Vector2d lens = X_RC.translation().head<2>();
  // The point of the ray that lies kNominalDistance_m from the robot's origin.
  const double along = lens.dot(away);
  const double reach =
      -along +
      std::sqrt(std::max(0.0, along * along - lens.squaredNorm() + kNominalDistance_m * kNominalDistance_m));
  const Eigen::Vector2d p = lens + reach * away;
  return std::atan2(p.y(), p.x());
}

class HaarFaceFinder final : public FaceFinder {
 public:
  HaarFaceFinder(const RobotConfig& robot, cv::CascadeClassifier cascade)
      : robot_(robot), cascade_(std::move(cascade)) {}

  FacesPercept find(const Frame& frame, const NeckAngles& neck) override;

 private:
  RobotConfig robot_;
  cv::CascadeClassifier cascade_;
  cv::Mat gray_;
  std::vector<cv::Rect> boxes_;
  std::vector<int> levels_;
  std::vector<double> weights_;
};

FacesPercept HaarFaceFinder::find(const Frame& frame, const NeckAngles& neck) {
  FacesPercept percept;
  percept.frame = frame.number;
  percept.t_exposure = frame.t_exposure;
  percept.detector = "haar";
  percept.picture_width_px = frame.bgr.cols;
  percept.picture_height_px = frame.bgr.rows;
  if (frame.bgr.empty() || frame.bgr.type() != CV_8UC3 || std::min(frame.bgr.cols, frame.bgr.rows) < 24)
    return percept;
  cv::cvtColor(frame.bgr, gray_, cv::COLOR_BGR2GRAY);
  const double scale = std::max(1.0, static_cast<double>(gray_.cols) / kWorkWidth_px);
  if (scale > 1) cv::resize(gray_, gray_, {}, 1 / scale, 1 / scale, cv::INTER_AREA);
  const int smallest = std::max(20, static_cast<int>(kSmallestShare * gray_.rows));
  cascade_.detectMultiScale(gray_, boxes_, levels_, weights_, kScaleStep, kNeighbours, 0,
                            {smallest, smallest}, {}, true);
  const CameraModel camera = robot_.camera.scaled_to(frame.bgr.cols, frame.bgr.rows);
  const Eigen::Isometry3d X_RC = robot_.X_RC(neck);
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    const cv::Rect& box = boxes_[i];
    FacePercept face{box.x * scale, box.y * scale, box.width * scale, box.height * scale};
    // The last stage's margin has no fixed scale; squashed so that more is surer and 1 is never reached.
    face.score = 1 / (1 + std::exp(-std::max(0.0, weights_[i]) / 2));
    if (const auto ray_C = camera.unproject({face.x_px + face.w_px / 2, face.y_px + face.h_px / 2})) {
      const Eigen::Vector3d ray_R = X_RC.linear() * *ray_C;
      face.bearing_rad = bearing_of(ray_R, X_RC);
      face.elevation_rad = std::atan2(ray_R.z(), ray_R.head<2>().norm());
    }
    percept.faces.push_back(face);
  }
  std::sort(percept.faces.begin(), percept.faces.end(), [](const FacePercept& a, const FacePercept& b) {
    return std::tuple(-a.w_px, a.x_px, a.y_px) < std::tuple(-b.w_px, b.x_px, b.y_px);
  });
  return percept;
}

}  // namespace

Result<std::unique_ptr<FaceFinder>> FaceFinder::open(const RobotConfig& robot) {
  const std::string file = cascade_file();
  std::error_code error;
  if (!std::filesystem::exists(file, error)) {
    return make_fault("faces", messages::face_cascade_missing, {{"file", file}});
  }
  cv::CascadeClassifier cascade;
  if (!cascade.load(file)) return make_fault("faces", messages::face_cascade_broken, {{"file", file}});
  return std::unique_ptr<FaceFinder>(std::make_unique<HaarFaceFinder>(robot, std::move(cascade)));
}

}  // namespace mirada::vision
