#include "hal/v4l2/grabber_camera.h"

#include "hal/messages.h"

namespace mirada::hal {

GrabberCamera::GrabberCamera(std::string name, std::unique_ptr<CaptureDevice> device, const Clock& clock,
                             std::chrono::milliseconds retry)
    : name_(std::move(name)), device_(std::move(device)), clock_(clock), retry_(retry), thread_([this] {
        run();
      }) {}

GrabberCamera::~GrabberCamera() {
  {
    const std::lock_guard lock(mutex_);
    leaving_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

std::optional<Frame> GrabberCamera::poll() {
  const std::lock_guard lock(mutex_);
  return std::exchange(newest_, std::nullopt);
}

Status GrabberCamera::health() const {
  const std::lock_guard lock(mutex_);
  if (trouble_) return *trouble_;
  return Ok{};
}

void GrabberCamera::enable(bool on) {
  {
    const std::lock_guard lock(mutex_);
    wanted_ = on;
    if (!on) newest_.reset();
  }
  changed_.notify_all();
}

void GrabberCamera::run() {
  while (wait_until_wanted()) {
    if (open_device()) grab_while_wanted();
    device_->close();
    pause_before_retry();
  }
}

bool GrabberCamera::wait_until_wanted() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return wanted_ || leaving_; });
  return !leaving_;
}

bool GrabberCamera::open_device() {
  if (device_->open()) return true;
  const std::lock_guard lock(mutex_);
  // A camera that was lost stays "lost" while it cannot be opened again.
  if (!trouble_) trouble_ = make_fault(name_, messages::camera_busy, {{"device", name_}});
  return false;
}

void GrabberCamera::grab_while_wanted() {
  for (;;) {
    Frame frame;
    Micros age = 0;
    const bool got = device_->read(frame.bgr, age);
    const std::lock_guard lock(mutex_);
    if (leaving_ || !wanted_) return;
    if (!got) {
      trouble_ = make_fault(name_, messages::camera_lost, {{"device", name_}});
      return;
    }
    trouble_.reset();
    frame.t_exposure = clock_.now() - age;
    frame.number = ++number_;
    newest_ = std::move(frame);
  }
}

void GrabberCamera::pause_before_retry() {
  std::unique_lock lock(mutex_);
  if (trouble_) changed_.wait_for(lock, retry_, [&] { return leaving_; });
}

}  // namespace mirada::hal
