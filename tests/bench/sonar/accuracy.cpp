// Distances against the truth in rooms drawn by lot: sonar_accuracy [SEEDS] [--dump FOLDER]. JSON out.
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "../../runtime/vision/scene.h"
#include "vision/overlay.h"
#include "vision/visual_sonar.h"

namespace mirada {
namespace {

using testing::Floor;
using testing::Light;

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

double quantile(std::vector<double> v, double q) {
  if (v.empty()) return 0;
  std::sort(v.begin(), v.end());
  return v[std::min(v.size() - 1, static_cast<std::size_t>(q * static_cast<double>(v.size())))];
}

void judge(const SonarReading& reading, double truth_m, Score& score) {
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

Score run(Floor floor, Light light, std::uint64_t seed, const RobotConfig& robot, const std::string& dump) {
  Score score;
  const testing::Scene scene = testing::draw_scene(floor, light, seed);
  Random random(seed, "pose");
  const NeckAngles neck{rad(random.uniform(-60, 60)), 0};
  const Pose2 X_WR{0, 0, random.uniform(-3, 3)};
  Frame frame{testing::render(scene, robot, X_WR, neck), 1, 1};
  vision::VisualSonar sonar(robot);
  const SonarPercept percept = sonar.look(frame, neck, {});
  score.pictures = 1;
  score.untrusted = !percept.floor_model_trusted;
  for (const SonarReading& reading : percept.readings)
    judge(reading, testing::true_distance_m(scene, X_WR, reading.bearing_rad), score);
  if (!dump.empty()) {
    cv::Mat drawn = frame.bgr.clone();
    vision::draw_overlay(drawn, percept, {});
    char name[200];
    std::snprintf(name, sizeof name, "%s/%s-%s-%03d-m%02d-i%02d-e%02d.png", dump.c_str(),
                  testing::kFloorNames[static_cast<std::size_t>(floor)],
                  testing::kLightNames[static_cast<std::size_t>(light)], static_cast<int>(seed), score.missed,
                  score.invented, static_cast<int>(100 * quantile(score.errors, 0.9)));
    cv::Mat both;
    cv::hconcat(frame.bgr, drawn, both);
    cv::imwrite(name, both);
  }
  return score;
}

nlohmann::json to_json(const Score& s) {
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

}  // namespace
}  // namespace mirada

int main(int argc, char** argv) {
  using namespace mirada;
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 10;
  const std::string dump = argc > 3 && std::string(argv[2]) == "--dump" ? argv[3] : "";
  const auto robot = robot_by_name("mirada-sim");
  if (!robot) return 1;
  nlohmann::json out;
  Score all;
  for (std::size_t f = 0; f < testing::kFloorNames.size(); ++f) {
    for (std::size_t l = 0; l < testing::kLightNames.size(); ++l) {
      Score score;
      for (int seed = 1; seed <= seeds; ++seed) {
        score.merge(run(static_cast<Floor>(f), static_cast<Light>(l),
                        static_cast<std::uint64_t>(seed) + 1000 * f + 100'000 * l, *robot, dump));
      }
      out["cells"][std::string(testing::kFloorNames[f]) + "/" + testing::kLightNames[l]] = to_json(score);
      all.merge(score);
    }
  }
  out["all"] = to_json(all);
  std::puts(out.dump(1).c_str());
  return 0;
}
