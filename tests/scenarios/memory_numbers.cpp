// How well the memory remembers, by the truth of simulated rooms that nothing was tuned in: one sweep, 2 m of
// driving and a quarter turn; then every direction out of view is compared. Prints one JSON object.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>

#include "rig/detectors.h"
#include "rig/lab/lab_room.h"
#include "rig/lab/lab_truth.h"
#include "robot/robot.h"
#include "world/simulation.h"

namespace {

using namespace mirada;

constexpr Micros kStep = 10 * kMillisecond;
constexpr double kWay_m = 2;
constexpr double kLeg_m = 0.5;
constexpr double kRoom_m = 0.25;
constexpr double kView_rad = rad(36);
constexpr double k95 = 1.96;

/// A robot in a room without a program.
class Body {
 public:
  Body(const rig::LabRoom& room, const RobotConfig& robot, std::uint64_t seed)
      : truth_(room.world),
        simulation_(room.world, robot, seed),
        robot_(robot, {&simulation_.camera(), &simulation_.drive(), &simulation_.neck()},
               rig::make_detectors(robot), robot::Timing::simulated, clock_, clock_) {
    robot::Needs needs;
    needs.frames = needs.sonar = needs.memory = true;
    robot_.perception().need(needs);
    robot_.motion().begin_run(robot_.safety().arm(robot_.safety().stop_and_permit(), false));
  }

  template <class Going>
  void run_while(double at_most_s, Going&& going) {
    const Micros end = clock_.now() + micros(at_most_s);
    while (clock_.now() < end && going()) {
      for (int i = 0; i < 2; ++i) {
        simulation_.step(kStep);
        clock_.set(simulation_.now());
        robot_.observe();
      }
      robot_.safety().heartbeat();
      robot_.act();
    }
  }
  void follow(robot::MotionTicket ticket) {
    run_while(20, [&] { return robot_.motion().state(ticket) == robot::MotionState::going; });
  }
  double ahead_m(double bearing_rad) const {
    return truth_.distance_m(simulation_.truth().X_WR, bearing_rad);
  }

  rig::LabTruth truth_;
  ManualClock clock_;
  world::Simulation simulation_;
  robot::Robot robot_;
};

struct Numbers {
  std::vector<double> errors_m;
  std::size_t inside = 0;
  std::vector<double> sweeps_s;
  std::size_t false_clear = 0;
  std::size_t clear = 0;
};

void measure(Body& body, Numbers& out) {
  robot::Robot& robot = body.robot_;
  body.run_while(1, [] { return true; });
  const Micros start = body.clock_.now();
  robot.watch().look_around();
  body.run_while(3, [&] { return robot.watch().looking_around(); });
  out.sweeps_s.push_back(seconds(body.clock_.now() - start));
  body.follow(robot.motion().turn(rad(45), {1, ""}));
  for (double way = 0; way < kWay_m;) {
    const double leg = std::clamp(body.ahead_m(0) - kRoom_m, 0.0, kLeg_m);
    if (leg < 0.05) break;
    body.follow(robot.motion().drive(leg, {1, ""}));
    body.follow(robot.motion().drive(-leg, {1, ""}));
    way += 2 * leg;
  }
  body.follow(robot.motion().turn(rad(45), {1, ""}));
  for (int i = 0; i < memory::Surroundings::kDirections; ++i) {
    const double bearing = memory::Surroundings::bearing_rad(i);
    if (std::abs(bearing) < kView_rad) continue;
    const memory::Direction& known = robot.memory().around().at(bearing);
    const double real_m = body.ahead_m(bearing);
    if (known.answer == Answer::clear) {
      ++out.clear;
      out.false_clear += known.distance_m > real_m + 0.1 ? 1 : 0;
    }
    if (known.answer != Answer::blocked) continue;
    const double error_m = std::abs(known.distance_m - real_m);
    out.errors_m.push_back(error_m);
    out.inside += error_m <= k95 * known.sigma_m ? 1 : 0;
  }
}

double part(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

nlohmann::json to_json(const Numbers& numbers) {
  const auto count = static_cast<double>(std::max<std::size_t>(numbers.errors_m.size(), 1));
  return {{"directions", numbers.errors_m.size()},
          {"error_median_m", part(numbers.errors_m, 0.5)},
          {"error_p90_m", part(numbers.errors_m, 0.9)},
          {"inside_95", static_cast<double>(numbers.inside) / count},
          {"clear_directions", numbers.clear},
          {"clear_but_blocked", numbers.false_clear},
          {"sweep_longest_s", part(numbers.sweeps_s, 1)}};
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"How well the memory remembers, measured by the truth of simulated rooms."};
  std::uint64_t seeds = 4;
  std::uint64_t first = 1;
  app.add_option("--seeds", seeds, "Seeds a floor")->capture_default_str();
  app.add_option("--first-seed", first)->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  cv::setNumThreads(1);
  const auto robot = robot_by_name("mirada-sim");
  if (!robot) return 2;
  nlohmann::json out = {{"rooms", nlohmann::json::array()}};
  Numbers all;
  const std::vector<world::FloorKind> floors{world::FloorKind::carpet, world::FloorKind::wood,
                                             world::FloorKind::tiles, world::FloorKind::concrete,
                                             world::FloorKind::grass};
  for (const world::FloorKind floor : floors) {
    Numbers here;
    for (std::uint64_t seed = first; seed < first + seeds; ++seed) {
      Body body(rig::lab_room(floor, rig::LabLight::even, seed), *robot, seed);
      measure(body, here);
    }
    out["rooms"].push_back(to_json(here));
    all.errors_m.insert(all.errors_m.end(), here.errors_m.begin(), here.errors_m.end());
    all.sweeps_s.insert(all.sweeps_s.end(), here.sweeps_s.begin(), here.sweeps_s.end());
    all.inside += here.inside;
    all.clear += here.clear;
    all.false_clear += here.false_clear;
  }
  out["all"] = to_json(all);
  std::cout << out.dump(1) << "\n";
  return 0;
}
