#include "rig/detectors.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <optional>

#include "vision/ball_finder.h"
#include "vision/faces/face_watch.h"
#include "vision/lines/line_finder.h"
#include "vision/tags/tag_spotter.h"
#include "vision/visual_sonar.h"

namespace mirada::rig {
namespace {

/// Opens the finder at its first picture; its fault, if any, is every answer.
class LazyFaceWatch {
 public:
  LazyFaceWatch(RobotConfig robot, std::string model, std::shared_ptr<vision::FaceBook> book)
      : robot_(std::move(robot)), model_(std::move(model)), book_(std::move(book)) {}

  Result<FacesPercept> look(const Frame& frame, const NeckAngles& neck, const Pose2& X_OR) {
    if (!watch_ && !trouble_) open();
    if (trouble_) return *trouble_;
    if (forget_.exchange(false)) watch_->forget();
    return watch_->look(frame, neck, X_OR);
  }
  void forget() { forget_ = true; }

 private:
  void open() {
    auto finder = vision::FaceFinder::open(robot_, model_);
    if (finder) {
      watch_.emplace(robot_, std::move(*finder), book_);
    } else {
      trouble_ = finder.faults();
    }
  }

  RobotConfig robot_;
  std::string model_;
  std::shared_ptr<vision::FaceBook> book_;
  std::optional<vision::FaceWatch> watch_;
  std::optional<Faults> trouble_;
  std::atomic<bool> forget_{false};
};

constexpr double kSureFacing = 0.35;  // the second pose must fit three times worse
constexpr double kTagDistanceShare = 0.03;

/// Tags and balls; opens what it needs at its first picture.
class ThingFinder {
 public:
  explicit ThingFinder(const RobotConfig& robot) : robot_(robot), balls_(robot) {}

  ThingsPercept find(const Frame& frame, const NeckAngles& neck, const Pose2& X_OR) {
    if (!tags_) tags_.emplace(robot_, kTagSide_m);
    ThingsPercept out;
    out.frame = frame.number;
    out.t_exposure = frame.t_exposure;
    out.X_OR = X_OR;
    for (const vision::TagSpot& tag : tags_->look(frame, neck)) {
      const Eigen::Vector3d out_of_paper_R = tag.X_RT.linear().col(2);
      out.things.push_back({ThingKind::tag, tag.id, tag.bearing_rad, tag.distance_m,
                            kTagDistanceShare * tag.distance_m,
                            std::atan2(out_of_paper_R.y(), out_of_paper_R.x()), tag.ambiguity < kSureFacing});
    }
    if (const auto ball = balls_.find(frame, neck)) out.things.push_back(*ball);
    return out;
  }

 private:
  RobotConfig robot_;
  vision::BallFinder balls_;
  std::optional<vision::TagSpotter> tags_;
};

/// The lines of the place that the robot knows; null when it has none.
std::shared_ptr<vision::LineFinder> line_finder(const RobotConfig& robot) {
  if (!robot.place || !robot.place->has_lines()) return nullptr;
  double narrowest_m = HUGE_VAL, widest_m = 0;
  const auto widen = [&](double width_m) {
    narrowest_m = std::min(narrowest_m, width_m);
    widest_m = std::max(widest_m, width_m);
  };
  for (const PlaceLine& line : robot.place->lines) widen(line.width_m);
  for (const PlaceCircle& circle : robot.place->circles) widen(circle.width_m);
  return std::make_shared<vision::LineFinder>(robot, narrowest_m, widest_m);
}

}  // namespace

robot::Detectors make_detectors(const RobotConfig& robot, const std::string& face_model,
                                std::shared_ptr<vision::FaceBook> book) {
  const auto sonar = std::make_shared<vision::VisualSonar>(robot);
  const auto faces = std::make_shared<LazyFaceWatch>(robot, face_model, book);
  const auto things = std::make_shared<ThingFinder>(robot);
  robot::Detectors out;
  out.book = std::move(book);
  out.sonar = [sonar](const Frame& frame, const NeckAngles& neck, const Pose2& X_OR) {
    return sonar->look(frame, neck, X_OR);
  };
  out.faces = [faces](const Frame& frame, const NeckAngles& neck, const Pose2& X_OR) {
    return faces->look(frame, neck, X_OR);
  };
  out.forget_faces = [faces] { faces->forget(); };
  out.things = [things](const Frame& frame, const NeckAngles& neck, const Pose2& X_OR) {
    return things->find(frame, neck, X_OR);
  };
  if (const auto lines = line_finder(robot)) {
    out.lines = [lines](const Frame& frame, const NeckAngles& neck, const Pose2& X_OR) {
      return LinesPercept{frame.number, frame.t_exposure, X_OR, lines->find(frame, neck)};
    };
  }
  out.forget_floor = [sonar] { sonar->forget(); };
  return out;
}

}  // namespace mirada::rig
