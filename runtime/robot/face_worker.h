#pragma once
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "robot/detectors.h"

namespace mirada::robot {

/// Looks for faces on a thread of its own, one picture at a time, so that a slow detector delays nothing. A
/// picture that comes while it is busy replaces the one that waits. offer() and take() from any thread;
/// neither blocks.
class FaceWorker {
 public:
  using Find = std::function<Result<FacesPercept>(const Frame&, const NeckAngles&, const Pose2&)>;

  explicit FaceWorker(Find find);
  ~FaceWorker();
  FaceWorker(const FaceWorker&) = delete;
  FaceWorker& operator=(const FaceWorker&) = delete;

  void offer(const Frame& frame, const NeckAngles& neck, const Pose2& X_OR);
  /// The newest answer that was not taken yet.
  std::optional<Result<FacesPercept>> take();

 private:
  struct Job {
    Frame frame;
    NeckAngles neck;
    Pose2 X_OR;
  };
  void run();

  Find find_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::optional<Job> job_;
  std::optional<Result<FacesPercept>> answer_;
  bool closing_ = false;
  std::thread thread_;
};

}  // namespace mirada::robot
