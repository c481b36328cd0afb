// Runs a program in rooms and seeds and prints one JSON object: every run, and whether the numbers that the
// project promises for *Avoid the obstacles* hold.
#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "avoid_run.h"
#include "world/world_config.h"

namespace {

using mirada::scenarios::AvoidRun;

struct Arguments {
  std::vector<std::string> worlds;
  std::uint64_t first_seed = 1;
  std::uint64_t seeds = 20;
  double seconds = 120;
  std::string program;
  bool forgets = false;
};

nlohmann::json to_json(const AvoidRun& run) {
  return {{"world", run.world},
          {"seed", run.seed},
          {"status", run.status},
          {"contacts", run.contacts},
          {"path_m", run.path_m},
          {"cells", run.cells},
          {"first_contact", run.first_contact},
          {"wall_s", run.wall_s},
          {"hash", run.hash}};
}

std::string text_of(const std::string& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

nlohmann::json judge(const std::vector<AvoidRun>& runs) {
  std::map<std::string, std::size_t> touched;
  bool roams = true;
  double simulated_s = 0;
  double wall_s = 0;
  for (const AvoidRun& run : runs) {
    touched[run.world] += run.contacts > 0 ? 1 : 0;
    roams = roams && run.path_m >= 5 && run.cells >= 25;
    simulated_s += run.simulated_s;
    wall_s += run.wall_s;
  }
  const bool clean = std::ranges::all_of(touched, [](const auto& room) { return room.second <= 1; });
  return {{"runs_with_contact", touched},
          {"at_most_one_in_each_room", clean},
          {"every_run_5_m_and_25_cells", roams},
          {"times_real_time", wall_s > 0 ? simulated_s / wall_s : 0}};
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"A program that drives about, measured by the truth of the simulated rooms."};
  Arguments arguments;
  app.add_option("--world", arguments.worlds,
                 "Rooms (all that ship); lab:FLOOR:LIGHT:NUMBER is one of the laboratory's");
  app.add_option("--first-seed", arguments.first_seed)->capture_default_str();
  app.add_option("--seeds", arguments.seeds)->capture_default_str();
  app.add_option("--seconds", arguments.seconds)->capture_default_str();
  app.add_option("--program", arguments.program, "A program file (Avoid the obstacles)")
      ->check(CLI::ExistingFile);
  app.add_flag("--forgets", arguments.forgets,
               "The visual memory keeps no more than the newest picture shows");
  CLI11_PARSE(app, argc, argv);
  if (arguments.worlds.empty()) arguments.worlds = mirada::world::shipped_worlds();
  const std::string program =
      arguments.program.empty() ? mirada::scenarios::avoid_program() : text_of(arguments.program);
  std::vector<AvoidRun> runs;
  for (const std::string& world : arguments.worlds) {
    for (std::uint64_t seed = arguments.first_seed; seed < arguments.first_seed + arguments.seeds; ++seed) {
      const auto run =
          mirada::scenarios::run_in_room(program, world, seed, arguments.seconds, !arguments.forgets);
      if (!run) {
        std::cerr << mirada::to_text(run.faults(), mirada::Lang::en);
        return 2;
      }
      std::cerr << world << " " << seed << ": contacts " << run->contacts << ", " << run->path_m
                << " m, cells " << run->cells
                << (run->first_contact.empty() ? "" : ", first " + run->first_contact) << "\n";
      runs.push_back(*run);
    }
  }
  nlohmann::json out = {
      {"seconds", arguments.seconds}, {"verdict", judge(runs)}, {"runs", nlohmann::json::array()}};
  for (const AvoidRun& run : runs) out["runs"].push_back(to_json(run));
  std::cout << out.dump(1) << "\n";
  return 0;
}
