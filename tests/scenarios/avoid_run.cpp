#include "avoid_run.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include "base/files.h"
#include "rig/lab/lab_room.h"
#include "rig/lockstep.h"

namespace mirada::scenarios {
namespace {
constexpr double kCell_m = 0.25;

std::string place(Micros t, const world::Truth& truth) {
  return number_text(seconds(t), 1) + " s at " + number_text(truth.X_WR.x_m, 2) + ", " +
         number_text(truth.X_WR.y_m, 2) + " heading " + number_text(deg(truth.X_WR.heading_rad), 0);
}

/// "lab:FLOOR:LIGHT:NUMBER" is the laboratory's room of that number, started from the first of its stands.
std::optional<world::WorldConfig> lab_world(const std::string& name) {
  std::vector<std::string> parts;
  std::istringstream in(name);
  for (std::string part; std::getline(in, part, ':');) parts.push_back(part);
  if (parts.size() != 4 || parts[0] != "lab") return std::nullopt;
  const auto floor = rig::lab_floor_from(parts[1]);
  const auto light = rig::lab_light_from(parts[2]);
  std::uint64_t number = 0;
  const auto read = std::from_chars(parts[3].data(), parts[3].data() + parts[3].size(), number);
  if (!floor || !light || read.ec != std::errc() || read.ptr != parts[3].data() + parts[3].size())
    return std::nullopt;
  rig::LabRoom room = rig::lab_room(*floor, *light, number);
  if (room.stands.empty()) return std::nullopt;
  room.world.X_WR_start = room.stands.front();
  return room.world;
}

}  // namespace

Result<AvoidRun> run_in_room(const std::string& program_json, const std::string& world, std::uint64_t seed,
                             double seconds, bool remembers) {
  std::optional<world::WorldConfig> chosen = lab_world(world);
  if (!chosen) {
    auto shipped = world::world_by_name(world);
    if (!shipped) return shipped.faults();
    chosen = std::move(*shipped);
  }
  auto robot = robot_by_name("mirada-sim");
  if (!robot) return robot.faults();
  rig::LockstepOptions options;
  options.world = std::move(*chosen);
  options.robot = std::move(*robot);
  options.seed = seed;
  options.remembers = remembers;
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
