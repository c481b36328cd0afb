#pragma once
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "model/percepts.h"
#include "vision/overlay.h"

namespace mirada::bench {

// How readings are held against the truth, the same for every set of rooms.

constexpr double kJudged_m = 1.5;

struct Score {
  std::vector<double> errors;  ///< relative, of obstacles within kJudged_m reported blocked
  std::vector<double> signed_errors_1m;
  int obstacles = 0;  ///< bearings with an obstacle within kJudged_m
  int missed = 0;     ///< reported clear beyond the obstacle
  int silent = 0;     ///< not seen
  int free = 0;       ///< bearings free to beyond kJudged_m
  int invented = 0;   ///< reported blocked within kJudged_m
  int inside_95 = 0;
  int untrusted = 0;
  int pictures = 0;

  void merge(const Score& o) {
    errors.insert(errors.end(), o.errors.begin(), o.errors.end());
    signed_errors_1m.insert(signed_errors_1m.end(), o.signed_errors_1m.begin(), o.signed_errors_1m.end());
    obstacles += o.obstacles, missed += o.missed, silent += o.silent, free += o.free, invented += o.invented;
    inside_95 += o.inside_95, untrusted += o.untrusted, pictures += o.pictures;
  }
};

inline double quantile(std::vector<double> v, double q) {
  if (v.empty()) return 0;
  std::sort(v.begin(), v.end());
  return v[std::min(v.size() - 1, static_cast<std::size_t>(q * static_cast<double>(v.size())))];
}

inline void judge(const SonarReading& reading, double truth_m, Score& score) {
  if (truth_m > kJudged_m) {
    // A little beyond the limit may be read a little within it.
    if (truth_m < 1.1 * kJudged_m) return;
    ++score.free;
    score.invented += reading.answer == Answer::blocked && reading.distance_m < kJudged_m;
    return;
  }
  ++score.obstacles;
  score.silent += reading.answer == Answer::not_seen;
  score.missed += reading.answer == Answer::clear && reading.distance_m > 1.03 * truth_m;
  if (reading.answer != Answer::blocked) return;
  const double error = reading.distance_m / truth_m - 1;
  score.errors.push_back(std::abs(error));
  if (truth_m <= 1) score.signed_errors_1m.push_back(error);
  score.inside_95 += std::abs(reading.distance_m - truth_m) <= 1.96 * reading.sigma_m;
}

inline nlohmann::json to_json(const Score& s) {
  const auto share = [](int part, int whole) { return whole ? std::round(1e4 * part / whole) / 100 : 0.0; };
  const auto percent = [](double x) { return std::round(1e4 * x) / 100; };
  return {{"median_error_pct", percent(quantile(s.errors, 0.5))},
          {"p90_error_pct", percent(quantile(s.errors, 0.9))},
          {"bias_to_1m_pct", percent(quantile(s.signed_errors_1m, 0.5))},
          {"obstacle_reported_clear_pct", share(s.missed, s.obstacles)},
          {"obstacle_not_seen_pct", share(s.silent, s.obstacles)},
          {"clear_reported_blocked_pct", share(s.invented, s.free)},
          {"inside_95_pct", share(s.inside_95, static_cast<int>(s.errors.size()))},
          {"untrusted_pictures_pct", share(s.untrusted, s.pictures)},
          {"bearings", s.obstacles + s.free}};
}

/// The picture and the picture with what was seen, side by side; the name tells what was wrong.
inline void dump_picture(const std::string& folder, const std::string& name, const cv::Mat& bgr,
                         const SonarPercept& percept, const Score& score) {
  if (folder.empty()) return;
  cv::Mat drawn = bgr.clone();
  vision::draw_overlay(drawn, percept, {});
  cv::Mat both;
  cv::hconcat(bgr, drawn, both);
  const int p90_pct = static_cast<int>(100 * quantile(score.errors, 0.9));
  cv::imwrite(folder + "/" + name + "-m" + std::to_string(score.missed) + "-i" +
                  std::to_string(score.invented) + "-e" + std::to_string(p90_pct) + ".png",
              both);
}

}  // namespace mirada::bench
