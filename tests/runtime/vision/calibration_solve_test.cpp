#include <functional>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/random.h"
#include "base/units.h"
#include "vision/calibration/judge.h"
#include "vision/calibration/solve.h"

namespace mirada::vision {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

CameraModel truth(CameraModel::Lens lens) {
  CameraModel camera;
  camera.width_px = 640;
  camera.height_px = 480;
  camera.fx_px = lens == CameraModel::Lens::brown ? 530 : 290;
  camera.fy_px = camera.fx_px * 1.002;
  camera.cx_px = 325;
  camera.cy_px = 236;
  camera.lens = lens;
  if (lens == CameraModel::Lens::brown) camera.distortion = {-0.12, 0.05, 0.001, -0.0005, 0};
  if (lens == CameraModel::Lens::fisheye) camera.distortion = {0.02, -0.01, 0.002, 0, 0};
  return camera;
}

/// A board whose middle is seen at a pixel, turned about its own axes.
BoardView view_of(const CameraModel& camera, const Eigen::Vector2d& pixel, double distance_m,
                  double tilt_x_deg, double tilt_y_deg, Random& random, double noise_px = 0.1) {
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  const BoardSpec board = *chessboard_spec("9x6", 25);
  const Eigen::Matrix3d R =
      (AngleAxisd(rad(tilt_x_deg), Vector3d::UnitX()) * AngleAxisd(rad(tilt_y_deg), Vector3d::UnitY()))
          .toRotationMatrix();
  const Vector3d middle = camera.unproject(pixel)->normalized() * distance_m;
  BoardView view;
  view.image = "v" + std::to_string(random.next() % 100000);
  view.size_px = {camera.width_px, camera.height_px};
  for (int i = 0; i < board.corner_count(); ++i) {
    const cv::Point3f p = board.corner_B_m(i);
    const Vector3d p_C = middle + R * Vector3d(p.x - 0.1, p.y - 0.0625, 0);
    const auto seen = camera.project(p_C);
    if (!seen) continue;
    view.corners_px.emplace_back(static_cast<float>(seen->x() + noise_px * random.gaussian()),
                                 static_cast<float>(seen->y() + noise_px * random.gaussian()));
    view.corners_B_m.push_back(p);
  }
  return view;
}

std::vector<BoardView> good_set(const CameraModel& camera, double distance_m) {
  Random random(3, "views");
  std::vector<BoardView> out;
  const double tilts[][2] = {{0, 0},   {30, 0},   {-30, 5},  {0, 30},   {5, -30},
                             {20, 20}, {-20, 20}, {25, -15}, {-15, -25}};
  for (int i = 0; i < 9; ++i) {
    const Eigen::Vector2d pixel(170 + 150 * (i % 3), 140 + 100 * (i / 3));
    out.push_back(view_of(camera, pixel, distance_m, tilts[i][0], tilts[i][1], random));
  }
  return out;
}

TEST(Solve, FindsTheLensThatMadeTheViews) {
  const CameraModel camera = truth(CameraModel::Lens::brown);
  const auto found = solve(good_set(camera, 0.45), LensChoice::automatic);
  ASSERT_TRUE(found) << to_text(found.faults(), Lang::en);
  EXPECT_EQ(found->camera.lens, CameraModel::Lens::brown);
  EXPECT_NEAR(found->camera.fx_px, camera.fx_px, 4 * found->sigma_fx_px);
  EXPECT_NEAR(found->camera.cx_px, camera.cx_px, 4 * found->sigma_cx_px);
  EXPECT_LT(found->sigma_fx_px, 2);
  EXPECT_NEAR(found->rms_px, 0.141, 0.02);
  EXPECT_THAT(to_text(distrust(*found), Lang::en), IsEmpty());
}

TEST(Solve, TakesTheFisheyeModelForAWideLens) {
  const CameraModel camera = truth(CameraModel::Lens::fisheye);
  const auto found = solve(good_set(camera, 0.22), LensChoice::automatic);
  ASSERT_TRUE(found) << to_text(found.faults(), Lang::en);
  EXPECT_EQ(found->camera.lens, CameraModel::Lens::fisheye);
  EXPECT_NEAR(found->camera.fx_px, camera.fx_px, 4 * found->sigma_fx_px);
  EXPECT_GT(found->sigma_fx_px, 0.01);
  EXPECT_GT(found->seen_hfov_rad, rad(110));
}

TEST(Solve, AFlatSetIsNotTrusted) {
  const CameraModel camera = truth(CameraModel::Lens::brown);
  Random random(5, "flat");
  std::vector<BoardView> views;
  for (int i = 0; i < 9; ++i) {
    views.push_back(view_of(camera, {170.0 + 150 * (i % 3), 140.0 + 100 * (i / 3)}, 0.45, 2, -2, random));
  }
  const auto found = solve(views, LensChoice::brown);
  ASSERT_TRUE(found);
  EXPECT_THAT(to_text(distrust(*found), Lang::en), HasSubstr("held almost the same way"));
}

TEST(Solve, AFewViewsInOneCornerAreNotTrustedForBothReasons) {
  const CameraModel camera = truth(CameraModel::Lens::brown);
  Random random(5, "corner");
  std::vector<BoardView> views;
  for (int i = 0; i < 4; ++i) views.push_back(view_of(camera, {110, 90}, 0.6, 10 * i, -10 * i, random));
  const auto found = solve(views, LensChoice::brown);
  ASSERT_TRUE(found);
  const std::string text = to_text(distrust(*found), Lang::en);
  EXPECT_THAT(text, HasSubstr("4 usable pictures are too few"));
  EXPECT_THAT(text, HasSubstr("35 % are needed"));
}

TEST(Solve, ABentBoardAndARepeatedViewAreLeftOutAndNamed) {
  const CameraModel camera = truth(CameraModel::Lens::brown);
  auto views = good_set(camera, 0.45);
  views[4].image = "bent.jpg";
  for (std::size_t i = 0; i < views[4].corners_px.size(); ++i) {
    views[4].corners_px[i].y += 4 * std::sin(static_cast<float>(i % 9) / 3);
  }
  views.push_back(views[2]);
  views.back().image = "again.jpg";
  const auto found = solve(views, LensChoice::brown);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->views.size(), 8u);
  const std::string text = to_text(found->refused, Lang::en);
  EXPECT_THAT(text, HasSubstr("bent.jpg: The corners miss a flat board"));
  EXPECT_THAT(text, HasSubstr("again.jpg: The board is where it was in"));
  EXPECT_NEAR(found->camera.fx_px, camera.fx_px, 4 * found->sigma_fx_px);
}

/// The same views of a print that is not what it should be.
std::vector<BoardView> set_of_print(const std::function<Eigen::Vector3d(const cv::Point3f&)>& print) {
  const CameraModel camera = truth(CameraModel::Lens::brown);
  std::vector<BoardView> views = good_set(camera, 0.45);
  Random random(5, "print");
  const double tilts[][3] = {{0, 0, 0},    {30, 0, 40},   {-30, 5, 90}, {0, 30, 10},   {5, -30, 75},
                             {20, 20, 30}, {-20, 20, 85}, {25, -15, 0}, {-15, -25, 50}};
  for (std::size_t v = 0; v < views.size(); ++v) {
    using Eigen::AngleAxisd;
    using Eigen::Vector3d;
    const Eigen::Matrix3d R =
        (AngleAxisd(rad(tilts[v][0]), Vector3d::UnitX()) * AngleAxisd(rad(tilts[v][1]), Vector3d::UnitY()) *
         AngleAxisd(rad(tilts[v][2]), Vector3d::UnitZ()))
            .toRotationMatrix();
    const Eigen::Vector2d pixel(170 + 150.0 * static_cast<double>(v % 3),
                                140 + 100.0 * static_cast<double>(v / 3));
    const Vector3d middle = camera.unproject(pixel)->normalized() * 0.45;
    for (std::size_t i = 0; i < views[v].corners_px.size(); ++i) {
      const Vector3d p = print(views[v].corners_B_m[i]) - Vector3d(0.1, 0.0625, 0);
      const auto seen = camera.project(middle + R * p);
      views[v].corners_px[i] = {static_cast<float>(seen->x() + 0.1 * random.gaussian()),
                                static_cast<float>(seen->y() + 0.1 * random.gaussian())};
    }
  }
  return views;
}

TEST(Solve, AFlatSquarePrintIsFoundFlatAndSquare) {
  const auto found = solve(set_of_print([](const cv::Point3f& p) { return Eigen::Vector3d(p.x, p.y, 0); }),
                           LensChoice::brown);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->board.stretch, 1, 4 * found->board.sigma_stretch);
  EXPECT_LT(found->board.sigma_stretch, 0.003);
  EXPECT_LT(found->board.bend_m, 0.0008);
  EXPECT_THAT(to_text(distrust(*found), Lang::en), IsEmpty());
}

TEST(Solve, ABoardOnAStretchedScreenIsRefused) {
  const auto found =
      solve(set_of_print([](const cv::Point3f& p) { return Eigen::Vector3d(1.04 * p.x, p.y, 0); }),
            LensChoice::brown);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->board.stretch, 1.04, 0.01);
  EXPECT_THAT(to_text(distrust(*found), Lang::en), HasSubstr("% wider than high"));
}

TEST(Solve, ABentBoardIsSaidToBeBent) {
  for (const double bend_m : {0.004, -0.004}) {
    const auto print = [&](const cv::Point3f& p) {
      const double x = p.x / 0.1 - 1;
      return Eigen::Vector3d(p.x, p.y, bend_m * x * x);
    };
    const auto found = solve(set_of_print(print), LensChoice::brown);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->board.bend_m, 0.004, 0.0015);
    EXPECT_THAT(to_text(distrust(*found), Lang::en), HasSubstr("The board is bent by about"));
  }
}

TEST(Solve, TooFewViewsAreRefusedInWords) {
  const auto found = solve({}, LensChoice::brown);
  ASSERT_FALSE(found);
  EXPECT_THAT(to_text(found.faults(), Lang::en), HasSubstr("0 usable pictures are too few; 6 are needed"));
}

TEST(Datasheet, TellsThePapersMistake) {
  Calibration paper;
  paper.camera.fx_px = 313.9;
  paper.camera.fy_px = 316.6;
  const auto v1 = camera_preset("pi-camera-v1");
  const auto v2 = camera_preset("pi-camera-v2");
  ASSERT_TRUE(v1 && v2);
  EXPECT_THAT(check_datasheet(paper, *v1, {*v1, *v2}), IsEmpty());
  const std::string text = to_text(check_datasheet(paper, *v2, {*v1, *v2}), Lang::en);
  EXPECT_THAT(text, HasSubstr("sees 54 degrees across, but a Raspberry Pi camera v2.1 sees 62.2"));
  EXPECT_THAT(text, HasSubstr("Raspberry Pi camera v1's view: is it that camera?"));
  paper.camera.width_px = 240;
  EXPECT_FALSE(has_errors(check_datasheet(paper, *v2, {})));
}

}  // namespace
}  // namespace mirada::vision
