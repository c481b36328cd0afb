// Distances against the truth in rooms drawn by lot: sonar_accuracy [SEEDS] [--dump FOLDER]. JSON out.
#include <cstdlib>

#include "../../runtime/vision/scene.h"
#include "score.h"
#include "vision/visual_sonar.h"

namespace mirada::bench {
namespace {

using testing::Floor;
using testing::Light;

Score run(Floor floor, Light light, std::uint64_t seed, const RobotConfig& robot, const std::string& folder) {
  Score score;
  const testing::Scene scene = testing::draw_scene(floor, light, seed);
  Random random(seed, "pose");
  const NeckAngles neck{rad(random.uniform(-60, 60)), 0};
  const Pose2 X_WR{0, 0, random.uniform(-3, 3)};
  const Frame frame{testing::render(scene, robot, X_WR, neck), 1, 1};
  vision::VisualSonar sonar(robot);
  const SonarPercept percept = sonar.look(frame, neck, {});
  score.pictures = 1;
  score.untrusted = !percept.floor_model_trusted;
  for (const SonarReading& reading : percept.readings) {
    judge(reading, testing::true_distance_m(scene, X_WR, reading.bearing_rad), score);
  }
  const std::string name = std::string(testing::kFloorNames[static_cast<std::size_t>(floor)]) + "-" +
                           testing::kLightNames[static_cast<std::size_t>(light)] + "-" + std::to_string(seed);
  dump_picture(folder, name, frame.bgr, percept, score);
  return score;
}

}  // namespace
}  // namespace mirada::bench

int main(int argc, char** argv) {
  using namespace mirada;
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 10;
  const std::string folder = argc > 3 && std::string(argv[2]) == "--dump" ? argv[3] : "";
  const auto robot = robot_by_name("mirada-sim");
  if (!robot) return 1;
  nlohmann::json out;
  bench::Score all;
  for (std::size_t f = 0; f < testing::kFloorNames.size(); ++f) {
    for (std::size_t l = 0; l < testing::kLightNames.size(); ++l) {
      bench::Score score;
      for (int i = 1; i <= seeds; ++i) {
        const std::uint64_t seed = static_cast<std::uint64_t>(i) + 1000 * f + 100'000 * l;
        score.merge(
            bench::run(static_cast<testing::Floor>(f), static_cast<testing::Light>(l), seed, *robot, folder));
      }
      out["cells"][std::string(testing::kFloorNames[f]) + "/" + testing::kLightNames[l]] =
          bench::to_json(score);
      all.merge(score);
    }
  }
  out["all"] = bench::to_json(all);
  std::puts(out.dump(1).c_str());
  return 0;
}
