#include "robot/robot.h"

namespace mirada::robot {
namespace {
constexpr std::size_t kMostNotes = 100;
}

Robot::Robot(RobotConfig config, const Devices& devices, Detectors detectors, Timing timing,
             const Clock& clock, const Clock& guard)
    : config_(std::move(config)),
      devices_(devices),
      clock_(&clock),
      safety_(devices.drive, config_.drive, guard),
      motion_(config_.drive, safety_),
      gaze_(devices.neck, config_.neck),
      perception_(devices.camera, std::move(detectors), config_.latency, timing),
      memory_(config_) {}

void Robot::observe() {
  if (devices_.drive != nullptr) odometry_ = devices_.drive->odometry();
  history_.record(now(), {odometry_.X_OR, gaze_.state(now()).angles});
  if (perception_.step(now(), history_)) safety_.frame_seen(now() - perception_.frame().t_exposure);
  memory_.moved(now(), odometry_.X_OR);
  if (perception_.needs().memory) remember();
}

void Robot::remember() {
  const SonarPercept& sonar = perception_.percepts()->sonar;
  if (sonar.frame == remembered_frame_) return;
  remembered_frame_ = sonar.frame;
  if (sonar.frame != 0 && history_.steady(sonar.t_exposure)) memory_.observe(sonar);
}

Recall Robot::obstacle_at(double bearing_rad) const {
  return recall(sonar(), perception_.percepts()->sonar.t_exposure, memory_, bearing_rad);
}

Safety::Verdict Robot::act() { return motion_.step(now(), odometry_); }

SonarView Robot::sonar() const { return {perception_.percepts()->sonar, odometry_.X_OR, now()}; }

const FacesPercept* Robot::faces() const {
  const FacesPercept& faces = perception_.percepts()->faces;
  const bool fresh = faces.frame != 0 && now() - faces.t_exposure <= kPerceptLife;
  return fresh ? &faces : nullptr;
}

void Robot::note(const std::string& block, Fault fault) {
  for (const Note& note : notes_) {
    if (note.block == block && note.fault.message == fault.message) return;
  }
  if (notes_.size() < kMostNotes) notes_.push_back({block, std::move(fault)});
}

std::vector<Note> Robot::take_notes() { return std::exchange(notes_, {}); }

void Robot::forget() {
  memory_.forget();
  history_.clear();
  perception_.forget();
}

}  // namespace mirada::robot
