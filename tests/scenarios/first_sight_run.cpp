#include "first_sight_run.h"

#include <cmath>

#include "base/random.h"
#include "rig/lockstep.h"
#include "runtime/rig/program_text.h"

namespace mirada::scenarios {
namespace {

constexpr double kPatience_s = 8;
constexpr double kMostBearing_rad = rad(86);
constexpr double kThing_x_m = 4;  // the other half of the room is empty
constexpr double kThingRadius_m = 0.1;

/// Says so when anything is seen or remembered nearer than two metres, and ends.
std::string watch_program(const std::string& watching) {
  using namespace rig;
  const std::string distance = block({"memory_nearest", "nearest", "", R"("WHAT": "distance")"});
  const auto less = [](const std::string& a, const std::string& b) {
    return block({"operator_lt", "less", a + ", " + b, ""});
  };
  const std::string some = less(text_input("OPERAND1", "0"), block_input("OPERAND2", distance));
  const std::string again = block({"memory_nearest", "nearest", "", R"("WHAT": "distance")"});
  const std::string near = less(block_input("OPERAND1", again), text_input("OPERAND2", "200"));
  const std::string seen = block(
      {"operator_and", "and", block_input("OPERAND1", some) + ", " + block_input("OPERAND2", near), ""});
  const std::string tell = say("seen", block({"control_stop", "end", "", R"("STOP_OPTION": "all")"}));
  return program(
      flag(block({"memory_keep_eye", "eye", "", R"("WHAT": ")" + watching + "\""},
                 block({"control_wait_until", "until", block_input("CONDITION", seen), ""}, tell))));
}

world::WorldConfig half_empty_room() {
  world::WorldConfig room = *world::world_by_name("green-field");
  room.bounds = {-8, -4, 8, 4};
  room.lines.clear();
  room.boxes.clear();
  room.people.clear();
  room.tags.clear();
  room.jitter = {};
  room.floor = {world::FloorKind::carpet, {150, 140, 125}, 1, 0.5};
  room.walls.front().points_m = {{-8, -4}, {8, -4}, {8, 4}, {-8, 4}, {-8, -4}};
  room.cylinders = {{{kThing_x_m, 0}, kThingRadius_m, 0.42, world::CylinderLook::stripes, {216, 116, 44}}};
  room.X_WR_start = {-4, 0, 0};
  return room;
}

}  // namespace

FirstSight run_first_sight(std::uint64_t seed, const std::string& watching) {
  Random random(seed, "first sight");
  FirstSight run;
  run.seed = seed;
  run.placed_s = std::round(random.uniform(4, 8) * 100) / 100;
  run.bearing_rad = random.uniform(-kMostBearing_rad, kMostBearing_rad);
  run.distance_m = random.uniform(0.5, 1.4);
  rig::LockstepOptions options;
  options.world = half_empty_room();
  options.robot = *robot_by_name("mirada-sim");
  options.seed = seed;
  options.seconds = run.placed_s + kPatience_s;
  // Carried to where the thing stands, which to the robot, that knows only its wheels, is a thing put there.
  options.carry = [&run](Micros now) -> std::optional<Pose2> {
    if (now != micros(run.placed_s)) return std::nullopt;
    return Pose2{kThing_x_m - run.distance_m * std::cos(run.bearing_rad),
                 -run.distance_m * std::sin(run.bearing_rad), 0};
  };
  const session::RunReport report = rig::run_lockstep(watch_program(watching), options);
  run.hash = report.hash;
  if (report.say.empty()) return run;
  // The program ends with what it says; a say's own time counts from the program's start.
  const double after_s = report.simulated_s - run.placed_s;
  run.imagined = after_s < 0;
  if (!run.imagined) run.after_s = after_s;
  return run;
}

}  // namespace mirada::scenarios
