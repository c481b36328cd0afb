// What the memory and attention are good for, seed after seed; prints one JSON object: every run.
#include <iostream>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "base/random.h"
#include "base/units.h"
#include "corner_run.h"
#include "first_sight_run.h"
#include "where_run.h"

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

json or_null(const std::optional<double>& value) { return value ? json(*value) : json(); }

json where_run(Knows knows, std::uint64_t seed) {
  WherePlan plan;
  plan.seed = seed;
  plan.knows = knows;
  plan.seconds = 60;
  const WhereRun run = run_where(plan);
  const WhereSummary sum = summary_of(run);
  return {{"knows", to_string(knows)},
          {"seed", seed},
          {"path_m", run.path_m},
          {"known", sum.known_share},
          {"off_median_m", sum.off_median_m},
          {"off_p90_m", sum.off_p90_m},
          {"off_worst_m", sum.off_worst_m},
          {"off_median_deg", mirada::deg(sum.off_median_rad)},
          {"possible_median_m", sum.possible_median_m},
          {"honest", sum.honest_share},
          {"hash", run.hash}};
}

json carried_run(Knows knows, std::uint64_t seed) {
  mirada::Random random(seed, "carried away");
  WherePlan plan;
  plan.seed = seed;
  plan.knows = knows;
  plan.seconds = 40;
  plan.carried_at = 10 * mirada::kSecond;
  plan.carried_to = {random.uniform(-1.6, 1.6), random.uniform(-1.2, 1.2), random.uniform(-3.1, 3.1)};
  const WhereRun run = run_where(plan);
  const CarriedSummary sum = carried_summary(run, plan.carried_at);
  return {{"knows", to_string(knows)},          {"seed", seed},
          {"lost_s", or_null(sum.lost_s)},      {"back_s", or_null(sum.back_s)},
          {"wrong_after_s", sum.wrong_after_s}, {"hash", run.hash}};
}

void where(const Seeds& seeds) {
  json runs = json::array(), carried = json::array();
  for (const Knows knows : {Knows::start, Knows::lines, Knows::tags, Knows::lines_and_tags}) {
    for (std::uint64_t seed = seeds.first; seed < seeds.first + seeds.count; ++seed) {
      runs.push_back(where_run(knows, seed));
      if (knows != Knows::start) carried.push_back(carried_run(knows, seed));
    }
  }
  std::cout << json{{"runs", runs}, {"carried", carried}}.dump(1) << "\n";
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
  const CLI::App* wheres = add("place", "Where the robot believes to be, by lines and tags that it knows");
  app.require_subcommand(1);
  CLI11_PARSE(app, argc, argv);
  if (corners->parsed()) {
    corner(seeds);
  } else if (wheres->parsed()) {
    where(seeds);
  } else {
    sight(seeds);
  }
}
