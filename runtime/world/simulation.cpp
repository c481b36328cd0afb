#include "world/simulation.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/clock.h"
#include "world/contacts.h"
#include "world/devices.h"
#include "world/line_watch.h"
#include "world/placement.h"
#include "world/render/renderer.h"
#include "world/scene_json.h"
#include "world/sim_camera.h"
#include "world/walkers.h"
#include "world/wheels.h"

namespace mirada::world {
namespace {

constexpr Micros kLongestStep = 10 * kMillisecond;

std::vector<Shape> standing_shapes(const WorldConfig& world) {
  std::vector<Shape> out;
  for (const WallConfig& wall : world.walls) {
    for (Shape& shape : shapes_of(wall)) out.push_back(std::move(shape));
  }
  for (const BoxConfig& box : world.boxes) out.push_back(shape_of(box));
  for (const CylinderConfig& cylinder : world.cylinders) out.push_back(shape_of(cylinder));
  return out;
}

double reach_m(const RobotConfig& robot) {
  double out = 0;
  for (const Eigen::Vector2d& p : robot.footprint_R_m) out = std::max(out, p.norm());
  return out;
}

Eigen::Isometry3d upright(const Pose2& X_AB) {
  Eigen::Isometry3d out = Eigen::Isometry3d::Identity();
  out.translation() = Eigen::Vector3d(X_AB.x_m, X_AB.y_m, 0);
  out.linear() = Eigen::AngleAxisd(X_AB.heading_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return out;
}

}  // namespace

struct Simulation::Impl {
  Impl(const WorldConfig& as_written, const RobotConfig& robot_config, std::uint64_t seed)
      : robot(robot_config),
        world(placed(as_written, seed, reach_m(robot_config) + 0.05)),
        contacts(robot.footprint_R_m, standing_shapes(world)),
        lines(robot.footprint_R_m, world.lines),
        wheels(robot.drive, world.noise, seed),
        walkers(world.people),
        renderer(world, robot.camera, seed),
        scene(world, robot),
        camera(robot.latency.frame_us, clock),
        drive(robot.drive.max_wheel_mps),
        neck(robot.neck),
        frame_period(micros(1 / robot.camera_fps)) {
    truth.X_WR = world.X_WR_start;
    next_exposure = frame_period;
  }

  /// Everything moves for dt at once; no exposure falls inside.
  void advance(Micros dt) {
    clock.advance(dt);
    const Micros now = clock.now();
    walkers.step(dt, truth.X_WR, contacts.reach_m());
    const Pose2 wanted = compose(truth.X_WR, wheels.step(drive.command(), dt));
    const Pose2 reached = contacts.move(truth.X_WR, wanted, walkers.shapes(), now);
    truth.path_m += std::hypot(reached.x_m - truth.X_WR.x_m, reached.y_m - truth.X_WR.y_m);
    truth.X_WR = reached;
    lines.look(reached, now);
    neck.step(dt, now);
    publish();
  }

  void publish() {
    drive.publish({clock.now(), wheels.X_OR(), wheels.speed()});
    truth.people = walkers.poses();
    truth.neck = neck.state().angles;
    truth.contacts = contacts.count();
    truth.touching = contacts.touching();
    truth.line_crossings = lines.crossings();
  }

  void expose() {
    if (!camera.enabled()) return;
    const Eigen::Isometry3d X_WC = upright(truth.X_WR) * robot.X_RC(truth.neck);
    const HeldBoard* shown = held ? &*held : nullptr;
    camera.expose(renderer.render(X_WC, walkers.poses(), clock.now(), shown), clock.now());
  }

  RobotConfig robot;
  WorldConfig world;  ///< as this seed has it
  ManualClock clock;
  Contacts contacts;
  LineWatch lines;
  Wheels wheels;
  Walkers walkers;
  Renderer renderer;
  SceneWriter scene;
  SimCamera camera;
  SimDrive drive;
  SimNeck neck;
  Truth truth;
  std::optional<HeldBoard> held;
  Micros frame_period;
  Micros next_exposure = 0;
};

Simulation::Simulation(const WorldConfig& world, const RobotConfig& robot, std::uint64_t seed)
    : impl_(std::make_unique<Impl>(world, robot, seed)) {}
Simulation::~Simulation() = default;

void Simulation::step(Micros dt) {
  assert(dt >= 0);
  Impl& s = *impl_;
  const Micros end = s.clock.now() + dt;
  while (s.clock.now() < end) {
    const Micros now = s.clock.now();
    s.advance(std::min({kLongestStep, end - now, s.next_exposure - now}));
    if (s.clock.now() == s.next_exposure) {
      s.expose();
      s.next_exposure += s.frame_period;
    }
  }
}

Micros Simulation::now() const { return impl_->clock.now(); }

void Simulation::put_back() {
  Impl& s = *impl_;
  s.drive.stop();
  s.wheels.reset();
  s.neck.reset(s.clock.now());
  s.walkers.reset();
  s.contacts.reset();
  s.lines.reset();
  s.camera.drop();
  s.truth = Truth{};
  s.truth.X_WR = s.world.X_WR_start;
  s.publish();
}

void Simulation::carry_to(const Pose2& X_WR) {
  impl_->truth.X_WR = X_WR;
  impl_->publish();
}

void Simulation::hold_board(std::optional<HeldBoard> board) { impl_->held = std::move(board); }

hal::Camera& Simulation::camera() { return impl_->camera; }
hal::Drive& Simulation::drive() { return impl_->drive; }
hal::Neck& Simulation::neck() { return impl_->neck; }
Truth Simulation::truth() const { return impl_->truth; }
std::string Simulation::scene_json() const {
  return impl_->scene.write(impl_->truth, impl_->walkers.poses());
}

}  // namespace mirada::world
