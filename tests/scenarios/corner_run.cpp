#include "corner_run.h"

#include <cmath>

#include "base/random.h"
#include "rig/lockstep.h"
#include "runtime/rig/program_text.h"

namespace mirada::scenarios {
namespace {

using Eigen::Vector2d;

constexpr double kInCorner_m = 0.8;  // it stops when a line is 33 to 38 cm off on its way
constexpr double kOutside_m = 0.95;
constexpr double kNeckStill_rad = rad(2);
const Vector2d kCorner_m(1.2, 0);

std::string nearer_than(const std::string& angle, const std::string& cm) {
  using namespace rig;
  const std::string distance = block({"vision_obstacle_distance", "d", number_input("ANGLE", angle), ""});
  return block(
      {"operator_lt", "lt", block_input("OPERAND1", distance) + ", " + text_input("OPERAND2", cm), ""});
}

std::string either(const std::string& a, const std::string& b) {
  using namespace rig;
  return block({"operator_or", "or", block_input("OPERAND1", a) + ", " + block_input("OPERAND2", b), ""});
}

/// If the way there (positive to the right) is clear, goes 60 cm and ends.
std::string leave_by(int right_deg, const std::string& next) {
  using namespace rig;
  const std::string side = right_deg >= 0 ? "right" : "left";
  const std::string end = block({"control_stop", "end", "", R"("STOP_OPTION": "all")"});
  const std::string go = turn(side, std::to_string(std::abs(right_deg)), drive("forward", "60", end));
  const std::string clear =
      block({"memory_way_clear", "clear", number_input("ANGLE", std::to_string(right_deg)), ""});
  return block({"control_if", "if", block_input("CONDITION", clear) + ", " + block_input("SUBSTACK", go), ""},
               next);
}

std::string corner_program(bool memory) {
  using namespace rig;
  std::string ask;
  for (const int angle : {-90, 90, -120, 120, -150, 150, 180}) ask = leave_by(angle, ask);
  if (!memory) ask = block({"memory_forget", "forget", "", ""}, ask);
  const std::string stop = block({"motion_stop", "stop", "", ""}, wait("0.3", ask));
  const std::string near =
      either(nearer_than("0", "38"), either(nearer_than("25", "33"), nearer_than("-25", "33")));
  return program(flag(wait(
      "0.5", set_speeds("35", "35",
                        block({"control_wait_until", "until", block_input("CONDITION", near), ""}, stop)))));
}

/// A green field with nothing on it but two lines at a right angle; the robot comes from their open side.
world::WorldConfig corner_room(std::uint64_t seed) {
  Random random(seed, "corner room");
  world::WorldConfig room = *world::world_by_name("green-field");
  const world::Colour white = room.lines.front().colour;
  room.boxes.clear();
  room.cylinders.clear();
  room.people.clear();
  room.lines = {{{{-0.3, 1.5}, kCorner_m, {-0.3, -1.5}}, 0.05, white}};
  room.X_WR_start = {random.uniform(-0.5, -0.1), random.uniform(-0.12, 0.12),
                     random.uniform(-rad(8), rad(8))};
  return room;
}

}  // namespace

CornerRun run_corner(std::uint64_t seed, bool memory) {
  rig::LockstepOptions options;
  options.world = corner_room(seed);
  options.robot = *robot_by_name("mirada-sim");
  options.robot.lines_are_obstacles = true;
  options.seed = seed;
  options.seconds = 30;
  CornerRun run;
  run.seed = seed;
  run.nearest_m = 1e9;
  options.watch = [&run](Micros, const world::Truth& truth) {
    run.end_m = (Vector2d(truth.X_WR.x_m, truth.X_WR.y_m) - kCorner_m).norm();
    run.nearest_m = std::min(run.nearest_m, run.end_m);
    run.crossings = truth.line_crossings;
    run.looked = run.looked || std::abs(truth.neck.pan_rad) > kNeckStill_rad;
  };
  const session::RunReport report = rig::run_lockstep(corner_program(memory), options);
  run.left = run.nearest_m < kInCorner_m && run.end_m > kOutside_m && run.crossings == 0 && !run.looked;
  run.status = to_string(report.status);
  run.hash = report.hash;
  return run;
}

}  // namespace mirada::scenarios
