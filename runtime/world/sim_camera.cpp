#include "world/sim_camera.h"

namespace mirada::world {

std::optional<Frame> SimCamera::poll() {
  const std::lock_guard lock(mutex_);
  std::optional<Frame> out;
  while (!pending_.empty() && pending_.front().t_exposure + latency_ <= clock_.now()) {
    out = std::move(pending_.front());
    pending_.pop_front();
  }
  return out;
}

void SimCamera::enable(bool on) {
  enabled_.store(on);
  if (!on) drop();
}

void SimCamera::expose(cv::Mat bgr, Micros t_exposure) {
  const std::lock_guard lock(mutex_);
  if (pending_.size() >= kMostPending) pending_.pop_front();
  pending_.push_back({std::move(bgr), t_exposure, ++number_});
}

void SimCamera::drop() {
  const std::lock_guard lock(mutex_);
  pending_.clear();
}

}  // namespace mirada::world
