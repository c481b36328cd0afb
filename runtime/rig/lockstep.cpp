#include "rig/lockstep.h"

#include <opencv2/core.hpp>

#include "base/clock.h"
#include "rig/beat.h"
#include "rig/detectors.h"
#include "rig/ideal_body.h"
#include "rig/shipped_packs.h"
#include "session/run_hash.h"
#include "session/session.h"

namespace mirada::rig {
namespace {

constexpr std::size_t kMostSaidLines = 10'000;
constexpr std::size_t kMostSaidBytes = 32u << 20;

/// What moves and sees: a simulated room, or an ideal body in none.
class Body {
 public:
  Body(const LockstepOptions& options) : drive_(options.robot.drive), neck_(options.robot.neck) {
    if (options.world) simulation_.emplace(*options.world, options.robot, options.seed);
  }

  robot::Devices devices() {
    if (!simulation_) return {nullptr, &drive_, &neck_};
    return {&simulation_->camera(), &simulation_->drive(), &simulation_->neck()};
  }
  void step(Micros dt) {
    if (simulation_) {
      simulation_->step(dt);
    } else {
      drive_.step(dt);
      neck_.step(dt);
    }
  }
  void carry_to(const Pose2& X_WR) {
    if (simulation_) simulation_->carry_to(X_WR);
  }
  Micros now() const { return simulation_ ? simulation_->now() : drive_.odometry().t; }
  bool has_world() const { return simulation_.has_value(); }
  world::Truth truth() const {
    if (simulation_) return simulation_->truth();
    world::Truth truth;
    truth.X_WR = drive_.odometry().X_OR;
    truth.neck = neck_.state().angles;
    truth.path_m = drive_.path_m();
    return truth;
  }

 private:
  IdealDrive drive_;
  IdealNeck neck_;
  std::optional<world::Simulation> simulation_;
};

class Lockstep {
 public:
  explicit Lockstep(const LockstepOptions& options)
      : options_(options),
        body_(options),
        robot_(options.robot, body_.devices(),
               make_detectors(options.robot, options.face_model,
                              options.book ? options.book : std::make_shared<vision::FaceBook>()),
               robot::Timing::simulated, clock_, clock_),
        link_(std::make_shared<blocks::Link>()),
        packs_(shipped_packs(link_)),
        session_(robot_, packs_.catalog, session_options(options)) {
    link_->robot = &robot_;
    robot_.memory().remember(options.remembers);
    link_->host = &session_.host();
    session_.host().on_say([this](const SaidText& line) {
      keep(line);
      hash_.say(line.t, line.text);
    });
  }

  session::RunReport run(const std::string& program_json) {
    const auto program = vm::load_program(program_json, packs_.catalog);
    if (!program) return session::invalid_report(program.faults());
    const SteadyClock wall;
    robot_.observe();
    session_.start(*program, program_json, robot_.safety().stop_and_permit());
    const Micros end = micros(options_.seconds);
    while (session_.running() && clock_.now() < end && !(options_.stop_asked && options_.stop_asked()))
      tick();
    session::RunReport report = finish();
    report.wall_s = seconds(wall.now());
    return report;
  }

 private:
  using SaidText = session::SaidText;

  static session::SessionOptions session_options(const LockstepOptions& options) {
    session::SessionOptions out;
    out.seed = options.seed;
    out.limits = options.limits;
    out.attended = false;
    out.back_to_back = !options.world.has_value();
    return out;
  }

  /// A script may say thousands of lines a tick, and long ones: the report has the first, the hash has all.
  void keep(const SaidText& line) {
    said_bytes_ += line.text.size();
    if (said_.size() < kMostSaidLines && said_bytes_ <= kMostSaidBytes) said_.push_back(line);
  }

  /// World, due frames, percepts twice; then wake-ups, scripts, commands once.
  void tick() {
    for (Micros done = 0; done < kTick; done += kWorldStep) {
      if (options_.carry) {
        if (const auto X_WR = options_.carry(clock_.now())) body_.carry_to(*X_WR);
      }
      body_.step(kWorldStep);
      clock_.set(body_.now());
      robot_.observe();
      if (options_.watch && body_.has_world()) options_.watch(clock_.now(), body_.truth());
    }
    hash_.percepts(*robot_.perception().percepts());
    session_.tick();
    const world::Truth truth = body_.truth();
    hash_.tick(clock_.now(), truth.X_WR, truth.neck, robot_.safety().commanded());
  }

  session::RunStatus status() const {
    switch (session_.stop_reason()) {
      case session::StopReason::program_ended:
        return session::RunStatus::finished;
      case session::StopReason::faulted:
        return session::RunStatus::faulted;
      default:
        return session::RunStatus::stopped;
    }
  }

  session::RunReport finish() {
    session::RunReport report;
    if (session_.running()) {
      const bool in_time = clock_.now() < micros(options_.seconds);
      session_.stop(session::StopReason::stop_button);
      report.status = in_time ? session::RunStatus::stopped : session::RunStatus::time_up;
    } else {
      report.status = status();
    }
    report.faults.assign(session_.faults().begin(), session_.faults().end());
    report.variables = session_.machine()->variables(vm::kWholeMonitors);
    report.lists = session_.machine()->lists(vm::kWholeMonitors);
    report.block_executions = session_.machine()->block_executions();
    report.say = std::move(said_);
    report.simulated_s = seconds(clock_.now());
    const world::Truth truth = body_.truth();
    report.robot = session::RobotResult{truth.X_WR.x_m, truth.X_WR.y_m, deg(truth.X_WR.heading_rad),
                                        truth.path_m,   truth.contacts, truth.line_crossings};
    report.hash = hash_.finish();
    return report;
  }

  const LockstepOptions& options_;
  ManualClock clock_;
  Body body_;
  robot::Robot robot_;
  std::shared_ptr<blocks::Link> link_;
  packs::PackSet packs_;
  session::RunHash hash_;
  std::vector<SaidText> said_;
  std::size_t said_bytes_ = 0;
  session::Session session_;
};

}  // namespace

session::RunReport run_lockstep(const std::string& program_json, const LockstepOptions& options) {
  cv::setNumThreads(1);
  return Lockstep(options).run(program_json);
}

}  // namespace mirada::rig
