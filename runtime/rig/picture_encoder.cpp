#include "rig/picture_encoder.h"

#include <vector>

#include <opencv2/imgcodecs.hpp>

namespace mirada::rig {
namespace {

constexpr int kQuality = 80;

std::shared_ptr<const session::Picture> encode(const Frame& frame) {
  std::vector<unsigned char> jpeg;
  cv::imencode(".jpg", frame.bgr, jpeg, {cv::IMWRITE_JPEG_QUALITY, kQuality});
  auto picture = std::make_shared<session::Picture>();
  picture->frame = frame.number;
  picture->t_exposure = frame.t_exposure;
  picture->width_px = frame.bgr.cols;
  picture->height_px = frame.bgr.rows;
  picture->jpeg.assign(jpeg.begin(), jpeg.end());
  return picture;
}

}  // namespace

PictureEncoder::PictureEncoder() : thread_([this] { run(); }) {}

PictureEncoder::~PictureEncoder() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void PictureEncoder::offer(const Frame& frame) {
  {
    const std::lock_guard lock(mutex_);
    waiting_ = frame;
  }
  wake_.notify_one();
}

std::shared_ptr<const session::Picture> PictureEncoder::latest() const {
  const std::lock_guard lock(mutex_);
  return latest_;
}

void PictureEncoder::clear() {
  const std::lock_guard lock(mutex_);
  waiting_.reset();
  latest_.reset();
  ++cleared_;
}

void PictureEncoder::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    wake_.wait(lock, [this] { return closing_ || waiting_.has_value(); });
    if (closing_) return;
    const Frame frame = std::move(*waiting_);
    waiting_.reset();
    const std::uint64_t cleared_before = cleared_;
    lock.unlock();
    auto picture = encode(frame);
    lock.lock();
    if (cleared_ == cleared_before) latest_ = std::move(picture);
  }
}

}  // namespace mirada::rig
