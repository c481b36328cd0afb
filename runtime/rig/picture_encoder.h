#pragma once
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "model/frame.h"
#include "session/telemetry.h"

namespace mirada::rig {

/// Makes JPEG of the newest picture on a thread of its own; pictures that come while it is busy are dropped
/// but for the last. Every call from any thread; none waits.
class PictureEncoder {
 public:
  PictureEncoder();
  ~PictureEncoder();
  PictureEncoder(const PictureEncoder&) = delete;
  PictureEncoder& operator=(const PictureEncoder&) = delete;

  void offer(const Frame& frame);
  /// Null before the first picture, and after clear().
  std::shared_ptr<const session::Picture> latest() const;
  void clear();

 private:
  void run();

  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::optional<Frame> waiting_;
  std::shared_ptr<const session::Picture> latest_;
  std::uint64_t cleared_ = 0;
  bool closing_ = false;
  std::thread thread_;
};

}  // namespace mirada::rig
