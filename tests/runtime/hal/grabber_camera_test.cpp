#include "hal/v4l2/grabber_camera.h"

#include <condition_variable>
#include <filesystem>
#include <mutex>

#include <gmock/gmock.h>

#include "camera_contract.h"
#include "hal/v4l2/v4l2_camera.h"

namespace mirada::hal {
namespace {

/// A device whose pictures the test hands out; it can be pulled out and put back.
class ScriptedDevice final : public CaptureDevice {
 public:
  struct State {
    std::mutex mutex;
    std::condition_variable changed;
    bool plugged = true;
    bool leaving = false;
    bool opened = false;
    bool waiting = false;  ///< read() waits for a picture
    int offered = 0;       ///< pictures not yet read
    int opens = 0;
  };
  explicit ScriptedDevice(std::shared_ptr<State> state) : state_(std::move(state)) {}

  bool open() override {
    const std::lock_guard lock(state_->mutex);
    state_->opened = state_->plugged;
    state_->opens += 1;
    state_->changed.notify_all();
    return state_->opened;
  }
  void close() override {
    const std::lock_guard lock(state_->mutex);
    state_->opened = false;
    state_->changed.notify_all();
  }
  bool read(cv::Mat& bgr, Micros& age) override {
    std::unique_lock lock(state_->mutex);
    state_->waiting = true;
    state_->changed.notify_all();
    state_->changed.wait(lock, [&] { return state_->offered > 0 || !state_->plugged || state_->leaving; });
    state_->waiting = false;
    if (!state_->plugged || state_->leaving) return false;
    --state_->offered;
    bgr.create(48, 64, CV_8UC3);
    bgr.setTo(cv::Scalar::all(90));
    age = 5 * kMillisecond;
    return true;
  }

 private:
  std::shared_ptr<State> state_;
};

/// Everything that a test needs about one camera on a scripted device.
struct Bench {
  std::shared_ptr<ScriptedDevice::State> state = std::make_shared<ScriptedDevice::State>();
  ManualClock clock;
  GrabberCamera camera{"/dev/video7", std::make_unique<ScriptedDevice>(state), clock,
                       std::chrono::milliseconds(1)};

  Bench() { clock.set(kSecond); }
  ~Bench() {
    const std::lock_guard lock(state->mutex);
    state->leaving = true;
    state->changed.notify_all();
  }

  void until(const std::function<bool()>& holds) {
    std::unique_lock lock(state->mutex);
    state->changed.wait(lock, holds);
  }
  /// Offers one picture and waits until the camera has taken it and asks for the next.
  void give() {
    clock.advance(50 * kMillisecond);
    until([&] { return state->waiting; });
    {
      const std::lock_guard lock(state->mutex);
      ++state->offered;
      state->waiting = false;
    }
    state->changed.notify_all();
    until([&] { return state->waiting && state->offered == 0; });
  }
  void plug(bool in) {
    const std::lock_guard lock(state->mutex);
    state->plugged = in;
    state->changed.notify_all();
  }
};

}  // namespace

CameraUnderTest make_grabber() {
  auto bench = std::make_shared<Bench>();
  return {bench, &bench->camera, [b = bench.get()] { b->give(); },
          [b = bench.get()] { return b->clock.now(); }};
}

namespace {

TEST(GrabberCamera, StampsThePictureWithItsAge) {
  Bench bench;
  bench.camera.enable(true);
  bench.give();
  EXPECT_EQ(bench.camera.poll()->t_exposure, bench.clock.now() - 5 * kMillisecond);
}

TEST(GrabberCamera, ReleasesTheDeviceWhenItIsDisabled) {
  Bench bench;
  bench.camera.enable(true);
  bench.until([&] { return bench.state->waiting; });
  bench.camera.enable(false);
  {
    const std::lock_guard lock(bench.state->mutex);
    ++bench.state->offered;  // the picture under way
  }
  bench.state->changed.notify_all();
  bench.until([&] { return !bench.state->opened; });
  EXPECT_FALSE(bench.camera.poll());
}

TEST(GrabberCamera, TellsOfAPulledPlugAndHealsByItself) {
  Bench bench;
  bench.camera.enable(true);
  bench.give();
  EXPECT_TRUE(bench.camera.health());
  bench.plug(false);
  bench.until([&] { return bench.state->opens >= 4; });  // it keeps trying
  ASSERT_FALSE(bench.camera.health());
  EXPECT_EQ(bench.camera.health().faults()[0].code(), "camera_lost");
  bench.plug(true);
  bench.give();
  EXPECT_TRUE(bench.camera.health());
  EXPECT_TRUE(bench.camera.poll());
}

TEST(V4l2Camera, AMissingDeviceIsOneClearSentence) {
  ManualClock clock;
  const auto camera = open_v4l2("/dev/video-none", clock);
  ASSERT_FALSE(camera);
  EXPECT_THAT(camera.faults()[0].text(Lang::en), testing::HasSubstr("/dev/video-none"));
}

TEST(V4l2Camera, GivesPicturesWhereThereIsACamera) {
  if (!std::filesystem::exists("/dev/video0")) GTEST_SKIP() << "no /dev/video0 on this machine";
  SteadyClock clock;
  auto camera = std::move(open_v4l2("/dev/video0", clock)).value();
  camera->enable(true);
  std::optional<Frame> frame;
  while (!frame && clock.now() < 5 * kSecond) {
    frame = camera->poll();
    std::this_thread::yield();
  }
  ASSERT_TRUE(frame) << to_text(camera->health() ? Faults{} : camera->health().faults(), Lang::en);
  EXPECT_LE(frame->t_exposure, clock.now());
}

}  // namespace
}  // namespace mirada::hal
