#include "session/session.h"

#include <limits>

#include "session/messages.h"
#include "session/needs.h"

namespace mirada::session {
namespace {

constexpr std::size_t kKeptFaults = 100;
constexpr Micros kSonarPatience = 3 * kSecond;  // a USB camera takes a second to open
constexpr Micros kFacesPatience = 1 * kSecond;

}  // namespace

Session::Session(robot::Robot& robot, const vm::BlockCatalog& catalog, SessionOptions options)
    : robot_(&robot),
      catalog_(&catalog),
      options_(options),
      host_(robot.motion(), options.seed),
      evaluations_(robot, catalog, options.seed, options.limits),
      run_(options.runs_before),
      last_tick_(robot.now()) {}

Session::~Session() {
  robot_->safety().stop();
  swap_machine(nullptr);
}

void Session::swap_machine(std::unique_ptr<vm::Machine> next) {
  const std::lock_guard lock(machine_mutex_);
  machine_.swap(next);
}

void Session::interrupt() {
  const std::lock_guard lock(machine_mutex_);
  if (machine_) machine_->interrupt();
}

void Session::start(const vm::LoadedProgram& program, const std::string& program_json,
                    robot::Safety::Permit permit) {
  stop(StopReason::replaced);
  ++run_;
  stop_reason_ = StopReason::none;
  faults_.clear();
  faulted_ = paused_ = false;
  for (const Fault& warning : program.warnings) add_fault({warning.place, warning});
  host_.begin_run();
  program_json_ = program_json;
  program_needs_ = needs_of(program.needs);
  swap_machine(std::make_unique<vm::Machine>(program.code, *catalog_, host_, options_.limits));
  machine_->flag();
  phase_ = Phase::warming;
  permit_ = permit;
  first_tick_ = true;
  warm_since_ = robot_->now();
  // Each run begins alike, whatever the last one left the camera looking at.
  robot_->gaze().look_ahead();
  update_needs();
}

void Session::stop(StopReason why) {
  robot_->safety().end(robot_->motion().run());
  if (phase_ == Phase::idle) return;
  phase_ = Phase::idle;
  paused_ = false;
  stop_reason_ = why;
  machine_->stop();
  collect();
  robot_->motion().begin_run(0);
  robot_->watch().rest();
  robot_->gaze().hold();
  host_.clear_bubble();
  program_needs_ = {};
  update_needs();
}

void Session::pause(bool on) {
  if (phase_ == Phase::idle || on == paused_) return;
  paused_ = on;
  robot_->motion().pause(on);
  robot_->act();
  robot_->gaze().pause(on);
}

void Session::key(const std::string& name, bool down) {
  if (phase_ != Phase::idle && !paused_) machine_->key(name, down);
}

void Session::evaluate(const vm::LoadedProgram& program, const std::string& program_json,
                       const std::string& block, AnswerFn answer) {
  const bool same = phase_ == Phase::running && !paused_ && program_json == program_json_;
  if (same) {
    evaluations_.ask(*machine_, block, std::move(answer));
  } else {
    const robot::Needs needs = needs_of(needs_of_block(program_json, block, program, *catalog_));
    evaluations_.ask(program, block, needs, std::move(answer));
  }
  update_needs();
}

void Session::want(const Wanted& wanted) {
  wanted_ = wanted;
  update_needs();
}

void Session::update_needs() {
  const robot::Needs panels{wanted_.camera, wanted_.sonar, wanted_.faces, wanted_.memory};
  robot_->need(panels | program_needs_ | evaluations_.needs() | own_needs_);
}

void Session::begin_when_warm() {
  const Micros waited = robot_->now() - warm_since_;
  const bool patient = waited < kSonarPatience;
  robot::Needs needs = program_needs_;
  if (waited >= kFacesPatience) needs.faces = false;
  if (!seen_enough(*robot_, needs)) {
    if (!patient) {
      stop(StopReason::camera_lost);
      add_fault({"", make_fault("", messages::no_picture)});
    }
    return;
  }
  const bool uses_camera = program_needs_.any() && robot_->perception().has_camera();
  phase_ = Phase::running;
  robot_->mark_start();
  robot_->motion().begin_run(robot_->safety().arm(permit_, uses_camera));
}

bool Session::still_allowed() {
  if (robot_->safety().armed()) return true;
  const robot::Safety::Trip trip = robot_->safety().tripped();
  if (trip == robot::Safety::Trip::blind) {
    stop(StopReason::camera_lost);
    add_fault({"", make_fault("", messages::no_picture)});
  } else if (trip == robot::Safety::Trip::stuck) {
    stop(StopReason::stuck);
    add_fault({"", make_fault("", messages::robot_stuck)});
  } else {
    stop(expected_stop_.load());
  }
  return false;
}

void Session::tick() {
  const Micros dt = robot_->now() - last_tick_;
  last_tick_ = robot_->now();
  robot_->safety().check();
  robot_->safety().heartbeat();
  if (evaluations_.any()) {
    evaluations_.tick();
    update_needs();
  }
  if (phase_ == Phase::warming && !paused_) begin_when_warm();
  if (phase_ == Phase::running && still_allowed() && !paused_) {
    if (!first_tick_) host_.advance(dt);
    first_tick_ = false;
    run_scripts();
  }
  if (const robot::Needs own = robot_->own_needs(); !(own == own_needs_)) {
    own_needs_ = own;
    update_needs();
  }
  robot_->act();
}

Micros Session::next_timer() const {
  constexpr Micros kNever = std::numeric_limits<Micros>::max();
  if (phase_ != Phase::running || paused_) return kNever;
  const Micros wake = machine_->next_timer();
  return wake == kNever ? kNever : last_tick_ + (wake - host_.now());
}

void Session::run_scripts() {
  machine_->tick(options_.back_to_back);
  // Stopped from another thread meanwhile: what the scripts complain about then is no fault of theirs.
  if (!robot_->safety().armed()) {
    machine_->take_faults();
    robot_->take_notes();
    still_allowed();
    return;
  }
  collect();
  evaluations_.answered(machine_->take_answers());
  end_if_over();
}

void Session::collect() {
  for (vm::BlockFault& fault : machine_->take_faults()) add_fault(std::move(fault));
  for (robot::Note& note : robot_->take_notes()) {
    note.fault.severity = Severity::warning;
    add_fault({note.block, std::move(note.fault)});
  }
}

void Session::add_fault(vm::BlockFault fault) {
  const bool error = fault.fault.severity == Severity::error;
  for (const vm::BlockFault& old : faults_) {
    if (!error && old.block == fault.block && old.fault.message == fault.fault.message) return;
  }
  faulted_ = faulted_ || error;
  faults_.push_back(std::move(fault));
  if (faults_.size() > kKeptFaults) faults_.pop_front();
}

/// With no script alive: whether anything can start one.
bool Session::can_go_on() const {
  if (options_.attended) return machine_->waits_for_outside();
  return machine_->may_fire_by_itself() || (!options_.back_to_back && machine_->waits_for_percept());
}

void Session::end_if_over() {
  if (machine_->any_script_alive()) return;
  if (const auto owner = robot_->motion().end_set_speeds()) {
    add_fault(
        {owner->block, make_fault(owner->block, messages::program_ended_moving, {}, Severity::warning)});
  }
  if (can_go_on()) return;
  stop(faulted_ ? StopReason::faulted : StopReason::program_ended);
}

/// What was seen, as far as it still says something about now: an old number is no number.
std::shared_ptr<const Percepts> Session::fresh_percepts() const {
  const std::shared_ptr<const Percepts>& seen = robot_->perception().percepts();
  const Micros oldest = robot_->now() - robot::kPerceptLife;
  const bool sonar_old = seen->sonar.frame != 0 && seen->sonar.t_exposure < oldest;
  const bool faces_old = seen->faces.frame != 0 && seen->faces.t_exposure < oldest;
  if (!sonar_old && !faces_old) return seen;
  auto fresh = std::make_shared<Percepts>(*seen);
  if (sonar_old) fresh->sonar = {};
  if (faces_old) fresh->faces = {};
  return fresh;
}

RunState Session::state() const {
  if (phase_ == Phase::idle) return RunState::idle;
  return paused_ ? RunState::paused : RunState::running;
}

Telemetry Session::snapshot() const {
  Telemetry out;
  out.t = robot_->now();
  out.run = run_;
  out.state = state();
  out.stop_reason = stop_reason_;
  if (machine_) {
    if (phase_ != Phase::idle) out.running_blocks = machine_->running_blocks();
    out.variables = machine_->variables();
    out.lists = machine_->lists();
    out.list_lengths = machine_->list_lengths();
    out.block_executions = machine_->block_executions();
  }
  out.say = host_.bubble();
  out.say_log.assign(host_.said().begin(), host_.said().end());
  out.faults.assign(faults_.begin(), faults_.end());
  out.percepts = fresh_percepts();
  out.X_OR = robot_->odometry().X_OR;
  out.neck = robot_->gaze().state(robot_->now()).angles;
  out.follow_state = robot::to_string(robot_->follower().state());
  out.follow_id = robot_->follower().id();
  if (wanted_.memory) {
    auto memory = std::make_shared<memory::Snapshot>(memory::snapshot_of(robot_->memory()));
    memory->next = robot_->watch().next();
    memory->neck = out.neck;
    memory->hfov_rad = robot_->config().camera.hfov_rad();
    out.memory = std::move(memory);
  }
  const WheelSpeeds wheels = robot_->safety().commanded();
  out.left_mps = wheels.left_mps;
  out.right_mps = wheels.right_mps;
  const Status health = robot_->perception().health();
  if (!health) out.camera_trouble_code = std::string(health.faults().front().code());
  return out;
}

}  // namespace mirada::session
