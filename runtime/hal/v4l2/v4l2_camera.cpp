#include "hal/v4l2/v4l2_camera.h"

#include <chrono>
#include <cmath>
#include <filesystem>

#include <opencv2/videoio.hpp>

#include "hal/messages.h"
#include "hal/v4l2/grabber_camera.h"

namespace mirada::hal {
namespace {

Micros monotonic_now() {
  const auto since = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::microseconds>(since).count();
}

class V4l2Device final : public CaptureDevice {
 public:
  V4l2Device(std::string device, const V4l2Settings& settings)
      : device_(std::move(device)), settings_(settings) {}

  bool open() override {
    std::error_code error;
    if (!std::filesystem::exists(device_, error)) return false;
    try {
      if (!capture_.open(device_, cv::CAP_V4L2)) return false;
      capture_.set(cv::CAP_PROP_FRAME_WIDTH, settings_.width_px);
      capture_.set(cv::CAP_PROP_FRAME_HEIGHT, settings_.height_px);
      capture_.set(cv::CAP_PROP_FPS, settings_.fps);
      return true;
    } catch (const cv::Exception&) {
      return false;
    }
  }

  void close() override { capture_.release(); }

  bool read(cv::Mat& bgr, Micros& age) override {
    try {
      cv::Mat shared;
      if (!capture_.read(shared) || shared.type() != CV_8UC3) return false;
      bgr = shared.clone();
      age = age_of_picture();
      return true;
    } catch (const cv::Exception&) {
      return false;
    }
  }

 private:
  /// The driver stamps buffers on the monotonic clock; one that does not say gets half a picture's time.
  Micros age_of_picture() const {
    const double stamp_ms = capture_.get(cv::CAP_PROP_POS_MSEC);
    const Micros age = monotonic_now() - micros(stamp_ms / 1000);
    if (stamp_ms > 0 && age >= 0 && age < kSecond) return age;
    return micros(0.5 / settings_.fps);
  }

  std::string device_;
  V4l2Settings settings_;
  cv::VideoCapture capture_;
};

}  // namespace

Result<std::unique_ptr<Camera>> open_v4l2(const std::string& device, const Clock& clock,
                                          const V4l2Settings& settings) {
  std::error_code error;
  if (!std::filesystem::is_character_file(device, error)) {
    return make_fault(device, messages::camera_missing, {{"device", device}});
  }
  return std::unique_ptr<Camera>(
      std::make_unique<GrabberCamera>(device, std::make_unique<V4l2Device>(device, settings), clock));
}

}  // namespace mirada::hal
