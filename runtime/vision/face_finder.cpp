#include "vision/face_finder.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <tuple>
#include <variant>

#include "vision/faces/face_net.h"
#include "vision/faces/haar_faces.h"
#include "vision/ground_projection.h"
#include "vision/messages.h"

namespace mirada::vision {
namespace {

constexpr double kNominalDistance_m = 1.5;

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

using Detector = std::variant<FaceNet, HaarFaces>;

class PlacingFaceFinder final : public FaceFinder {
 public:
  PlacingFaceFinder(const RobotConfig& robot, Detector detector, std::optional<Fault> fallback)
      : robot_(robot), detector_(std::move(detector)), fallback_(std::move(fallback)) {}

  FacesPercept find(const Frame& frame, const NeckAngles& neck) override;
  const std::optional<Fault>& fallback() const override { return fallback_; }

 private:
  RobotConfig robot_;
  Detector detector_;
  std::optional<Fault> fallback_;
};

FacesPercept PlacingFaceFinder::find(const Frame& frame, const NeckAngles& neck) {
  FacesPercept percept;
  percept.frame = frame.number;
  percept.t_exposure = frame.t_exposure;
  percept.detector = std::holds_alternative<FaceNet>(detector_) ? "ultraface" : "haar";
  percept.picture_width_px = frame.bgr.cols;
  percept.picture_height_px = frame.bgr.rows;
  const CameraModel camera = robot_.camera.scaled_to(frame.bgr.cols, frame.bgr.rows);
  const Eigen::Isometry3d X_RC = robot_.X_RC(neck);
  for (const auto& [box, score] : std::visit([&](auto& find) { return find.find(frame.bgr); }, detector_)) {
    FacePercept face{box.x, box.y, box.width, box.height};
    face.score = score;
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

std::optional<Fault> face_fallback(const std::string& model) {
  std::error_code error;
  if (!model.empty() || std::filesystem::exists(FaceNet::default_file(), error)) return std::nullopt;
  return make_fault("faces", messages::face_net_not_fetched, {}, Severity::warning);
}

Status check_face_model(const std::string& model) {
  if (model.empty()) return Ok{};
  const auto net = FaceNet::open(model);
  return net ? Status(Ok{}) : Status(net.faults());
}

Result<std::unique_ptr<FaceFinder>> FaceFinder::open(const RobotConfig& robot, const std::string& model) {
  std::optional<Fault> fallback = face_fallback(model);
  if (!fallback) {
    auto net = FaceNet::open(model.empty() ? FaceNet::default_file() : model);
    if (net) return std::unique_ptr<FaceFinder>(new PlacingFaceFinder(robot, std::move(*net), {}));
    if (!model.empty()) return net.faults();
    fallback = net.faults().front();
    fallback->severity = Severity::warning;
  }
  auto haar = HaarFaces::open();
  if (!haar) return haar.faults();
  return std::unique_ptr<FaceFinder>(new PlacingFaceFinder(robot, std::move(*haar), std::move(fallback)));
}

}  // namespace mirada::vision
