#include "rig/detectors.h"

#include <memory>
#include <optional>

#include "vision/face_finder.h"
#include "vision/visual_sonar.h"

namespace mirada::rig {
namespace {

/// Opens the finder once; its fault, if any, is every answer.
class LazyFaceFinder {
 public:
  explicit LazyFaceFinder(RobotConfig robot) : robot_(std::move(robot)) {}

  Result<FacesPercept> find(const Frame& frame, const NeckAngles& neck) {
    if (!finder_) finder_.emplace(vision::FaceFinder::open(robot_));
    if (!*finder_) return finder_->faults();
    return finder_->value()->find(frame, neck);
  }

 private:
  RobotConfig robot_;
  std::optional<Result<std::unique_ptr<vision::FaceFinder>>> finder_;
};

}  // namespace

robot::Detectors make_detectors(const RobotConfig& robot) {
  const auto sonar = std::make_shared<vision::VisualSonar>(robot);
  const auto faces = std::make_shared<LazyFaceFinder>(robot);
  robot::Detectors out;
  out.sonar = [sonar](const Frame& frame, const NeckAngles& neck, const Pose2& X_OR) {
    return sonar->look(frame, neck, X_OR);
  };
  out.faces = [faces](const Frame& frame, const NeckAngles& neck) { return faces->find(frame, neck); };
  out.forget_floor = [sonar] { sonar->forget(); };
  return out;
}

}  // namespace mirada::rig
