#include "rig/live_robot.h"

#include <algorithm>

#include "rig/beat.h"
#include "rig/camera_choice.h"
#include "rig/detectors.h"

namespace mirada::rig {
namespace {

constexpr Micros kMostBehind = 60 * kMillisecond;

/// Live, a tick is bounded by wall time, not by block executions.
session::SessionOptions session_options(const LiveParts& parts, const Clock& wall) {
  session::SessionOptions out;
  out.seed = parts.setup.seed;
  out.runs_before = parts.runs_before;
  out.limits = vm::live_limits(wall);
  return out;
}

}  // namespace

Result<std::unique_ptr<LiveRobot>> LiveRobot::build(const LiveParts& parts) {
  auto clock = std::make_unique<ManualClock>();
  std::unique_ptr<hal::Camera> camera;
  if (!parts.camera.empty()) {
    auto opened = open_camera(parts.camera, parts.robot, *clock);
    if (!opened) return opened.faults();
    camera = std::move(*opened);
  }
  return std::unique_ptr<LiveRobot>(new LiveRobot(parts, std::move(camera), std::move(clock)));
}

LiveRobot::LiveRobot(const LiveParts& parts, std::unique_ptr<hal::Camera> camera,
                     std::unique_ptr<ManualClock> clock)
    : setup_(parts.setup),
      words_(parts.notes),
      mount_watch_(parts.robot, !parts.camera.empty()),
      tell_(parts.tell),
      clock_(std::move(clock)),
      simulation_(parts.world, parts.body, parts.setup.seed),
      camera_(std::move(camera)),
      robot_(parts.robot,
             {camera_ ? camera_.get() : &simulation_.camera(), &simulation_.drive(), &simulation_.neck()},
             make_detectors(parts.robot, parts.face_model, parts.book), robot::Timing::live, *clock_, wall_),
      link_(std::make_shared<blocks::Link>()),
      packs_(shipped_packs(link_)),
      session_(robot_, packs_.catalog, session_options(parts, wall_)) {
  link_->robot = &robot_;
  link_->host = &session_.host();
  robot_.observe();
  update_wanted();
  wall_behind_ = wall_.now() - simulation_.now();
}

LiveRobot::~LiveRobot() { robot_.safety().stop(); }

void LiveRobot::step(PictureEncoder& encoder) {
  const Micros target = wall_.now() - wall_behind_;
  // After a hiccup the room's time is allowed to be late: a burst of steps would only make the next one.
  if (target - simulation_.now() > kMostBehind) wall_behind_ += target - simulation_.now() - kMostBehind;
  // Only up to what it was when the step began: a machine too slow for the room must still publish.
  const Micros until = std::min(target, simulation_.now() + kMostBehind);
  while (simulation_.now() + kWorldStep <= until) {
    simulation_.step(kWorldStep);
    clock_->set(simulation_.now());
    robot_.observe();
    if (simulation_.now() < next_tick_) continue;
    next_tick_ = simulation_.now() + kTick;
    session_.tick();
  }
  wake_scripts();
  show_picture(encoder);
  if (board_.due(clock_->now(), session_.run(), session_.state())) publish();
}

/// A script that has waited long enough does not wait for the next beat.
void LiveRobot::wake_scripts() {
  const Micros last_step = simulation_.now();
  const Micros now = std::clamp(wall_.now() - wall_behind_, last_step, last_step + kWorldStep - 1);
  if (session_.next_timer() > now) return;
  clock_->set(now);
  session_.tick();
}

void LiveRobot::show_picture(PictureEncoder& encoder) {
  const Frame& frame = robot_.perception().frame();
  if (frame.number == shown_frame_) return;
  shown_frame_ = frame.number;
  if (wanted_.camera) encoder.offer(frame);
  check_mount(frame);
  if (tap_) tap_(frame, robot_.gaze().state(robot_.now()).angles);
}

void LiveRobot::check_mount(const Frame& frame) {
  if (!mount_watch_.wants_pictures()) return;
  const hal::NeckState neck = robot_.gaze().state(robot_.now());
  if (session_.state() != session::RunState::idle) {
    mount_watch_.end();  // the robot is in use: what it sees now is no start
  } else if (neck.settled) {
    mount_watch_.look(frame, neck.angles);
  }
  if (mount_watch_.wants_pictures()) return;
  update_wanted();
  for (const Fault& word : mount_watch_.words()) {
    if (tell_) tell_(word);
  }
  const std::lock_guard lock(words_mutex_);
  words_.insert(words_.end(), mount_watch_.words().begin(), mount_watch_.words().end());
}

Faults LiveRobot::camera_words() const {
  const std::lock_guard lock(words_mutex_);
  return words_;
}

Micros LiveRobot::idle_for() const {
  const Micros next = std::min(simulation_.now() + kWorldStep, session_.next_timer());
  return std::max<Micros>(0, next - (wall_.now() - wall_behind_));
}

void LiveRobot::publish() {
  session::Telemetry telemetry = session_.snapshot();
  if (wanted_.room) telemetry.scene_json = simulation_.scene_json();
  board_.publish(std::move(telemetry));
}

void LiveRobot::put_back() {
  session_.stop(session::StopReason::put_back);
  simulation_.put_back();
  robot_.forget();
  robot_.gaze().look_ahead();
}

void LiveRobot::want(const session::Wanted& wanted) {
  wanted_ = wanted;
  update_wanted();
}

void LiveRobot::tap(FrameTap tap) {
  tap_ = std::move(tap);
  update_wanted();
}

void LiveRobot::update_wanted() {
  session::Wanted all = wanted_;
  all.camera = all.camera || tap_ || mount_watch_.wants_pictures();
  session_.want(all);
}

}  // namespace mirada::rig
