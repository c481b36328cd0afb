#pragma once
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "base/clock.h"
#include "hal/camera.h"
#include "hal/v4l2/capture_device.h"

namespace mirada::hal {

/// Pulls pictures out of a device on a thread of its own and keeps only the newest: a slow reader loses
/// pictures, never time. Disabled, the device is closed. A device that fails is closed, told of in health()
/// and tried again every `retry`. poll() on one thread, enable() and health() on any. Destruction waits for
/// the picture under way.
class GrabberCamera final : public Camera {
 public:
  /// `name` is shown to people; the clock must outlive the camera.
  GrabberCamera(std::string name, std::unique_ptr<CaptureDevice> device, const Clock& clock,
                std::chrono::milliseconds retry = std::chrono::milliseconds(1000));
  ~GrabberCamera() override;

  std::optional<Frame> poll() override;
  Status health() const override;
  void enable(bool on) override;

 private:
  void run();
  bool wait_until_wanted();
  bool open_device();
  void grab_while_wanted();
  void pause_before_retry();

  std::string name_;
  std::unique_ptr<CaptureDevice> device_;
  const Clock& clock_;
  std::chrono::milliseconds retry_;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  bool wanted_ = false;
  bool leaving_ = false;
  std::optional<Frame> newest_;
  std::optional<Fault> trouble_;
  std::uint64_t number_ = 0;
  std::thread thread_;  ///< last: it uses all of the above
};

}  // namespace mirada::hal
