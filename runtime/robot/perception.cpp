#include "robot/perception.h"

#include "robot/messages.h"

namespace mirada::robot {
namespace {
constexpr std::uint64_t kThingsEvery = 3;  // pictures; tags and balls do not run away
}

Perception::Perception(hal::Camera* camera, Detectors detectors, const LatencyConfig& latency, Timing timing)
    : camera_(camera), detectors_(std::move(detectors)), latency_(latency), timing_(timing) {}

void Perception::need(const Needs& needs) {
  if (needs == needs_) return;
  if (camera_ != nullptr && needs.any() != needs_.any()) camera_->enable(needs.any());
  needs_ = needs;
  if (needs.faces && timing_ == Timing::live && !face_worker_ && detectors_.faces) {
    face_worker_ = std::make_unique<FaceWorker>(detectors_.faces);
  }
}

Status Perception::health() const { return camera_ != nullptr ? camera_->health() : Status(Ok{}); }

bool Perception::step(Micros now, const MotionHistory& history) {
  std::optional<Frame> fresh;
  if (camera_ != nullptr && needs_.any()) fresh = camera_->poll();
  if (fresh) {
    frame_ = std::move(*fresh);
    ++pictures_;
    look(frame_, now, history);
  }
  if (face_worker_) {
    auto found = face_worker_->take();
    // What was in work when the robot was put elsewhere tells of the place before.
    const bool stale = found && *found && (*found)->t_exposure <= forgotten_at_;
    if (found && !stale) accept(std::move(*found), now);
  }
  publish(now);
  return fresh.has_value();
}

void Perception::look(const Frame& frame, Micros now, const MotionHistory& history) {
  const MotionHistory::State then = history.at(frame.t_exposure);
  if ((needs_.sonar || needs_.memory) && detectors_.sonar) {
    const Micros due = timing_ == Timing::live ? now : now + latency_.sonar_us;
    sonar_due_.push_back({due, detectors_.sonar(frame, then.neck, then.X_OR)});
  }
  if (needs_.things && detectors_.things && pictures_ % kThingsEvery == 0) {
    const Micros due = timing_ == Timing::live ? now : now + latency_.sonar_us;
    things_due_.push_back({due, detectors_.things(frame, then.neck, then.X_OR)});
  }
  if (needs_.place && detectors_.lines) {
    const Micros due = timing_ == Timing::live ? now : now + latency_.sonar_us;
    lines_due_.push_back({due, detectors_.lines(frame, then.neck, then.X_OR)});
  }
  if (needs_.faces && detectors_.faces) look_for_faces(frame, now, then);
}

void Perception::look_for_faces(const Frame& frame, Micros now, const MotionHistory::State& then) {
  if (face_worker_) {
    face_worker_->offer(frame, then.neck, then.X_OR);
    return;
  }
  // One picture at a time, as the thread that does it live.
  if (!faces_due_.empty()) return;
  Result<FacesPercept> found = detectors_.faces(frame, then.neck, then.X_OR);
  const Micros closely = found ? found->described * latency_.identity_us : 0;
  accept(std::move(found), now + latency_.faces_us + closely);
}

void Perception::accept(Result<FacesPercept> found, Micros due) {
  if (found) {
    faces_due_.push_back({due, std::move(*found)});
    return;
  }
  const Fault& why = found.faults().front();
  faces_trouble_ = make_fault("", messages::faces_unavailable, {{"reason", why.text(Lang::en)}});
}

void Perception::publish(Micros now) {
  std::shared_ptr<Percepts> next;
  const auto draft = [&]() -> Percepts& {
    if (!next) next = std::make_shared<Percepts>(*percepts_);
    return *next;
  };
  for (; !sonar_due_.empty() && sonar_due_.front().at <= now; sonar_due_.pop_front()) {
    draft().sonar = std::move(sonar_due_.front().percept);
  }
  for (; !faces_due_.empty() && faces_due_.front().at <= now; faces_due_.pop_front()) {
    draft().faces = std::move(faces_due_.front().percept);
  }
  for (; !things_due_.empty() && things_due_.front().at <= now; things_due_.pop_front()) {
    draft().things = std::move(things_due_.front().percept);
  }
  for (; !lines_due_.empty() && lines_due_.front().at <= now; lines_due_.pop_front()) {
    draft().lines = std::move(lines_due_.front().percept);
  }
  if (next) percepts_ = std::move(next);
}

void Perception::forget() {
  forgotten_at_ = frame_.t_exposure;
  if (detectors_.forget_floor) detectors_.forget_floor();
  if (detectors_.forget_faces) detectors_.forget_faces();
  sonar_due_.clear();
  faces_due_.clear();
  things_due_.clear();
  lines_due_.clear();
  percepts_ = std::make_shared<const Percepts>();
}

}  // namespace mirada::robot
