// What the memory and attention are good for, seed after seed; prints one JSON object: every run.
#include <iostream>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/units.h"
#include "corner_run.h"
#include "first_sight_run.h"

namespace {

using namespace mirada::scenarios;
using nlohmann::json;

struct Seeds {
  std::uint64_t first = 101, count = 20;
};

void corner(const Seeds& seeds) {
  json runs = json::array();
  for (std::uint64_t seed = seeds.first; seed < seeds.first + seeds.count; ++seed) {
    for (const bool memory : {true, false}) {
      const CornerRun run = run_corner(seed, memory);
      runs.push_back({{"seed", seed},
                      {"memory", memory},
                      {"left", run.left},
                      {"nearest_m", run.nearest_m},
                      {"end_m", run.end_m},
                      {"crossings", run.crossings},
                      {"looked", run.looked},
                      {"status", run.status},
                      {"hash", run.hash}});
    }
  }
  std::cout << json{{"runs", runs}}.dump(1) << "\n";
}

void sight(const Seeds& seeds) {
  json runs = json::array();
  for (const char* watching : {"around", "zones", "ranks"}) {
    for (std::uint64_t seed = seeds.first; seed < seeds.first + seeds.count; ++seed) {
      const FirstSight run = run_first_sight(seed, watching);
      runs.push_back({{"watching", watching},
                      {"seed", seed},
                      {"bearing_deg", mirada::deg(run.bearing_rad)},
                      {"distance_m", run.distance_m},
                      {"placed_s", run.placed_s},
                      {"after_s", run.after_s ? json(*run.after_s) : json()},
                      {"imagined", run.imagined},
                      {"hash", run.hash}});
    }
  }
  std::cout << json{{"runs", runs}}.dump(1) << "\n";
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Memory and attention, measured by the truth of the simulated rooms."};
  Seeds seeds;
  const auto add = [&](const char* name, const char* what) {
    CLI::App* one = app.add_subcommand(name, what);
    one->add_option("--first-seed", seeds.first)->capture_default_str();
    one->add_option("--seeds", seeds.count)->capture_default_str();
    return one;
  };
  const CLI::App* corners = add("corner", "Out of a corner between two field lines");
  add("sight", "Time until the first sight of a thing placed at random");
  app.require_subcommand(1);
  CLI11_PARSE(app, argc, argv);
  corners->parsed() ? corner(seeds) : sight(seeds);
}
