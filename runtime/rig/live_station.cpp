#include "rig/live_station.h"

#include <chrono>
#include <future>
#include <utility>

#include "rig/calibration/kept_camera.h"
#include "rig/messages.h"
#include "rig/setup_reader.h"
#include "vm/machine.h"

namespace mirada::rig {
namespace {

constexpr Micros kWatchdogPeriod = 20 * kMillisecond;
constexpr Micros kLongestSleep = 50 * kMillisecond;

}  // namespace

LiveStation::LiveStation(std::unique_ptr<LiveRobot> robot, std::string camera, std::string face_model,
                         std::shared_ptr<vision::FaceBook> book, Tell tell)
    : camera_(std::move(camera)),
      face_model_(std::move(face_model)),
      book_(std::move(book)),
      tell_(std::move(tell)),
      robot_(std::move(robot)),
      control_([this] { control_loop(); }),
      watchdog_([this] { watchdog_loop(); }) {}

LiveStation::~LiveStation() {
  robot()->safety().stop();
  {
    const std::lock_guard lock(commands_mutex_);
    closing_ = true;
  }
  commands_wake_.notify_one();
  {
    const std::lock_guard lock(watchdog_mutex_);
    watchdog_closing_ = true;
  }
  watchdog_wake_.notify_one();
  control_.join();
  watchdog_.join();
}

std::shared_ptr<LiveRobot> LiveStation::robot() const {
  const std::lock_guard lock(robot_mutex_);
  return robot_;
}

void LiveStation::post(Command command) {
  {
    const std::lock_guard lock(commands_mutex_);
    commands_.push_back(std::move(command));
  }
  commands_wake_.notify_one();
}

void LiveStation::post_and_wait(const Command& command) {
  std::promise<void> done;
  post([&](LiveRobot& robot) {
    command(robot);
    done.set_value();
  });
  done.get_future().wait();
}

Result<session::Started> LiveStation::start(const std::string& program_json) {
  end_calibration();
  const auto robot = this->robot();
  robot->session().expect_stop(session::StopReason::replaced);
  const robot::Safety::Permit permit = robot->safety().stop_and_permit();
  robot->session().interrupt();
  const auto program = vm::load_program(program_json, robot->packs().catalog);
  if (!program) {
    post([robot](LiveRobot&) { robot->session().stop(session::StopReason::replaced); });
    return program.faults();
  }
  session::Started started;
  started.warnings = program->warnings;
  post_and_wait([&](LiveRobot& now) {
    if (&now == robot.get()) now.session().start(*program, program_json, permit);
    started.run = now.session().run();
  });
  return started;
}

void LiveStation::stop(session::StopReason why) {
  const auto robot = this->robot();
  robot->session().expect_stop(why);
  robot->safety().stop();
  robot->session().interrupt();
  post([why](LiveRobot& now) { now.session().stop(why); });
}

void LiveStation::pause(bool on) {
  post([on](LiveRobot& robot) { robot.session().pause(on); });
}

void LiveStation::key(const std::string& name, bool down) {
  post([name, down](LiveRobot& robot) { robot.session().key(name, down); });
}

void LiveStation::evaluate(const std::string& program_json, const std::string& block_id,
                           std::function<void(Result<vm::MonitorValue>)> answer) {
  const auto robot = this->robot();
  auto program = vm::load_program(program_json, robot->packs().catalog);
  if (!program) {
    answer(program.faults());
    return;
  }
  post([robot, program = std::move(*program), program_json, block_id,
        answer = std::move(answer)](LiveRobot& now) {
    if (&now == robot.get()) {
      now.session().evaluate(program, program_json, block_id, answer);
    } else {
      answer(make_fault(block_id, messages::robot_closed));
    }
  });
}

session::Setup LiveStation::setup() const { return robot()->setup(); }
std::vector<session::Option> LiveStation::worlds() const { return world_options(); }
std::vector<session::Option> LiveStation::robots() const { return robot_options(); }

Status LiveStation::choose(const session::Setup& setup) {
  if (const Status offered = only_offered(setup, this->setup()); !offered) return offered;
  end_calibration();
  return rebuild(setup);
}

Status LiveStation::rebuild(const session::Setup& setup) {
  const std::lock_guard one_at_a_time(choose_mutex_);
  auto parts = read_setup(setup, camera_);
  if (!parts) return parts.faults();
  stop(session::StopReason::put_back);
  parts->runs_before = telemetry()->run;
  parts->tell = tell_;
  parts->face_model = face_model_;
  parts->book = book_;
  auto built = LiveRobot::build(*parts);
  if (!built) return built.faults();
  std::shared_ptr<LiveRobot> next = std::move(*built);
  post_and_wait([this, &next](LiveRobot&) {
    next->want(wanted_);
    encoder_.clear();
    const std::lock_guard lock(robot_mutex_);
    robot_.swap(next);
  });
  update_tap();
  return Ok{};
}

Status LiveStation::put_back() {
  stop(session::StopReason::put_back);
  post_and_wait([](LiveRobot& robot) { robot.put_back(); });
  return Ok{};
}

void LiveStation::want(const session::Wanted& wanted) {
  post([this, wanted](LiveRobot& robot) {
    wanted_ = wanted;
    robot.want(wanted);
    if (!wanted.camera) encoder_.clear();
  });
}

std::shared_ptr<const session::Telemetry> LiveStation::telemetry() const { return robot()->board().latest(); }
std::shared_ptr<const session::Picture> LiveStation::picture() const { return encoder_.latest(); }

session::KnownFaces LiveStation::known_faces() const {
  session::KnownFaces out;
  out.revision = book_->revision();
  out.allowed = book_->allowed();
  for (const vision::FaceBook::Person& person : book_->people())
    out.people.push_back({person.name, person.looks});
  return out;
}

Status LiveStation::change_faces(const session::FacesStep& step) {
  using FacesAction = session::FacesStep::Action;
  switch (step.action) {
    case FacesAction::allow:
      return book_->allow(step.on);
    case FacesAction::rename:
      return book_->rename(step.name, step.to);
    case FacesAction::forget:
      return book_->forget(step.name);
    case FacesAction::forget_all:
      return book_->forget_all();
  }
  return Ok{};
}

std::deque<LiveStation::Command> LiveStation::take_commands() {
  const std::lock_guard lock(commands_mutex_);
  return std::exchange(commands_, {});
}

void LiveStation::control_loop() {
  while (true) {
    // Each command may exchange the robot for the next one.
    for (const Command& command : take_commands()) command(*robot());
    const auto robot = this->robot();
    robot->step(encoder_);
    const Micros nap = std::min(robot->idle_for(), kLongestSleep);
    std::unique_lock lock(commands_mutex_);
    commands_wake_.wait_for(lock, std::chrono::microseconds(nap),
                            [this] { return closing_ || !commands_.empty(); });
    if (closing_ && commands_.empty()) return;
  }
}

void LiveStation::watchdog_loop() {
  std::unique_lock lock(watchdog_mutex_);
  while (!watchdog_wake_.wait_for(lock, std::chrono::microseconds(kWatchdogPeriod),
                                  [this] { return watchdog_closing_; })) {
    robot()->safety().check();
  }
}

}  // namespace mirada::rig
