#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/geometry.h"

namespace mirada::scenarios {

/// What a robot in the green field is told of it: only where it starts, or also where lines are painted,
/// where tags hang, or both.
enum class Knows { start, lines, tags, lines_and_tags };
const char* to_string(Knows knows);

/// What it said by its blocks at one time, and the truth of it.
struct Told {
  Micros t = 0;
  bool known = false;
  double off_m = 0;       ///< of x and y
  double off_rad = 0;     ///< of the heading
  double possible_m = 0;  ///< *my possible error*: two sigmas
};

struct WhereRun {
  std::uint64_t seed = 0;
  std::vector<Told> told;  ///< every half second
  double path_m = 0;
  std::string hash;
};

struct WherePlan {
  std::uint64_t seed = 1;
  Knows knows = Knows::lines;
  double seconds = 30;
  double wheel_scale = 0.01;  ///< 1-sigma of each wheel's size
  std::optional<Pose2> carried_to{};
  Micros carried_at = 0;
};

/// What a run was worth, over all that it told while it said that it knows where it is.
struct WhereSummary {
  double known_share = 0;
  double off_median_m = 0, off_p90_m = 0, off_worst_m = 0;
  double off_median_rad = 0;
  double possible_median_m = 0;
  double honest_share = 0;  ///< no farther off than the possible error
};
WhereSummary summary_of(const WhereRun& run);

/// What became of a robot that was carried away, seconds after that.
struct CarriedSummary {
  std::optional<double> lost_s;  ///< said so
  std::optional<double> back_s;  ///< knew again, after that
  double wrong_after_s = 0;      ///< said that it knows, after it had been lost, and was 30 cm off or more
};
CarriedSummary carried_summary(const WhereRun& run, Micros carried_at);

/// Drives and avoids in the green field and says every half second where it believes to be.
WhereRun run_where(const WherePlan& plan);

}  // namespace mirada::scenarios
