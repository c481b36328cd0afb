#include <cmath>
#include <filesystem>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "base/files.h"
#include "base/units.h"
#include "rig/lab/lab_distances.h"
#include "rig/lab/lab_keep.h"
#include "rig/lab/lab_pictures.h"
#include "rig/lab/lab_plot.h"
#include "rig/lab/lab_score.h"
#include "rig/lab/lab_truth.h"
#include "rig/lab/paper_geometry.h"
#include "vision/ground_projection.h"
#include "world/render/renderer.h"

namespace mirada::rig {
namespace {

using ::testing::HasSubstr;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(PaperGeometry, ReadsAsLongAsItsPublishedNumbersSay) {
  // The paper's robot: 11 cm high, 3.3 degrees down, its own camera.
  RobotConfig robot;
  robot.camera.fx_px = kPaperK[0];
  robot.camera.fy_px = kPaperK[1];
  robot.camera.cx_px = kPaperK[2];
  robot.camera.cy_px = kPaperK[3];
  robot.mount.p_TM_m = {0, 0, 0.11};
  robot.mount.tilt_rad = rad(3.3);
  const vision::GroundProjection ground(robot, robot.camera, {});
  for (const auto& [true_m, error] : {std::pair{0.3, 0.028}, {0.5, 0.053}, {1.0, 0.122}, {2.0, 0.289}}) {
    const auto pixel = ground.pixel({true_m, 0});
    ASSERT_TRUE(pixel);
    const double said_m = paper_distance_m(robot, robot.camera, {}, pixel->x(), pixel->y());
    EXPECT_NEAR(said_m / true_m - 1, error, 0.002) << true_m;
  }
  PaperGeometry level;
  EXPECT_FALSE(level.floor_point({160, 20}));
}

TEST(LabTruth, MeasuresToTheFirstThing) {
  world::WorldConfig room;
  world::WallConfig wall;
  wall.points_m = {{2, -3}, {2, 3}};
  room.walls.push_back(wall);
  world::CylinderConfig cylinder;
  cylinder.p_W_m = {1, 0.5};
  cylinder.radius_m = 0.1;
  room.cylinders.push_back(cylinder);
  world::BoxConfig box;
  box.X_WB = {0, -1, rad(45)};
  box.length_m = box.width_m = 0.2;
  room.boxes.push_back(box);
  const LabTruth truth(room);
  EXPECT_NEAR(truth.distance_m({0, 0, 0}, 0), 2, 1e-12);
  EXPECT_NEAR(truth.distance_m({0, 0, 0}, std::atan2(0.5, 1)), std::hypot(1, 0.5) - 0.1, 1e-12);
  EXPECT_NEAR(truth.distance_m({0, 0, rad(90)}, rad(-180)), 1 - 0.1 * std::sqrt(2.0), 1e-9);
  EXPECT_EQ(truth.distance_m({0, 0, 0}, rad(170)), kInfinity);
}

LabSample sample_of(double truth_m, Answer answer, double said_m, double sigma_m = 0.01) {
  LabSample out;
  out.floor = "wood";
  out.light = "even";
  out.truth_m = out.free_m = truth_m;
  out.reading = {0, answer, said_m, sigma_m};
  out.paper_m = 1.1 * truth_m;
  return out;
}

TEST(LabScore, TheWorstPicturesComeFirst) {
  std::vector<LabSample> samples;
  const auto add = [&](const char* picture, Answer answer, double said_m, int times) {
    for (int i = 0; i < times; ++i) {
      samples.push_back(sample_of(1.0, answer, said_m));
      samples.back().picture = picture;
    }
  };
  add("good", Answer::blocked, 1.0, 9);
  add("one missed", Answer::clear, 2.0, 1);
  add("three imagined", Answer::blocked, 0.5, 3);
  const LabTable worst = worst_pictures(samples, 5);
  ASSERT_EQ(worst.rows.size(), 2u);
  EXPECT_EQ(worst.rows[0].name, "three imagined");
  EXPECT_EQ(worst.rows[1].name, "one missed");
  EXPECT_EQ(worst_pictures(samples, 1).rows.size(), 1u);
}

TEST(LabScore, CountsWhatItsColumnsSay) {
  const std::vector<LabSample> samples = {
      sample_of(1.0, Answer::blocked, 1.01),  // 1 %, inside 1.96 sigma
      sample_of(1.0, Answer::blocked, 1.03),  // 3 %, outside
      sample_of(0.5, Answer::blocked, 0.3),   // imagined
      sample_of(0.5, Answer::clear, 2.0),     // missed
      sample_of(2.5, Answer::clear, 2.4),     // fine
      sample_of(2.5, Answer::blocked, 1.2),   // imagined
      sample_of(2.5, Answer::blocked, 1.9),   // far: not scored
      sample_of(0.8, Answer::not_seen, std::nan("")),
  };
  const LabScore all = score_tables(samples).front().rows.front();
  EXPECT_EQ(all.obstacles, 5);
  EXPECT_EQ(all.free, 3);
  EXPECT_EQ(all.errors, 3);
  EXPECT_NEAR(all.median_error, 0.03, 1e-9);
  EXPECT_NEAR(all.bias, 0.01, 1e-9);
  EXPECT_NEAR(all.missed, 1.0 / 5, 1e-9);
  EXPECT_NEAR(all.imagined, 2.0 / 7, 1e-9);
  EXPECT_NEAR(all.not_seen, 1.0 / 8, 1e-9);
  EXPECT_NEAR(all.within_95, 1.0 / 3, 1e-9);
  EXPECT_NEAR(all.paper_bias, 0.1, 1e-9);
}

TEST(LabPlot, DrawsEachGroupThatHasErrors) {
  std::vector<LabSample> samples(3);
  samples[0].floor = "oak <old>";
  samples[1].floor = samples[2].floor = "rug";
  for (LabSample& sample : samples) {
    sample.light = "noon";
    sample.truth_m = sample.free_m = 1.0;
    sample.reading = {0, Answer::blocked, 1.02, 0.01};
    sample.paper_m = 1.12;
  }
  samples[2].reading.answer = Answer::not_seen;
  const std::string plot = svg_plot(score_tables(samples));
  EXPECT_EQ(plot.substr(0, 5), "<svg ");
  EXPECT_NE(plot.find("</svg>"), std::string::npos);
  EXPECT_NE(plot.find("error, %, by light"), std::string::npos);
  EXPECT_NE(plot.find("oak &lt;old>"), std::string::npos);
  EXPECT_EQ(plot.find("oak <"), std::string::npos);
  EXPECT_EQ(plot.find("nan"), std::string::npos);
  EXPECT_EQ(plot, svg_plot(score_tables(samples)));
  for (LabSample& sample : samples) sample.reading.answer = Answer::not_seen;
  EXPECT_EQ(svg_plot(score_tables(samples)).find("rug"), std::string::npos);
}

TEST(LabRoom, IsTheSameForTheSameSeedAndLeavesRoomToStand) {
  const LabRoom a = lab_room(world::FloorKind::wood, LabLight::side, 7);
  const LabRoom b = lab_room(world::FloorKind::wood, LabLight::side, 7);
  const LabRoom c = lab_room(world::FloorKind::wood, LabLight::side, 8);
  ASSERT_FALSE(a.stands.empty());
  EXPECT_EQ(a.stands.front().x_m, b.stands.front().x_m);
  EXPECT_EQ(a.world.boxes.size(), b.world.boxes.size());
  EXPECT_NE(a.world.bounds.max_x_m, c.world.bounds.max_x_m);
  const LabTruth truth(a.world);
  for (const Pose2& stand : a.stands) {
    for (int bearing_deg = -180; bearing_deg < 180; bearing_deg += 5) {
      EXPECT_GT(truth.distance_m(stand, rad(bearing_deg)), 0.24);
    }
  }
}

class LabFolder : public ::testing::Test {
 protected:
  LabFolder() { std::filesystem::create_directories(folder_); }
  ~LabFolder() override { std::filesystem::remove_all(folder_); }
  void write_truth(const std::string& text) {
    ASSERT_TRUE(write_file_atomically(folder_ / "truth.json", text));
  }

  std::filesystem::path folder_ =
      std::filesystem::path(::testing::TempDir()) /
      ("mirada-lab-" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
};

TEST_F(LabFolder, ARenderedPictureIsScoredAgainstItsTruth) {
  const RobotConfig robot = lab_robot();
  world::WorldConfig room;
  room.floor.kind = world::FloorKind::carpet;
  world::BoxConfig box;
  box.X_WB = {1.0, 0, 0};
  box.length_m = 0.4;
  box.width_m = 0.8;
  box.colour = {30, 40, 160};
  room.boxes.push_back(box);
  world::Renderer renderer(room, robot.camera, 3);
  ASSERT_TRUE(cv::imwrite((folder_ / "a.png").string(), renderer.render(robot.X_RC({}), {}, 1)));
  ASSERT_TRUE(
      write_file_atomically(folder_ / "robot.json", R"({"camera": {"hfov_deg": 62.2, "vfov_deg": 48.8},
      "mount": {"forward_m": 0.05, "height_m": 0.2, "tilt_deg": 22}})"));
  write_truth(R"({"format": "mirada-truth", "version": 1, "robot": "robot.json", "pictures": [
      {"image": "a.png", "floor": "carpet", "light": "even",
       "bearings": [{"bearing_deg": 0, "distance_m": 0.8}, {"bearing_deg": 5, "distance_m": 0.803}]}]})");
  const auto pictures = read_truth(folder_);
  ASSERT_TRUE(pictures) << to_text(pictures.faults(), Lang::en);
  const auto samples = look_at_pictures(*pictures, "mirada-sim", folder_, {});
  ASSERT_TRUE(samples) << to_text(samples.faults(), Lang::en);
  ASSERT_EQ(samples->size(), 2u);
  for (const LabSample& sample : *samples) {
    EXPECT_EQ(sample.reading.answer, Answer::blocked);
    EXPECT_NEAR(sample.reading.distance_m, sample.truth_m, 0.03);
    EXPECT_TRUE(sample.foot_seen);
  }
}

TEST_F(LabFolder, KeptPicturesScoreAsTheyDidWhenTheyWereRendered) {
  LabPlan plan;
  plan.floors = {world::FloorKind::tiles};
  plan.lights = {LabLight::side};
  plan.seeds = 1;
  plan.robot = lab_robot();
  LabKeeper keeper(folder_ / "kept", told_robot(plan));
  const auto rendered = look_at_rooms(plan, {}, [&](const LabShot& shot) { keeper.add(shot); });
  ASSERT_TRUE(keeper.finish());
  const auto pictures = read_truth(folder_ / "kept");
  ASSERT_TRUE(pictures) << to_text(pictures.faults(), Lang::en);
  const auto read = look_at_pictures(*pictures, "", folder_ / "kept", {});
  ASSERT_TRUE(read) << to_text(read.faults(), Lang::en);
  ASSERT_EQ(read->size(), rendered.size());
  const LabScore a = score_tables(rendered).front().rows.front();
  const LabScore b = score_tables(*read).front().rows.front();
  EXPECT_NEAR(a.median_error, b.median_error, 2e-4);
  EXPECT_NEAR(a.missed, b.missed, 0.01);
  EXPECT_NEAR(a.within_95, b.within_95, 0.02);
}

TEST_F(LabFolder, EveryFaultOfTruthJsonComesAtOnce) {
  write_truth(R"({"pictures": [{"image": 5, "pan_deg": 999, "bearings": [{"bearing_deg": 0}]},
      {"image": "b.png", "bearings": []}]})");
  const auto pictures = read_truth(folder_);
  ASSERT_FALSE(pictures);
  const std::string text = to_text(pictures.faults(), Lang::en);
  for (const char* part : {"/pictures/0/image", "/pictures/0/pan_deg", "distance_m (an obstacle) or clear_m",
                           "/pictures/1/bearings is empty"}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
  write_truth(
      R"({"pictures": [{"image": "none.png", "robot": "nobody", "bearings": [{"bearing_deg": 0, "clear_m": 1}]},
      {"image": "none.png", "bearings": [{"bearing_deg": 0, "clear_m": 1}]}]})");
  const auto named = read_truth(folder_);
  ASSERT_TRUE(named) << to_text(named.faults(), Lang::en);
  const auto samples = look_at_pictures(*named, "mirada-sim", folder_, {});
  ASSERT_FALSE(samples);
  EXPECT_THAT(to_text(samples.faults(), Lang::en), HasSubstr("I don't know the robot nobody"));
  EXPECT_THAT(to_text(samples.faults(), Lang::en), HasSubstr("There is no file"));
}

LabScore score_of_room(world::FloorKind floor, LabLight light, std::uint64_t seed) {
  LabPlan plan;
  plan.floors = {floor};
  plan.lights = {light};
  plan.seeds = 1;
  plan.first_seed = seed;
  plan.robot = lab_robot();
  return score_tables(look_at_rooms(plan)).front().rows.front();
}

// A room that the robot first sees in a shade: its lit planks are the same floor.
TEST(LabDistances, AFloorLearntInTheShadeIsKnownInTheSun) {
  const LabScore all = score_of_room(world::FloorKind::wood, LabLight::side, 5000);
  EXPECT_LT(all.imagined, 0.5);
  EXPECT_LT(all.missed, 0.01);
}

TEST(LabDistances, SingleSpotsOfACarpetAreNoObstacles) {
  const LabScore all = score_of_room(world::FloorKind::carpet, LabLight::dim, 31000);
  EXPECT_LT(all.imagined, 0.008);
  EXPECT_LT(all.missed, 0.001);
}

TEST(LabDistances, LinesThatRunOutOfThePictureNearByAreMostlyNoObstacles) {
  EXPECT_LT(score_of_room(world::FloorKind::wood, LabLight::even, 31007).imagined, 0.12);
  EXPECT_LT(score_of_room(world::FloorKind::tiles, LabLight::side, 31006).imagined, 0.03);
}

TEST(LabDistances, ScoresEveryDegreeOfARoomAndIsDeterministic) {
  LabPlan plan;
  plan.floors = {world::FloorKind::carpet};
  plan.lights = {LabLight::even};
  plan.seeds = 1;
  plan.robot = lab_robot();
  std::size_t shots = 0;
  const auto first = look_at_rooms(plan, {}, [&](const LabShot& shot) { shots += !shot.samples.empty(); });
  const auto second = look_at_rooms(plan);
  ASSERT_GT(first.size(), 500u);
  ASSERT_EQ(first.size(), second.size());
  EXPECT_GE(shots, 3u);
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].truth_m, second[i].truth_m);
    EXPECT_EQ(first[i].reading.answer, second[i].reading.answer);
  }
}

}  // namespace
}  // namespace mirada::rig
