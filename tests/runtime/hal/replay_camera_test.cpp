#include "hal/replay/replay_camera.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

#include "camera_contract.h"

namespace mirada::hal {
namespace {

namespace fs = std::filesystem;

/// A folder of its own with some grey pictures 01.png, 02.png ... whose brightness is their number times ten.
struct Pictures {
  explicit Pictures(int count) {
    static int made = 0;
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string("replay_") + test->name() + std::to_string(++made);
    for (char& c : name) c = c == '/' ? '_' : c;
    folder = fs::path(testing::TempDir()) /
             (name + std::to_string(::testing::UnitTest::GetInstance()->random_seed()));
    fs::remove_all(folder);
    fs::create_directories(folder);
    for (int i = 1; i <= count; ++i) add(std::to_string(100 + i) + ".png", i * 10);
  }
  ~Pictures() { fs::remove_all(folder); }
  Pictures(const Pictures&) = delete;
  Pictures& operator=(const Pictures&) = delete;

  void add(const std::string& name, int grey) const {
    cv::imwrite((folder / name).string(), cv::Mat(48, 64, CV_8UC3, cv::Scalar::all(grey)));
  }
  void add_text(const std::string& name) const { std::ofstream(folder / name) << "no picture"; }

  fs::path folder;
};

int grey(const std::optional<Frame>& frame) { return frame ? frame->bgr.at<cv::Vec3b>(0, 0)[0] : -1; }

}  // namespace

CameraUnderTest make_replay() {
  struct Keeps {
    Pictures pictures{4};
    ManualClock clock;
    std::unique_ptr<Camera> camera;
  };
  auto keeps = std::make_shared<Keeps>();
  keeps->camera =
      std::move(open_replay(keeps->pictures.folder, keeps->clock, {.fps = 20, .loop = true})).value();
  return {keeps, keeps->camera.get(), [k = keeps.get()] { k->clock.advance(50 * kMillisecond); },
          [k = keeps.get()] { return k->clock.now(); }};
}

namespace {

TEST(ReplayCamera, ShowsAFolderInTheOrderOfNamesAtItsPace) {
  const Pictures pictures(3);
  ManualClock clock;
  auto camera = std::move(open_replay(pictures.folder, clock, {.fps = 10, .loop = true})).value();
  camera->enable(true);
  std::vector<int> seen;
  for (int i = 0; i < 8; ++i) {
    seen.push_back(grey(camera->poll()));
    clock.advance(50 * kMillisecond);
  }
  EXPECT_THAT(seen, testing::ElementsAre(10, -1, 20, -1, 30, -1, 10, -1));
}

TEST(ReplayCamera, EndsWithAWordWhenItDoesNotLoop) {
  const Pictures pictures(2);
  ManualClock clock;
  auto camera = std::move(open_replay(pictures.folder, clock, {.fps = 10, .loop = false})).value();
  camera->enable(true);
  EXPECT_EQ(grey(camera->poll()), 10);
  clock.advance(100 * kMillisecond);
  EXPECT_EQ(grey(camera->poll()), 20);
  EXPECT_TRUE(camera->health());
  clock.advance(100 * kMillisecond);
  EXPECT_FALSE(camera->poll());
  ASSERT_FALSE(camera->health());
  EXPECT_EQ(camera->health().faults()[0].code(), "replay_ended");
}

TEST(ReplayCamera, AReaderThatComesLateAtTheEndStillGetsTheLastPicture) {
  const Pictures pictures(3);
  ManualClock clock;
  auto camera = std::move(open_replay(pictures.folder, clock, {.fps = 10, .loop = false})).value();
  camera->enable(true);
  clock.advance(kSecond);
  EXPECT_EQ(grey(camera->poll()), 30);
  EXPECT_FALSE(camera->poll());
}

TEST(ReplayCamera, StandsStillWhileItIsDisabled) {
  const Pictures pictures(3);
  ManualClock clock;
  auto camera = std::move(open_replay(pictures.folder, clock, {.fps = 10, .loop = true})).value();
  camera->enable(true);
  EXPECT_EQ(grey(camera->poll()), 10);
  camera->enable(false);
  clock.advance(10 * kSecond);
  camera->enable(true);
  EXPECT_EQ(grey(camera->poll()), 20);
}

TEST(ReplayCamera, PassesOverABrokenPictureAndSaysSo) {
  const Pictures pictures(1);
  pictures.add_text("102.png");
  pictures.add("103.png", 77);
  ManualClock clock;
  auto camera = std::move(open_replay(pictures.folder, clock, {.fps = 10, .loop = true})).value();
  camera->enable(true);
  EXPECT_EQ(grey(camera->poll()), 10);
  clock.advance(100 * kMillisecond);
  EXPECT_FALSE(camera->poll());
  EXPECT_FALSE(camera->health());
  clock.advance(100 * kMillisecond);
  EXPECT_EQ(grey(camera->poll()), 77);
  EXPECT_TRUE(camera->health());
}

TEST(ReplayCamera, RefusesWhatIsNoPicture) {
  const Pictures pictures(0);
  pictures.add_text("text.png");
  ManualClock clock;
  const auto code = [&](const fs::path& path) { return open_replay(path, clock).faults()[0].code(); };
  EXPECT_EQ(code(pictures.folder / "text.png"), "picture_broken");
  EXPECT_EQ(code(pictures.folder), "picture_broken");
  EXPECT_EQ(code(pictures.folder / "none.png"), "file_missing");
  fs::remove(pictures.folder / "text.png");
  EXPECT_EQ(code(pictures.folder), "pictures_missing");
}

TEST(ReplayCamera, PlaysAVideoAtItsOwnPaceRoundAndRound) {
  const fs::path file = "/usr/share/doc/opencv-doc/examples/data/vtest.avi";
  if (!fs::exists(file)) GTEST_SKIP() << "package opencv-doc is not installed";
  ManualClock clock;
  auto camera = std::move(open_replay(file, clock)).value();
  camera->enable(true);
  int frames = 0;
  for (int i = 0; i < 20; ++i) {
    frames += camera->poll() ? 1 : 0;
    clock.advance(100 * kMillisecond);
  }
  EXPECT_EQ(frames, 20) << "it has 10 pictures a second";
}

}  // namespace
}  // namespace mirada::hal
