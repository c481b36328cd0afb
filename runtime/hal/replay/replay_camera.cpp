#include "hal/replay/replay_camera.h"

#include <algorithm>
#include <mutex>

#include "hal/messages.h"
#include "hal/replay/picture_source.h"

namespace mirada::hal {
namespace {

class ReplayCamera final : public Camera {
 public:
  ReplayCamera(std::string file, std::unique_ptr<PictureSource> source, Micros period, bool loop,
               const Clock& clock)
      : file_(std::move(file)), source_(std::move(source)), period_(period), loop_(loop), clock_(clock) {}

  std::optional<Frame> poll() override {
    const std::lock_guard lock(mutex_);
    if (!enabled_) return std::nullopt;
    const std::int64_t due = (clock_.now() - began_) / period_;
    if (due < next_) return std::nullopt;
    if (!loop_ && due >= length_) {
      trouble_ = make_fault(file_, messages::replay_ended, {{"file", file_}});
      if (next_ >= length_) return std::nullopt;
    }
    const std::int64_t turn = loop_ ? due : std::min(due, length_ - 1);
    return picture(turn);
  }

  Status health() const override {
    const std::lock_guard lock(mutex_);
    if (trouble_) return *trouble_;
    return Ok{};
  }

  void enable(bool on) override {
    const std::lock_guard lock(mutex_);
    if (on == enabled_) return;
    enabled_ = on;
    if (on) began_ = clock_.now() - next_ * period_;
  }

 private:
  std::optional<Frame> picture(std::int64_t turn) {
    next_ = turn + 1;
    cv::Mat bgr = source_->read(turn % length_);
    if (bgr.empty() && turn % length_ > 0 && source_->own_fps() > 0) {
      // A video may hold fewer pictures than its header says: that is its end.
      length_ = turn % length_;
      next_ = 0;
      began_ = clock_.now();
      if (!loop_) next_ = length_;
      return std::nullopt;
    }
    if (bgr.empty()) {
      trouble_ = make_fault(file_, messages::picture_broken, {{"file", file_}});
      return std::nullopt;
    }
    if (!(trouble_ && trouble_->message == &messages::replay_ended)) trouble_.reset();
    return Frame{bgr, began_ + turn * period_, ++number_};
  }

  std::string file_;
  std::unique_ptr<PictureSource> source_;
  Micros period_;
  bool loop_;
  const Clock& clock_;
  mutable std::mutex mutex_;
  std::int64_t length_ = source_->count();
  bool enabled_ = false;
  Micros began_ = 0;       ///< when picture 0 was, or would have been, taken
  std::int64_t next_ = 0;  ///< the first picture that was not given yet
  std::uint64_t number_ = 0;
  std::optional<Fault> trouble_;
};

}  // namespace

Result<std::unique_ptr<Camera>> open_replay(const std::filesystem::path& path, const Clock& clock,
                                            const ReplaySettings& settings) {
  Result<std::unique_ptr<PictureSource>> source = open_pictures(path);
  if (!source) return source.faults();
  double fps = settings.fps > 0 ? settings.fps : (*source)->own_fps();
  if (fps <= 0) fps = 20;
  const Micros period = std::max<Micros>(micros(1 / fps), 1);
  return std::unique_ptr<Camera>(
      std::make_unique<ReplayCamera>(path.string(), std::move(*source), period, settings.loop, clock));
}

}  // namespace mirada::hal
