#include "where_run.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "rig/lockstep.h"
#include "runtime/rig/program_text.h"

namespace mirada::scenarios {
namespace {

constexpr double kTellEvery_s = 0.5;
constexpr double kWrong_m = 0.3;
constexpr Micros kTruthEvery = 10 * kMillisecond;

std::string joined(const std::string& first, const std::string& rest) {
  using namespace rig;
  const std::string gap =
      block({"operator_join", "gap", text_input("STRING1", " ") + ", " + block_input("STRING2", rest), ""});
  return block(
      {"operator_join", "join", block_input("STRING1", first) + ", " + block_input("STRING2", gap), ""});
}

std::string my(const std::string& what) {
  return rig::block({"motion_my_place", "my", "", R"("WHAT": ")" + what + "\""});
}

/// It ends itself, so that its last words tell when its own clock began.
std::string roam_and_tell(double for_s) {
  using namespace rig;
  const std::string known = block({"motion_know_place", "known", "", ""});
  const std::string all = joined(my("x"), joined(my("y"), joined(my("heading"), joined(my("error"), known))));
  const std::string tell =
      block({"looks_say", "say", block_input("MESSAGE", all), ""}, wait(std::to_string(kTellEvery_s)));
  const std::string end = say("end", block({"control_stop", "end", "", R"("STOP_OPTION": "all")"}));
  return program(flag(block({"motion_drive_and_avoid", "roam", "", ""})) + ", " + flag(forever(tell)) + ", " +
                 flag(wait(std::to_string(for_s), end)));
}

Place place_of(Knows knows) {
  Place place = *place_by_name("green-field");
  if (knows == Knows::start || knows == Knows::lines) place.tags.clear();
  if (knows == Knows::start || knows == Knows::tags) {
    place.lines.clear();
    place.circles.clear();
  }
  return place;
}

std::optional<Told> told(const session::SaidText& line, Micros began, const std::map<Micros, Pose2>& truth) {
  double x_cm = 0, y_cm = 0, heading_deg = 0, possible_cm = 0;
  char known[8] = {};
  if (std::sscanf(line.text.c_str(), "%lf %lf %lf %lf %7s", &x_cm, &y_cm, &heading_deg, &possible_cm,
                  known) != 5)
    return std::nullopt;
  const auto at = truth.find((began + line.t) / kTruthEvery);
  if (at == truth.end()) return std::nullopt;
  const Pose2& X_WR = at->second;
  const double heading_rad = rad(90) - rad(heading_deg);
  return Told{began + line.t, std::string(known) == "true",
              std::hypot(x_cm / 100 - X_WR.x_m, y_cm / 100 - X_WR.y_m),
              std::abs(wrap_rad(heading_rad - X_WR.heading_rad)), possible_cm / 100};
}

}  // namespace

const char* to_string(Knows knows) {
  switch (knows) {
    case Knows::start:
      return "start";
    case Knows::lines:
      return "lines";
    case Knows::tags:
      return "tags";
    case Knows::lines_and_tags:
      return "lines and tags";
  }
  return "";
}

namespace {

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace

WhereSummary summary_of(const WhereRun& run) {
  std::vector<double> off_m, off_rad, possible_m;
  double honest = 0;
  for (const Told& told : run.told) {
    if (!told.known) continue;
    off_m.push_back(told.off_m);
    off_rad.push_back(told.off_rad);
    possible_m.push_back(told.possible_m);
    if (told.off_m <= told.possible_m) ++honest;
  }
  WhereSummary out;
  const auto known = static_cast<double>(off_m.size());
  out.known_share = known / static_cast<double>(std::max<std::size_t>(run.told.size(), 1));
  out.off_median_m = quantile(off_m, 0.5);
  out.off_p90_m = quantile(off_m, 0.9);
  out.off_worst_m = quantile(off_m, 1);
  out.off_median_rad = quantile(off_rad, 0.5);
  out.possible_median_m = quantile(possible_m, 0.5);
  out.honest_share = honest / std::max(known, 1.0);
  return out;
}

CarriedSummary carried_summary(const WhereRun& run, Micros carried_at) {
  CarriedSummary out;
  for (const Told& told : run.told) {
    if (told.t <= carried_at) continue;
    const double after_s = seconds(told.t - carried_at);
    if (!told.known && !out.lost_s) out.lost_s = after_s;
    if (!told.known || !out.lost_s) continue;
    if (!out.back_s) out.back_s = after_s;
    if (told.off_m > kWrong_m) out.wrong_after_s += kTellEvery_s;
  }
  return out;
}

WhereRun run_where(const WherePlan& plan) {
  rig::LockstepOptions options;
  options.world = *world::world_by_name("green-field");
  options.world->noise.wheel_scale = plan.wheel_scale;
  options.robot = *robot_by_name("mirada-sim");
  options.robot.place = place_of(plan.knows);
  options.seed = plan.seed;
  options.seconds = plan.seconds + 5;
  std::map<Micros, Pose2> truth;
  WhereRun run;
  run.seed = plan.seed;
  options.watch = [&](Micros t, const world::Truth& now) {
    truth[t / kTruthEvery] = now.X_WR;
    run.path_m = now.path_m;
  };
  options.carry = [&](Micros now) {
    return now == plan.carried_at ? plan.carried_to : std::optional<Pose2>();
  };
  const session::RunReport report = rig::run_lockstep(roam_and_tell(plan.seconds), options);
  const Micros began = micros(report.simulated_s) - report.say.back().t;
  for (const auto& line : report.say) {
    if (const auto one = told(line, began, truth)) run.told.push_back(*one);
  }
  run.hash = report.hash;
  return run;
}

}  // namespace mirada::scenarios
