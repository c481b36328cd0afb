#include "rig/lab/lab_score.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/units.h"

namespace mirada::rig {
namespace {

constexpr double kNoShare = std::numeric_limits<double>::quiet_NaN();
constexpr double kSigmas95 = 1.96;

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return kNoShare;
  const auto at = static_cast<std::ptrdiff_t>(std::lround(share * static_cast<double>(values.size() - 1)));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

double share(int part, int whole) { return whole > 0 ? static_cast<double>(part) / whole : kNoShare; }

bool answered(const SonarReading& reading) {
  return reading.answer == Answer::blocked || reading.answer == Answer::clear;
}

struct Counts {
  int answered = 0;
  int missed = 0;
  int imagined = 0;
  int not_seen = 0;
  int within_95 = 0;
  std::vector<double> errors, sizes, near_errors, paper_errors, paper_sizes;
};

void count_error(const LabSample& sample, Counts& counts) {
  const double error = sample.reading.distance_m / sample.truth_m - 1;
  counts.errors.push_back(error);
  counts.sizes.push_back(std::abs(error));
  if (sample.truth_m <= 1) counts.near_errors.push_back(error);
  counts.within_95 +=
      std::abs(sample.reading.distance_m - sample.truth_m) <= kSigmas95 * sample.reading.sigma_m;
  if (std::isnan(sample.paper_m)) return;
  counts.paper_errors.push_back(sample.paper_m / sample.truth_m - 1);
  counts.paper_sizes.push_back(std::abs(counts.paper_errors.back()));
}

void count(const LabSample& sample, bool obstacle, const LabLimits& limits, Counts& counts) {
  const SonarReading& reading = sample.reading;
  if (!answered(reading)) {
    ++counts.not_seen;
    return;
  }
  ++counts.answered;
  const bool blocked = reading.answer == Answer::blocked;
  const double limit_m = std::min(limits.imagined * sample.free_m, limits.obstacle_to_m);
  if (obstacle && reading.distance_m > limits.missed * sample.truth_m) ++counts.missed;
  if (blocked && sample.foot_seen && reading.distance_m < limit_m) ++counts.imagined;
  if (obstacle && blocked && sample.foot_seen) count_error(sample, counts);
}

using Grouping = std::function<std::string(const LabSample&)>;

LabTable table(const std::string& title, const std::vector<LabSample>& samples, const LabLimits& limits,
               const Grouping& group) {
  std::map<std::string, std::vector<const LabSample*>> groups;
  for (const LabSample& sample : samples) groups[group(sample)].push_back(&sample);
  LabTable out{title, {}};
  for (const auto& [name, members] : groups) out.rows.push_back(score(name, members, limits));
  return out;
}

/// "0.50-0.75 m", or "free" beyond the last edge.
std::string distance_group(double truth_m, const LabLimits& limits) {
  if (!(truth_m <= limits.obstacle_to_m)) return "free";
  double low = 0;
  for (const double high : {0.3, 0.5, 0.75, 1.0, 1.25, 1.5}) {
    if (truth_m <= high) return number_text(low, 2) + " to " + number_text(high, 2) + " m";
    low = high;
  }
  return "farther";
}

std::string bearing_group(double off_axis_rad) {
  const int step = std::min(static_cast<int>(std::abs(deg(off_axis_rad)) / 10), 3);
  return std::to_string(10 * step) + " to " + std::to_string(10 * step + 10) + " deg";
}

}  // namespace

LabScore score(const std::string& name, const std::vector<const LabSample*>& samples,
               const LabLimits& limits) {
  LabScore out;
  out.name = name;
  Counts counts;
  for (const LabSample* sample : samples) {
    const bool obstacle = sample->truth_m <= limits.obstacle_to_m;
    ++(obstacle ? out.obstacles : out.free);
    count(*sample, obstacle, limits, counts);
  }
  out.errors = static_cast<int>(counts.errors.size());
  out.median_error = quantile(counts.sizes, 0.5);
  out.p90_error = quantile(counts.sizes, 0.9);
  out.bias = quantile(counts.errors, 0.5);
  out.bias_to_1m = quantile(counts.near_errors, 0.5);
  out.missed = share(counts.missed, out.obstacles);
  out.imagined = share(counts.imagined, counts.answered);
  out.not_seen = share(counts.not_seen, static_cast<int>(samples.size()));
  out.within_95 = share(counts.within_95, out.errors);
  out.paper_median = quantile(counts.paper_sizes, 0.5);
  out.paper_bias = quantile(counts.paper_errors, 0.5);
  return out;
}

std::vector<LabTable> score_tables(const std::vector<LabSample>& samples, const LabLimits& limits) {
  return {table("all", samples, limits, [](const LabSample&) { return "all"; }),
          table("distance", samples, limits,
                [&](const LabSample& s) { return distance_group(s.truth_m, limits); }),
          table("bearing off the camera's axis", samples, limits,
                [](const LabSample& s) { return bearing_group(s.off_axis_rad); }),
          table("floor", samples, limits, [](const LabSample& s) { return s.floor; }),
          table("light", samples, limits, [](const LabSample& s) { return s.light; })};
}

LabTable worst_pictures(const std::vector<LabSample>& samples, std::size_t most, const LabLimits& limits) {
  LabTable out = table("worst pictures", samples, limits, [](const LabSample& s) { return s.picture; });
  const auto wrong = [](const LabScore& s) {
    return (std::isnan(s.missed) ? 0 : s.missed * s.obstacles) +
           (std::isnan(s.imagined) ? 0 : s.imagined * (s.obstacles + s.free));
  };
  std::erase_if(out.rows, [&](const LabScore& s) { return wrong(s) == 0; });
  std::ranges::stable_sort(out.rows, std::greater<>(), wrong);
  if (out.rows.size() > most) out.rows.resize(most);
  return out;
}

}  // namespace mirada::rig
