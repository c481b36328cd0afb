// How many times faster than real time a program runs in lockstep on one core: rendered, seen, run. Prints
// JSON. CPU time is what counts: wall time is also what else the machine does.
#include <ctime>
#include <iostream>

#include <nlohmann/json.hpp>

#include "base/files.h"
#include "rig/lockstep.h"

namespace {

using namespace mirada;

double cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

nlohmann::json measure(const std::string& example, const std::string& world, double seconds) {
  const auto program = read_file(data_folder("blocks") / example);
  rig::LockstepOptions options;
  options.robot = robot_by_name("mirada-sim").value();
  if (world != "none") options.world = world::world_by_name(world).value();
  options.seconds = seconds;
  const double before = cpu_s();
  const session::RunReport report = rig::run_lockstep(program.value(), options);
  const double used = cpu_s() - before;
  return {{"program", example},
          {"world", world},
          {"simulated_s", report.simulated_s},
          {"cpu_s", used},
          {"wall_s", report.wall_s},
          {"times_real_time_cpu", report.simulated_s / used},
          {"times_real_time_wall", report.simulated_s / report.wall_s}};
}

}  // namespace

int main() {
  nlohmann::json runs = nlohmann::json::array();
  for (const std::string& world : world::shipped_worlds()) {
    runs.push_back(measure("vision/examples/avoid.json", world, 60));
  }
  for (const std::string& world : world::shipped_worlds()) {
    runs.push_back(measure("vision/examples/greet.json", world, 20));
  }
  std::cout << nlohmann::json{{"bench", "lockstep"}, {"runs", runs}}.dump(1) << "\n";
  return 0;
}
