#include "robot/robot.h"

#include <algorithm>
#include <cmath>

#include "robot/line_match.h"

namespace mirada::robot {
namespace {
constexpr std::size_t kMostNotes = 100;
}  // namespace

Robot::Robot(RobotConfig config, const Devices& devices, Detectors detectors, Timing timing,
             const Clock& clock, const Clock& guard)
    : config_(std::move(config)),
      devices_(devices),
      clock_(&clock),
      safety_(devices.drive, config_.drive, guard),
      motion_(config_.drive, safety_),
      gaze_(devices.neck, config_.neck),
      perception_(devices.camera, std::move(detectors), config_.latency, timing),
      memory_(config_),
      watch_(gaze_, config_),
      pilot_(motion_, watch_, config_),
      follower_(motion_, gaze_, watch_, config_),
      localizer_(config_.drive) {
  localizer_.know(config_.place);
}

void Robot::observe() {
  if (devices_.drive != nullptr) odometry_ = devices_.drive->odometry();
  history_.record(now(), {odometry_.X_OR, gaze_.state(now()).angles});
  if (perception_.step(now(), history_)) safety_.frame_seen(now() - perception_.frame().t_exposure);
  if (const FacesPercept* seen = faces(); seen != nullptr && !seen->faces.empty()) met_face_ = true;
  memory_.moved(now(), odometry_.X_OR);
  locate();
  if (!perception_.needs().memory) return;
  remember();
  remember_things();
}

void Robot::remember() {
  const SonarPercept& sonar = perception_.percepts()->sonar;
  if (sonar.frame == remembered_frame_) return;
  remembered_frame_ = sonar.frame;
  // Neither what could not be judged nor what was seen before anybody asked for the memory is a look.
  const bool fresh = sonar.frame != 0 && now() - sonar.t_exposure <= kPerceptLife;
  if (fresh && sonar.floor_model_trusted && history_.steady(sonar.t_exposure)) memory_.observe(sonar);
}

void Robot::remember_things() {
  const Percepts& seen = *perception_.percepts();
  if (seen.things.frame != remembered_things_) {
    remembered_things_ = seen.things.frame;
    for (const ThingSeen& thing : seen.things.things) {
      if (now() - seen.things.t_exposure > kPerceptLife) break;
      memory_.observe(thing, seen.things.X_OR, seen.things.t_exposure);
    }
  }
  if (seen.faces.frame == remembered_faces_) return;
  remembered_faces_ = seen.faces.frame;
  const auto shown = std::find_if(seen.faces.faces.begin(), seen.faces.faces.end(),
                                  [](const FacePercept& face) { return !face.predicted; });
  if (shown == seen.faces.faces.end() || now() - seen.faces.t_exposure > kPerceptLife) return;
  const FacePercept& face = *shown;
  ThingSeen thing;
  thing.bearing_rad = face.bearing_rad;
  thing.distance_m = face.distance_m;
  thing.sigma_m = face.sigma_m;
  memory_.observe(thing, history_.at(seen.faces.t_exposure).X_OR, seen.faces.t_exposure);
}

void Robot::locate() {
  localizer_.moved(odometry_.X_OR);
  const ThingsPercept& things = perception_.percepts()->things;
  if (things.frame != located_things_) {
    located_things_ = things.frame;
    localizer_.see(things);
  }
  const Percepts& seen = *perception_.percepts();
  if (seen.lines.frame == located_lines_ || seen.lines.frame != seen.sonar.frame) return;
  located_lines_ = seen.lines.frame;
  if (!history_.steady(seen.lines.t_exposure)) return;
  LinesPercept lines = seen.lines;
  std::erase_if(lines.lines, [&](const LineSeen& line) { return !on_seen_floor(line, seen.sonar); });
  localizer_.see(lines);
}

Recall Robot::obstacle_at(double bearing_rad) const {
  return recall(sonar(), perception_.percepts()->sonar.t_exposure, memory_, bearing_rad);
}

Safety::Verdict Robot::act() {
  if (!motion_.paused()) attend();
  pilot_.step(now(), memory_);
  follower_.step({now(), odometry_.X_OR, faces()}, memory_);
  return motion_.step(now(), odometry_);
}

void Robot::attend() {
  Watch::Sight sight;
  sight.now = now();
  sight.speed_mps = (odometry_.speed.left_mps + odometry_.speed.right_mps) / 2;
  sight.turn_radps = (odometry_.speed.right_mps - odometry_.speed.left_mps) / config_.drive.track_m;
  if (const FacesPercept* seen = faces(); seen != nullptr && !seen->faces.empty())
    sight.face_rad = seen->faces.front().bearing_rad;
  watch_.step(memory_, sight);
}

double Robot::drift_since_start_m() const {
  // Sums that cancel may leave a little less than nothing.
  const double square = memory_.drift().covariance(start_mark_, {X_OS_.x_m, X_OS_.y_m}).trace();
  return std::sqrt(std::max(0.0, square));
}

void Robot::need(Needs needs) {
  if (needs.place && config_.place) {
    needs.frames = true;
    needs.things = needs.things || !config_.place->tags.empty();
    needs.sonar = needs.sonar || config_.place->has_lines();
  }
  perception_.need(needs);
}

Needs Robot::own_needs() const {
  Needs needs;
  needs.faces = watch_.keeping() == memory::Watching::face || follower_.active();
  needs.memory = needs.sonar = follower_.drives();
  return needs;
}

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
  watch_.rest();
  follower_.stop();
  met_face_ = false;
  history_.clear();
  perception_.forget();
  if (devices_.drive != nullptr) odometry_ = devices_.drive->odometry();
  localizer_.put_down(odometry_.X_OR);
}

}  // namespace mirada::robot
