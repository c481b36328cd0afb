#include "vision/visual_sonar.h"

#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "scene.h"

namespace mirada::vision {
namespace {

using testing::Box;
using testing::Floor;
using testing::Light;
using testing::Scene;

RobotConfig robot() {
  RobotConfig out;
  out.mount.p_TM_m = {0.05, 0, 0.20};
  out.mount.tilt_rad = rad(22);
  return out;
}

Scene room_with_box(double ahead_m, double left_m) {
  Scene scene;
  scene.room_x_m = scene.room_y_m = 2.2;
  scene.wall_colour = {0.7, 0.6, 0.4};
  scene.boxes.push_back(Box{ahead_m, left_m, 0, 0.2, 0.3, 0.25, {0.1, 0.1, 0.7}});
  return scene;
}

const SonarReading& at(const SonarPercept& percept, int bearing_deg) {
  for (const SonarReading& reading : percept.readings) {
    if (std::lround(deg(reading.bearing_rad)) == bearing_deg) return reading;
  }
  static const SonarReading none;
  ADD_FAILURE() << "no reading at " << bearing_deg;
  return none;
}

SonarPercept look_once(const cv::Mat& bgr, const NeckAngles& neck = {}, const SonarSettings& settings = {}) {
  VisualSonar sonar(robot(), settings);
  return sonar.look(Frame{bgr, 10, 1}, neck, {});
}

void expect_nothing_seen(const SonarPercept& percept) {
  EXPECT_FALSE(percept.floor_model_trusted);
  EXPECT_EQ(percept.readings.size(), 63u);
  for (const SonarReading& reading : percept.readings) EXPECT_EQ(reading.answer, Answer::not_seen);
}

class EveryFloor : public ::testing::TestWithParam<Floor> {};

TEST_P(EveryFloor, ABoxAheadIsReadAtItsTrueDistanceFromTheRobotsOrigin) {
  Scene scene = room_with_box(0.8, 0);
  scene.floor = GetParam();
  scene.floor_colour = {0.2, 0.3, 0.25};
  scene.second_colour = {0.1, 0.15, 0.12};
  const SonarPercept percept = look_once(testing::render(scene, robot(), {}, {}));
  ASSERT_TRUE(percept.floor_model_trusted);
  for (const int bearing_deg : {-8, -4, 0, 4, 8}) {
    const SonarReading& reading = at(percept, bearing_deg);
    ASSERT_EQ(reading.answer, Answer::blocked) << bearing_deg;
    const double truth_m = testing::true_distance_m(scene, {}, rad(bearing_deg));
    EXPECT_NEAR(reading.distance_m, truth_m, 0.02 * truth_m) << bearing_deg;
    EXPECT_GT(reading.sigma_m, 0.002);
    EXPECT_LT(reading.sigma_m, 0.1);
  }
}

INSTANTIATE_TEST_SUITE_P(Floors, EveryFloor,
                         ::testing::Values(Floor::plain, Floor::carpet, Floor::planks, Floor::tiles,
                                           Floor::checker, Floor::terrazzo));

TEST(VisualSonar, PanIsPositiveToTheLeft) {
  const Scene scene = room_with_box(0, 0.8);
  const NeckAngles neck{rad(80), 0};
  const SonarPercept percept = look_once(testing::render(scene, robot(), {}, neck), neck);
  const SonarReading& reading = at(percept, 90);
  ASSERT_EQ(reading.answer, Answer::blocked);
  EXPECT_NEAR(reading.distance_m, testing::true_distance_m(scene, {}, rad(90)), 0.02);
}

TEST(VisualSonar, ClearGoesToTheRangeWhenNothingIsNearer) {
  Scene scene = room_with_box(1.2, 1.2);
  SonarSettings settings;
  settings.range_m = 1.5;
  const SonarPercept percept = look_once(testing::render(scene, robot(), {}, {}), {}, settings);
  EXPECT_EQ(at(percept, 0).answer, Answer::clear);
  EXPECT_NEAR(at(percept, 0).distance_m, 1.55, 0.02);
}

TEST(VisualSonar, AnObstacleWhoseFootIsBelowThePictureBlocksAtTheNearestVisibleGround) {
  Scene scene = room_with_box(0.31, 0.22);
  scene.boxes[0].height_m = 0.6;
  const SonarPercept percept = look_once(testing::render(scene, robot(), {}, {}));
  ASSERT_TRUE(percept.floor_model_trusted);
  const SonarReading& reading = at(percept, 22);
  EXPECT_EQ(reading.answer, Answer::blocked);
  EXPECT_LT(reading.distance_m, 0.34);
}

TEST(VisualSonar, NoseToAWallNothingIsSeen) {
  for (const double wall_m : {0.12, 0.2}) {
    Scene scene;
    scene.room_x_m = wall_m;
    expect_nothing_seen(look_once(testing::render(scene, robot(), {}, {})));
  }
}

TEST(VisualSonar, PicturesThatCannotBeTrustedShowNothing) {
  expect_nothing_seen(look_once(cv::Mat(240, 320, CV_8UC3, cv::Scalar::all(0))));
  expect_nothing_seen(look_once(cv::Mat(240, 320, CV_8UC3, cv::Scalar::all(255))));
  expect_nothing_seen(look_once(cv::Mat(240, 320, CV_8UC3, cv::Scalar::all(128))));
  cv::Mat noise(240, 320, CV_8UC3);
  cv::RNG rng(4);
  rng.fill(noise, cv::RNG::UNIFORM, 0, 256);
  expect_nothing_seen(look_once(noise));
  expect_nothing_seen(look_once(cv::Mat()));
  expect_nothing_seen(look_once(cv::Mat(1, 1, CV_8UC3)));
  expect_nothing_seen(look_once(cv::Mat(240, 240, CV_8UC3, cv::Scalar(90, 120, 80))));
  expect_nothing_seen(look_once(cv::Mat(240, 320, CV_8UC1, cv::Scalar(90))));
}

TEST(VisualSonar, ABadPictureAfterGoodOnesShowsNothingEither) {
  VisualSonar sonar(robot());
  const Scene scene = room_with_box(0.8, 0);
  const cv::Mat good = testing::render(scene, robot(), {}, {});
  EXPECT_TRUE(sonar.look(Frame{good, 0, 1}, {}, {}).floor_model_trusted);
  expect_nothing_seen(sonar.look(Frame{cv::Mat(240, 320, CV_8UC3, cv::Scalar::all(0)), 1, 2}, {}, {}));
  expect_nothing_seen(sonar.look(Frame{cv::Mat(240, 320, CV_8UC3, cv::Scalar::all(255)), 2, 3}, {}, {}));
  EXPECT_TRUE(sonar.look(Frame{good, 3, 4}, {}, {}).floor_model_trusted);
}

TEST(VisualSonar, AFrozenCameraIsNoticedWhenTheRobotMoves) {
  VisualSonar sonar(robot());
  const cv::Mat same = testing::render(room_with_box(0.8, 0), robot(), {}, {});
  EXPECT_TRUE(sonar.look(Frame{same, 0, 1}, {}, {0, 0, 0}).floor_model_trusted);
  EXPECT_TRUE(sonar.look(Frame{same, 1, 2}, {}, {0, 0, 0}).floor_model_trusted);
  expect_nothing_seen(sonar.look(Frame{same, 2, 3}, {}, {0.05, 0, 0}));
}

TEST(VisualSonar, AnObstacleThatIsTakenAwayIsGoneAtOnce) {
  const Scene with_box = room_with_box(0.45, 0);
  Scene without = with_box;
  without.boxes.clear();
  VisualSonar sonar(robot(), {});
  std::uint64_t number = 1;
  Scene scene = with_box;
  const auto look = [&] {
    scene.seed = number;  // other noise
    return sonar.look(
        Frame{testing::render(scene, robot(), {}, {}), static_cast<Micros>(number * 50'000), number++}, {},
        {});
  };
  for (int i = 0; i < 6; ++i) EXPECT_EQ(at(look(), 0).answer, Answer::blocked);
  scene = without;
  EXPECT_GT(at(look(), 0).distance_m, 1.0);
}

cv::Mat exposed(const cv::Mat& bgr, double factor) {
  cv::Mat out;
  bgr.convertTo(out, -1, factor);
  return out;
}

TEST(VisualSonar, ACameraThatSetsItsExposureAnewStillKnowsTheFloor) {
  for (const Floor floor : {Floor::plain, Floor::planks}) {
    for (const double factor : {0.6, 1.35}) {
      Scene scene = room_with_box(0.8, 0);
      scene.floor = floor;
      scene.floor_colour = floor == Floor::planks ? Eigen::Vector3d{0.08, 0.17, 0.3} : scene.floor_colour;
      VisualSonar sonar(robot());
      std::uint64_t number = 1;
      const auto look = [&](double exposure) {
        scene.seed = number;
        const cv::Mat bgr = exposed(testing::render(scene, robot(), {}, {}), exposure);
        return sonar.look(Frame{bgr, static_cast<Micros>(number * 50'000), number++}, {}, {});
      };
      for (int i = 0; i < 3; ++i) look(1);
      for (int i = 0; i < 3; ++i) {
        const SonarPercept percept = look(factor);
        EXPECT_NEAR(at(percept, 0).distance_m, 0.7, 0.03) << factor;
        EXPECT_GT(at(percept, 20).distance_m, 1.2) << factor;
      }
    }
  }
}

TEST(VisualSonar, APictureTwiceTheSizeReadsTheSame) {
  const Scene scene = room_with_box(0.8, 0.1);
  RobotConfig large = robot();
  large.camera = large.camera.scaled_to(640, 480);
  const SonarPercept percept = look_once(testing::render(scene, large, {}, {}));
  ASSERT_EQ(at(percept, 5).answer, Answer::blocked);
  EXPECT_NEAR(at(percept, 5).distance_m, testing::true_distance_m(scene, {}, rad(5)), 0.02);
}

TEST(VisualSonar, ACameraThatLooksUpSeesOnlyAboveTheHorizon) {
  RobotConfig up = robot();
  up.mount.tilt_rad = rad(-40);
  VisualSonar sonar(up);
  const SonarPercept percept =
      sonar.look(Frame{testing::render(room_with_box(0.8, 0), up, {}, {}), 0, 1}, {}, {});
  EXPECT_EQ(at(percept, 0).answer, Answer::above_horizon);
  EXPECT_TRUE(std::isnan(at(percept, 0).distance_m));
}

TEST(VisualSonar, ASheetInTheFloorsColourOnAWallIsNoWayThrough) {
  Scene scene;
  scene.floor_colour = {0.6, 0.6, 0.6};
  scene.wall_colour = {0.06, 0.08, 0.2};
  scene.room_x_m = 0.8;
  scene.boxes.push_back(Box{0.798, 0, 0, 0.004, 0.19, 0.21, {0.6, 0.6, 0.6}, 0.02});
  VisualSonar sonar(robot(), {});
  for (std::uint64_t number = 1; number <= 3; ++number) {  // the floor unknown, then known
    scene.seed = number;
    const Frame frame{testing::render(scene, robot(), {}, {}), static_cast<Micros>(number), number};
    const SonarPercept percept = sonar.look(frame, {}, {});
    for (const int bearing_deg : {-4, 0, 4}) {
      const SonarReading& reading = at(percept, bearing_deg);
      EXPECT_EQ(reading.answer, Answer::blocked) << bearing_deg << " in picture " << number;
      EXPECT_NEAR(reading.distance_m, 0.8 / std::cos(rad(bearing_deg)), 0.04) << bearing_deg;
    }
  }
}

TEST(VisualSonar, ASkirtingBoardInNearlyTheFloorsLookIsTheFootOfTheWall) {
  for (const double grey : {0.36, 0.37}) {
    Scene scene;
    scene.floor_colour = {0.4, 0.4, 0.4};
    scene.wall_colour = {0.1, 0.25, 0.15};
    scene.room_x_m = 0.8;
    scene.boxes.push_back(Box{0.795, 0, 0, 0.01, 3.9, 0.05, {grey, grey, grey}});
    const SonarPercept percept = look_once(testing::render(scene, robot(), {}, {}));
    for (const int bearing_deg : {-20, 0, 20}) {
      EXPECT_NEAR(at(percept, bearing_deg).distance_m, 0.79 / std::cos(rad(bearing_deg)), 0.03)
          << bearing_deg << ", grey " << grey;
    }
  }
}

TEST(VisualSonar, TheNextRowOfTilesIsNoSkirtingBoard) {
  Scene scene;
  scene.floor_colour = {0.4, 0.4, 0.4};
  scene.wall_colour = {0.1, 0.25, 0.15};
  scene.room_x_m = 0.8;
  cv::Mat bgr = testing::render(scene, robot(), {}, {});
  // The rows from the wall's foot to 0.55 m are one row of tiles, a little darker; tiles vary side by side.
  constexpr int kFootRow = 87, kNextRow = 120;
  for (int v = kFootRow; v < bgr.rows; ++v) {
    for (int u = 0; u < bgr.cols; ++u) {
      const int tile = (u / 23 * 7) % 4 - 2;
      bgr.at<cv::Vec3b>(v, u) += cv::Vec3b::all(static_cast<uchar>(20 + 3 * tile - (v < kNextRow ? 12 : 0)));
    }
  }
  const SonarPercept percept = look_once(bgr);
  for (const int bearing_deg : {-10, 0, 10})
    EXPECT_NEAR(at(percept, bearing_deg).distance_m, 0.8 / std::cos(rad(bearing_deg)), 0.05) << bearing_deg;
}

TEST(VisualSonar, APaintedLineIsAnObstacleOnlyWhenAskedFor) {
  Scene scene;
  scene.floor = Floor::field;
  scene.floor_colour = {0.06, 0.22, 0.05};
  scene.wall_colour = {0.3, 0.2, 0.6};
  const Pose2 X_WR{-0.7, 0, 0};  // lines at 0.1 m (the circle, below the picture) and 0.7 m ahead
  const cv::Mat bgr = testing::render(scene, robot(), X_WR, {});
  EXPECT_GT(at(look_once(bgr), 0).distance_m, 1.4);
  SonarSettings settings;
  settings.lines_are_obstacles = true;
  EXPECT_NEAR(at(look_once(bgr, {}, settings), 0).distance_m, 0.675, 0.03);
  RobotConfig on_a_field = robot();
  on_a_field.lines_are_obstacles = true;
  VisualSonar sonar(on_a_field);
  EXPECT_NEAR(at(sonar.look(Frame{bgr, 10, 1}, {}, {}), 0).distance_m, 0.675, 0.03);
}

TEST(VisualSonar, ALargePatchThatLiesFlatIsFloor) {
  Scene scene;
  scene.floor_colour = {0.5, 0.5, 0.45};
  scene.wall_colour = {0.7, 0.6, 0.4};
  scene.room_x_m = scene.room_y_m = 2.2;
  scene.boxes.push_back(Box{0.62, 0, rad(45), 0.35, 0.35, 0.0005, {0.5, 0.2, 0.1}});
  EXPECT_GT(at(look_once(testing::render(scene, robot(), {}, {})), 0).distance_m, 1.5);
}

TEST(VisualSonar, AFieldLineCutOffByThePictureIsNoObstacleWhileDriving) {
  Scene scene;
  scene.floor = Floor::field;
  scene.floor_colour = {0.06, 0.22, 0.05};
  scene.wall_colour = {0.3, 0.2, 0.6};
  VisualSonar sonar(robot());
  for (std::uint64_t number = 1; number <= 3; ++number) {
    const Pose2 X_WR{-0.9 + 0.2 * static_cast<double>(number), 1.2, rad(20)};
    scene.seed = number;
    const Frame frame{testing::render(scene, robot(), X_WR, {}), static_cast<Micros>(number), number};
    const SonarPercept percept = sonar.look(frame, {}, X_WR);
    for (const int bearing_deg : {-15, 0, 15})
      EXPECT_GT(at(percept, bearing_deg).distance_m, 1.0) << bearing_deg << " in picture " << number;
  }
}

TEST(VisualSonar, ABoxInTheFloorsColourWhereALineGoesOnIsNoPartOfTheLine) {
  Scene scene = room_with_box(0.8, 0);
  scene.floor_colour = {0.3, 0.3, 0.3};
  scene.boxes[0] = Box{0.75, 0, 0, 0.2, 0.3, 0.05, {0.22, 0.22, 0.22}};
  for (const double left_m : {0.55, -0.55})
    scene.boxes.push_back(Box{0.67, left_m, 0, 0.05, 0.8, 0.0005, {0.03, 0.03, 0.4}});
  const SonarPercept percept = look_once(testing::render(scene, robot(), {}, {}));
  for (const int bearing_deg : {-8, 0, 8}) EXPECT_NEAR(at(percept, bearing_deg).distance_m, 0.65, 0.04);
  for (const int bearing_deg : {-25, 25}) EXPECT_GT(at(percept, bearing_deg).distance_m, 1.5);
}

TEST(VisualSonar, ALineThatThePicturesFootCutsOffIsNoObstacleWhileDriving) {
  Scene scene = room_with_box(1.8, 0);
  scene.floor_colour = {0.06, 0.22, 0.05};
  VisualSonar sonar(robot());
  for (std::uint64_t number = 1; number <= 4; ++number) {
    scene.seed = number;
    const Pose2 X_WR{0.1 * static_cast<double>(number), 0, 0};
    if (number == 4) scene.boxes.push_back(Box{0.66, 0, rad(68), 1.6, 0.05, 0.0005, {0.02, 0.5, 0.6}});
    const Frame frame{testing::render(scene, robot(), X_WR, {}), static_cast<Micros>(number), number};
    const SonarPercept percept = sonar.look(frame, {}, X_WR);
    for (const int bearing_deg : {-15, -8, 0, 8, 15})
      EXPECT_GT(at(percept, bearing_deg).distance_m, 1.0) << bearing_deg << " in picture " << number;
  }
}

TEST(VisualSonar, ThePapersMethodFindsItsGreenBorder) {
  Scene scene = room_with_box(0.8, 0);
  scene.boxes[0].colour = {0.05, 0.4, 0.1};
  SonarSettings settings;
  settings.floor = SonarSettings::Floor::fixed_colour;
  const SonarPercept percept = look_once(testing::render(scene, robot(), {}, {}), {}, settings);
  ASSERT_EQ(at(percept, 0).answer, Answer::blocked);
  EXPECT_NEAR(at(percept, 0).distance_m, 0.7, 0.02);
  EXPECT_EQ(at(percept, 25).answer, Answer::clear);
}

TEST(VisualSonar, ForgettingLetsANewFloorBeLearnt) {
  VisualSonar sonar(robot());
  Scene red = room_with_box(0.8, 0);
  red.floor_colour = {0.05, 0.05, 0.5};
  Scene blue = room_with_box(0.6, 0);
  blue.floor_colour = {0.5, 0.1, 0.05};
  EXPECT_NEAR(at(sonar.look(Frame{testing::render(red, robot(), {}, {}), 0, 1}, {}, {}), 0).distance_m, 0.7,
              0.02);
  const Frame second{testing::render(blue, robot(), {}, {}), 1, 2};
  EXPECT_LT(at(sonar.look(second, {}, {}), 0).distance_m, 0.3);  // not the floor it knows: blocked, not clear
  sonar.forget();
  EXPECT_NEAR(at(sonar.look(second, {}, {}), 0).distance_m, 0.5, 0.02);
}

TEST(VisualSonar, CarriesTheFramesNumberTimeAndPose) {
  VisualSonar sonar(robot());
  const SonarPercept percept = sonar.look(
      Frame{testing::render(room_with_box(0.8, 0), robot(), {}, {0.1, 0}), 77, 9}, {0.1, 0}, {1, 2, 3});
  EXPECT_EQ(percept.frame, 9u);
  EXPECT_EQ(percept.t_exposure, 77);
  EXPECT_EQ(percept.neck.pan_rad, 0.1);
  EXPECT_EQ(percept.X_OR.y_m, 2);
  EXPECT_GT(percept.boundary.size(), 60u);
}

}  // namespace
}  // namespace mirada::vision
