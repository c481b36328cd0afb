#include "vision/face_finder.h"

#include <algorithm>
#include <filesystem>
#include <tuple>
#include <variant>

#include "vision/faces/face_net.h"
#include "vision/faces/face_place.h"
#include "vision/faces/haar_faces.h"
#include "vision/messages.h"

namespace mirada::vision {
namespace {

using Detector = std::variant<FaceNet, HaarFaces>;

class PlacingFaceFinder final : public FaceFinder {
 public:
  PlacingFaceFinder(const RobotConfig& robot, Detector detector, std::optional<Fault> fallback)
      : robot_(robot), detector_(std::move(detector)), fallback_(std::move(fallback)) {}

  FacesPercept find(const Frame& frame, const NeckAngles& neck) override;
  FacesPercept none(const Frame& frame) const override;
  FacePercept place(const FaceBox& box, const Frame& frame, const NeckAngles& neck) const override;
  const std::optional<Fault>& fallback() const override { return fallback_; }

 private:
  RobotConfig robot_;
  Detector detector_;
  std::optional<Fault> fallback_;
};

FacesPercept PlacingFaceFinder::none(const Frame& frame) const {
  FacesPercept percept;
  percept.frame = frame.number;
  percept.t_exposure = frame.t_exposure;
  percept.detector = std::holds_alternative<FaceNet>(detector_) ? "ultraface" : "haar";
  percept.picture_width_px = frame.bgr.cols;
  percept.picture_height_px = frame.bgr.rows;
  return percept;
}

FacePercept PlacingFaceFinder::place(const FaceBox& box, const Frame& frame, const NeckAngles& neck) const {
  return place_face(box, robot_.camera.scaled_to(frame.bgr.cols, frame.bgr.rows), robot_.X_RC(neck));
}

FacesPercept PlacingFaceFinder::find(const Frame& frame, const NeckAngles& neck) {
  FacesPercept percept = none(frame);
  for (const FaceBox& box : std::visit([&](auto& finder) { return finder.find(frame.bgr); }, detector_))
    percept.faces.push_back(place(box, frame, neck));
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
