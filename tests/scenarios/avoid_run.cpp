#include "avoid_run.h"

#include <cmath>
#include <set>
#include <utility>

#include "base/files.h"
#include "rig/lockstep.h"

namespace mirada::scenarios {
namespace {
constexpr double kCell_m = 0.25;

std::string place(Micros t, const world::Truth& truth) {
  return number_text(seconds(t), 1) + " s at " + number_text(truth.X_WR.x_m, 2) + ", " +
         number_text(truth.X_WR.y_m, 2) + " heading " + number_text(deg(truth.X_WR.heading_rad), 0);
}

}  // namespace

Result<AvoidRun> run_in_room(const std::string& program_json, const std::string& world, std::uint64_t seed,
                             double seconds) {
  auto room = world::world_by_name(world);
  if (!room) return room.faults();
  auto robot = robot_by_name("mirada-sim");
  if (!robot) return robot.faults();
  rig::LockstepOptions options;
  options.world = std::move(*room);
  options.robot = std::move(*robot);
  options.seed = seed;
  options.seconds = seconds;
  AvoidRun run;
  std::set<std::pair<long, long>> cells;
  options.watch = [&](Micros t, const world::Truth& truth) {
    cells.emplace(std::lround(std::floor(truth.X_WR.x_m / kCell_m)),
                  std::lround(std::floor(truth.X_WR.y_m / kCell_m)));
    if (truth.contacts > 0 && run.first_contact.empty()) run.first_contact = place(t, truth);
  };
  const session::RunReport report = rig::run_lockstep(program_json, options);
  run.world = world;
  run.seed = seed;
  run.status = to_string(report.status);
  run.cells = static_cast<int>(cells.size());
  run.simulated_s = report.simulated_s;
  run.wall_s = report.wall_s;
  run.hash = report.hash;
  if (report.robot) {
    run.contacts = report.robot->contacts;
    run.path_m = report.robot->path_m;
  }
  return run;
}

std::string avoid_program() {
  const auto text = read_file(data_folder("blocks") / "vision" / "examples" / "avoid.json");
  return text ? *text : std::string();
}

}  // namespace mirada::scenarios
