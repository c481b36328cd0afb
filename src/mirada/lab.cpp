#include <cmath>
#include <memory>
#include <optional>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "commands.h"
#include "lab_messages.h"
#include "rig/lab/lab_distances.h"
#include "rig/lab/lab_keep.h"
#include "rig/lab/lab_pictures.h"
#include "rig/lab/lab_plot.h"
#include "rig/lab/lab_score.h"
#include "rig/lab/messages.h"

namespace mirada {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kBadInput = 2;

struct LabOptions {
  std::vector<std::string> floors = {"carpet", "wood", "tiles", "concrete", "grass"};
  std::vector<std::string> lights = {"even", "side", "dim"};
  int seeds = 4;
  std::uint64_t first_seed = 1000;
  std::string robot;
  bool mount_errors = false;
  std::string folder;
  std::string keep;
  std::string plot;
  std::string floor_method = "learnt";
  bool lines_are_obstacles = false;
  std::size_t worst = 12;
  bool json = false;
  std::string lang = "en";

  Lang language() const { return lang == "es" ? Lang::es : Lang::en; }
  vision::SonarSettings sonar() const {
    vision::SonarSettings settings;
    settings.lines_are_obstacles = lines_are_obstacles;
    if (floor_method == "fixed-colour") settings.floor = vision::SonarSettings::Floor::fixed_colour;
    return settings;
  }
};

int refuse(const Faults& faults, const LabOptions& options) {
  fmt::print(stderr, "{}\n", to_text(faults, options.language()));
  return kBadInput;
}

/// A number that was not counted is null in JSON.
Json number(double value) { return std::isnan(value) ? Json(nullptr) : Json(std::round(value * 1e5) / 1e5); }

Json to_json(const rig::LabScore& score) {
  return {{"name", score.name},
          {"obstacle_bearings", score.obstacles},
          {"free_bearings", score.free},
          {"errors", score.errors},
          {"median_error", number(score.median_error)},
          {"p90_error", number(score.p90_error)},
          {"bias", number(score.bias)},
          {"bias_to_1m", number(score.bias_to_1m)},
          {"missed", number(score.missed)},
          {"imagined", number(score.imagined)},
          {"not_seen", number(score.not_seen)},
          {"within_95", number(score.within_95)},
          {"paper_median_error", number(score.paper_median)},
          {"paper_bias", number(score.paper_bias)}};
}

std::string percent(double share) { return std::isnan(share) ? "-" : fmt::format("{:.1f}", 100 * share); }

void print_table(const rig::LabTable& table) {
  fmt::print("\n{:<30} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>8} {:>7} {:>9} {:>7}\n", table.title, "n",
             "median%", "p90%", "bias%", "to1m%", "missed%", "imag.%", "notseen%", "in95%", "paper med",
             "bias%");
  for (const rig::LabScore& s : table.rows) {
    fmt::print("{:<30} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>7} {:>8} {:>7} {:>9} {:>7}\n", s.name, s.errors,
               percent(s.median_error), percent(s.p90_error), percent(s.bias), percent(s.bias_to_1m),
               percent(s.missed), percent(s.imagined), percent(s.not_seen), percent(s.within_95),
               percent(s.paper_median), percent(s.paper_bias));
  }
}

/// Prints the tables, after the plot was drawn; the exit code.
int report(const std::vector<rig::LabSample>& samples, const LabOptions& options) {
  auto tables = rig::score_tables(samples);
  if (!options.plot.empty()) {
    const Status drawn = write_file_atomically(options.plot, rig::svg_plot(tables));
    if (!drawn) return refuse(drawn.faults(), options);
  }
  tables.push_back(rig::worst_pictures(samples, options.worst));
  if (options.json) {
    Json out = {{"mount", options.mount_errors ? "by_chance" : "exact"}, {"tables", Json::array()}};
    for (const rig::LabTable& table : tables) {
      Json rows = Json::array();
      for (const rig::LabScore& score : table.rows) rows.push_back(to_json(score));
      out["tables"].push_back({{"by", table.title}, {"rows", rows}});
    }
    fmt::print("{}\n", out.dump(2));
    return 0;
  }
  for (const rig::LabTable& table : tables) print_table(table);
  fmt::print("\n{}\n", format(messages::lab_legend, {}, options.language()));
  return 0;
}

template <class T, class From>
std::vector<T> read_names(const std::vector<std::string>& names, const From& from, const char* known,
                          const char* place, Faults& faults) {
  std::vector<T> out;
  for (const std::string& name : names) {
    if (const auto value = from(name)) {
      out.push_back(*value);
    } else {
      faults.push_back(make_fault(place, messages::lab_choice, {{"value", name}, {"known", known}}));
    }
  }
  return out;
}

int distances(const LabOptions& options) {
  Faults faults;
  rig::LabPlan plan;
  plan.floors = read_names<world::FloorKind>(
      options.floors, rig::lab_floor_from, "plain, carpet, wood, tiles, concrete, grass", "--floors", faults);
  plan.lights =
      read_names<rig::LabLight>(options.lights, rig::lab_light_from, "even, side, dim", "--lights", faults);
  plan.robot = rig::lab_robot();
  if (!options.robot.empty()) {
    auto robot = robot_by_name(options.robot);
    if (robot) {
      plan.robot = std::move(*robot);
    } else {
      faults.insert(faults.end(), robot.faults().begin(), robot.faults().end());
    }
  }
  if (!faults.empty()) return refuse(faults, options);
  plan.seeds = options.seeds;
  plan.first_seed = options.first_seed;
  plan.exact_mount = !options.mount_errors;
  plan.sonar = options.sonar();
  const bool show = isatty(STDERR_FILENO) != 0;
  std::optional<rig::LabKeeper> keeper;
  if (!options.keep.empty()) keeper.emplace(options.keep, rig::told_robot(plan));
  const auto samples = rig::look_at_rooms(
      plan,
      [&](int done, int all) {
        if (show) fmt::print(stderr, "\r{}/{} ", done, all);
      },
      [&](const rig::LabShot& shot) {
        if (keeper) keeper->add(shot);
      });
  if (show) fmt::print(stderr, "\r");
  if (keeper) {
    if (const Status kept = keeper->finish(); !kept) return refuse(kept.faults(), options);
  }
  return report(samples, options);
}

int pictures(const LabOptions& options) {
  Faults warnings;
  const auto known = rig::read_truth(options.folder, &warnings);
  if (!known) return refuse(known.faults(), options);
  if (!warnings.empty()) fmt::print(stderr, "{}\n", to_text(warnings, options.language()));
  const std::string robot = options.robot.empty() ? "mirada-sim" : options.robot;
  const auto samples = rig::look_at_pictures(*known, robot, options.folder, options.sonar());
  if (!samples) return refuse(samples.faults(), options);
  return report(*samples, options);
}

void add_common(CLI::App& app, LabOptions& options) {
  app.add_option("--robot", options.robot, "Id of a shipped robot, or a robot.json file");
  app.add_option("--floor-method", options.floor_method, "learnt, or the paper's fixed-colour border")
      ->check(CLI::IsMember({"learnt", "fixed-colour"}))
      ->capture_default_str();
  app.add_flag("--lines-are-obstacles", options.lines_are_obstacles, "A painted line ends the free floor");
  app.add_option("--worst", options.worst, "How many of the worst pictures to list")
      ->check(number_between(0, 10'000))
      ->capture_default_str();
  app.add_flag("--json", options.json, "The tables as JSON (shares from 0 to 1)");
  app.add_option("--plot", options.plot,
                 "Draw the errors by distance, bearing, floor and light to this .svg file");
  app.add_option("--lang", options.lang, "en or es")
      ->check(CLI::IsMember({"en", "es"}))
      ->capture_default_str();
}

void add_distances(CLI::App& lab, const std::shared_ptr<LabOptions>& options, Commands& commands) {
  CLI::App* app =
      lab.add_subcommand("distances", "Render rooms by chance and score every bearing of every picture.");
  app->add_option("--floors", options->floors, "plain, carpet, wood, tiles, concrete, grass")
      ->delimiter(',')
      ->capture_default_str();
  app->add_option("--lights", options->lights, "even, side, dim")->delimiter(',')->capture_default_str();
  app->add_option("--seeds", options->seeds, "Rooms of each floor in each light")
      ->check(number_between(1, 10'000))
      ->capture_default_str();
  app->add_option("--first-seed", options->first_seed, "The first room's seed")
      ->check(number_between(0, kLargestSeed))
      ->capture_default_str();
  app->add_flag("--mount-errors", options->mount_errors,
                "Tilt, height and pan are off by chance as the robot's file says (otherwise exactly known)");
  app->add_option("--keep", options->keep, "Write the pictures and their truth.json into this folder");
  add_common(*app, *options);
  app->callback([options, &commands] { commands.exit_code = distances(*options); });
}

}  // namespace

void add_lab(Commands& commands) {
  auto options = std::make_shared<LabOptions>();
  CLI::App* lab = commands.app.add_subcommand("lab", "Measure how true the distances are.");
  lab->require_subcommand(1);
  add_distances(*lab, options, commands);
  CLI::App* app = lab->add_subcommand("pictures", "The same for a folder of pictures with a truth.json.");
  app->add_option("FOLDER", options->folder, "Holds truth.json (docs/calibration.md) and the pictures")
      ->required();
  add_common(*app, *options);
  app->callback([options, &commands] { commands.exit_code = pictures(*options); });
}

}  // namespace mirada
