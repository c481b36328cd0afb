// Follows a walker by chance in seed after seed and prints one JSON object: every run.
#include <fstream>
#include <iostream>
#include <optional>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "follow_run.h"

int main(int argc, char** argv) {
  using namespace mirada::scenarios;
  CLI::App app{"Following somebody who walks, measured by the truth of the simulated room."};
  std::uint64_t first = 1, seeds = 20;
  double seconds = 60;
  std::string only, trace_file;
  app.add_option("--first-seed", first)->capture_default_str();
  app.add_option("--seeds", seeds)->capture_default_str();
  app.add_option("--seconds", seconds)->capture_default_str();
  app.add_option("--walk", only, "Only this walk");
  app.add_option("--trace", trace_file, "A CSV file of where they were, a line a tenth of a second");
  std::optional<double> oracle_s;
  app.add_option("--oracle", oracle_s,
                 "Followed by the truth as it was so many seconds ago, with the robot's wheels");
  CLI11_PARSE(app, argc, argv);
  const std::pair<const char*, Walk> walks[] = {
      {"faces the robot", {0.35, true, false, false, false}},
      {"walks as people do", {0.3, false, false, false, false}},
      {"passes behind a pillar", {0.3, true, true, false, false}},
      {"learnt, among printed faces", {0.3, true, false, true, true}}};
  std::ofstream trace(trace_file);
  nlohmann::json runs = nlohmann::json::array();
  for (const auto& [name, walk] : walks) {
    if (!only.empty() && only != name) continue;
    for (std::uint64_t seed = first; seed < first + seeds; ++seed) {
      const FollowRun run = oracle_s
                                ? run_oracle(walk, seed, seconds, *oracle_s)
                                : run_follow(walk, seed, seconds, 6, trace_file.empty() ? nullptr : &trace);
      runs.push_back({{"walk", name},
                      {"seed", seed},
                      {"speed_mps", walk.speed_mps},
                      {"in_view", run.in_view_share},
                      {"at_distance", run.at_distance_share},
                      {"both", run.both_share},
                      {"too_near", run.too_near_share},
                      {"too_far", run.too_far_share},
                      {"longest_out_s", run.longest_out_s},
                      {"end_off_m", run.end_off_m},
                      {"longest_poster_s", run.longest_poster_s},
                      {"contacts", run.contacts},
                      {"hash", run.hash}});
      std::cerr << name << " " << seed << ": view " << run.in_view_share << " distance "
                << run.at_distance_share << " near " << run.too_near_share << " far " << run.too_far_share
                << " out " << run.longest_out_s << " s, poster " << run.longest_poster_s << " s, contacts "
                << run.contacts << ", " << run.wall_s << " s\n";
    }
  }
  std::cout << nlohmann::json{{"seconds", seconds}, {"runs", runs}}.dump(1) << "\n";
}
