#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "base/files.h"
#include "base/units.h"
#include "model/camera_file.h"
#include "rig/calibration/calibration_work.h"
#include "rig/calibration/kept_camera.h"
#include "world/render/renderer.h"

namespace mirada::rig {
namespace {

namespace fs = std::filesystem;
using session::Calibration;
using ::testing::HasSubstr;

/// OpenCV keeps to the caller's thread from here on: ThreadSanitizer cannot see how its own pool keeps order.
world::WorldConfig plain_room() {
  cv::setNumThreads(1);
  world::WorldConfig out;
  out.bounds = {-3, -2, 3, 2};
  out.noise.sensor = 2;
  return out;
}

CameraModel bent_camera() {
  CameraModel camera;
  camera.fx_px = 262;
  camera.fy_px = 262.5;
  camera.cx_px = 162;
  camera.distortion = {-0.08, 0.03, 0, 0, 0};
  return camera;
}

/// A simulated camera before which the wizard's hand holds its board.
struct Studio {
  explicit Studio(const CameraModel& camera) : renderer(plain_room(), camera, 4) {
    X_WC.translation().z() = 1;
    X_WC.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  }
  Frame picture() {
    const world::HeldBoard* shown = held ? &*held : nullptr;
    ++number;
    return {renderer.render(X_WC, {}, static_cast<std::int64_t>(number), shown), 0, number};
  }

  world::Renderer renderer;
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  std::optional<world::HeldBoard> held;
  std::uint64_t number = 0;
};

CalibrationJob job_for(const session::CalibrationPlan& plan, Studio& studio) {
  // The robot's file only guesses: a pinhole, 6 % off.
  CameraModel guess;
  guess.fx_px = guess.fy_px = 278;
  CalibrationJob job = *read_plan(plan, guess);
  job.hold = [&studio](std::optional<world::HeldBoard> board) { studio.held = std::move(board); };
  return job;
}

TEST(CalibrationWork, TheRoomsHandShowsTheBoardUntilTheLensIsKnown) {
  const CameraModel truth = bent_camera();
  Studio studio(truth);
  {
    CalibrationWork work(job_for({}, studio));
    Calibration state = work.look(studio.picture(), false);
    EXPECT_EQ(state.phase, Calibration::Phase::looking);
    EXPECT_EQ(state.now->code(), "board_not_seen");
    EXPECT_EQ(state.next->code(), "hold_middle");
    for (int i = 0; i < 400 && !work.enough(); ++i) state = work.look(studio.picture(), false);
    ASSERT_TRUE(work.enough()) << state.views << " views";
    EXPECT_EQ(state.taken.size(), state.views);
    const Calibration solved = work.solve();
    ASSERT_EQ(solved.phase, Calibration::Phase::ready) << to_text(solved.words, Lang::en);
    EXPECT_LT(solved.rms_px, 0.15);
    const auto read = read_camera_file(work.camera_json(), "camera.json");
    ASSERT_TRUE(read) << to_text(read.faults(), Lang::en);
    EXPECT_NEAR(read->fx_px, truth.fx_px, 0.005 * truth.fx_px);
    EXPECT_NEAR(read->cx_px, truth.cx_px, 1);
    EXPECT_NEAR(read->distortion[0], truth.distortion[0], 0.02);
  }
  EXPECT_FALSE(studio.held.has_value()) << "the hand puts the board away";
}

TEST(CalibrationWork, AHeldCharucoBoardIsFoundWhereTheLensPutsIt) {
  const CameraModel truth = bent_camera();
  Studio studio(truth);
  session::CalibrationPlan plan;
  plan.charuco = true;
  plan.size = "7x5";
  plan.square_mm = 30;
  const vision::BoardSpec board = read_plan(plan, truth)->board;
  vision::BoardFinder finder(board);
  BoardHand hand(board, [&](std::optional<world::HeldBoard> shown) { studio.held = std::move(shown); });
  for (const double right_near_deg : {0.0, 25.0}) {
    const auto X_CB = vision::pose_for({0.4, 0.5, 0.8, 0, rad(right_near_deg)}, board, truth);
    for (int i = 0; i < 30; ++i) hand.step(*X_CB);
    cv::Mat gray;
    cv::cvtColor(studio.picture().bgr, gray, cv::COLOR_BGR2GRAY);
    const auto found = finder.find(gray, "p");
    ASSERT_TRUE(found) << to_text(found.faults(), Lang::en);
    double sum = 0;
    for (std::size_t i = 0; i < found->corners_px.size(); ++i) {
      const cv::Point3f p = found->corners_B_m[i];
      const auto pixel = truth.project(*X_CB * Eigen::Vector3d(p.x, p.y, p.z));
      sum += (*pixel - Eigen::Vector2d(found->corners_px[i].x, found->corners_px[i].y)).squaredNorm();
    }
    EXPECT_LT(std::sqrt(sum / static_cast<double>(found->corners_px.size())), 0.2);
  }
}

TEST(CalibrationWork, EveryFaultOfAPlanAtOnce) {
  session::CalibrationPlan plan;
  plan.size = "2x99";
  plan.square_mm = 0;
  plan.camera = "kodak";
  const auto job = read_plan(plan, CameraModel());
  ASSERT_FALSE(job);
  EXPECT_EQ(job.faults().size(), 3u);
}

TEST(CalibrationWork, PicturesOfAnotherSizeBeginAnew) {
  Studio studio(bent_camera());
  CalibrationWork work(*read_plan({}, bent_camera()));
  work.look(studio.picture(), false);
  Frame other;
  other.bgr = cv::Mat(480, 640, CV_8UC3, cv::Scalar::all(90));
  const Calibration state = work.look(other, true);
  EXPECT_EQ(state.now->code(), "guide_size_changed");
  EXPECT_EQ(state.width_px, 640);
}

class KeptCamera : public ::testing::Test {
 protected:
  KeptCamera() : folder(fs::path(::testing::TempDir()) / ("kept-" + std::to_string(::getpid()))) {
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  ~KeptCamera() override { fs::remove_all(folder); }
  static std::string camera_text(int height, const std::string& name = "") {
    return R"({"format":"mirada-camera","version":1,"name":")" + name + R"(","width_px":640,"height_px":)" +
           std::to_string(height) + R"(,"fx_px":500})";
  }
  void write(const std::string& name, const std::string& text) { std::ofstream(folder / name) << text; }

  fs::path folder;
};

TEST_F(KeptCamera, TheOldFileStaysUnderAnotherName) {
  const fs::path file = folder / "new/bot.camera.json";
  EXPECT_FALSE(keep_camera(file, "one").value().has_value());
  const auto second = keep_camera(file, "two").value();
  const auto third = keep_camera(file, "three").value();
  ASSERT_TRUE(second && third);
  EXPECT_EQ(*read_file(file), "three");
  EXPECT_EQ(*read_file(*second), "one");
  EXPECT_EQ(*read_file(*third), "two");
}

TEST_F(KeptCamera, IsUsedWhenItFitsAndElseSaysWhyNot) {
  RobotConfig robot;
  write("a.json", camera_text(480));
  ASSERT_TRUE(use_kept_camera(folder / "a.json", robot));
  EXPECT_DOUBLE_EQ(robot.camera.fx_px, 250);  // scaled to the robot's 320x240
  EXPECT_TRUE(use_kept_camera(folder / "none.json", robot));

  write("wide.json", camera_text(360));
  EXPECT_THAT(to_text(use_kept_camera(folder / "wide.json", robot).faults(), Lang::en), HasSubstr("640x360"));
  robot.camera.name = "Mine";
  write("other.json", camera_text(480, "Yours"));
  EXPECT_THAT(to_text(use_kept_camera(folder / "other.json", robot).faults(), Lang::en),
              HasSubstr("a Yours"));
  write("half.json", R"({"format":"mirada-camera")");
  EXPECT_FALSE(use_kept_camera(folder / "half.json", robot));
  EXPECT_DOUBLE_EQ(robot.camera.fx_px, 250);
}

TEST_F(KeptCamera, StandsWhereTheRobotLooksForIt) {
  write("bot.json", R"({"camera": {"calibration": "lens.json"}})");
  write("plain.json", R"({"camera": {"hfov_deg": 60}})");
  EXPECT_EQ(kept_camera_file((folder / "bot.json").string(), false), folder / "lens.json");
  EXPECT_EQ(kept_camera_file((folder / "bot.json").string(), true), folder / "bot.simulated.camera.json");
  EXPECT_EQ(kept_camera_file((folder / "plain.json").string(), false), folder / "plain.camera.json");
  EXPECT_THAT(kept_camera_file("mirada-sim", true).string(),
              HasSubstr("mirada/cameras/mirada-sim.simulated"));
}

}  // namespace
}  // namespace mirada::rig
