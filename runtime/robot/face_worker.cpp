#include "robot/face_worker.h"

namespace mirada::robot {

FaceWorker::FaceWorker(Find find) : find_(std::move(find)), thread_([this] { run(); }) {}

FaceWorker::~FaceWorker() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void FaceWorker::offer(const Frame& frame, const NeckAngles& neck, const Pose2& X_OR) {
  {
    const std::lock_guard lock(mutex_);
    job_ = Job{frame, neck, X_OR};
  }
  wake_.notify_one();
}

std::optional<Result<FacesPercept>> FaceWorker::take() {
  const std::lock_guard lock(mutex_);
  std::optional<Result<FacesPercept>> out = std::move(answer_);
  answer_.reset();
  return out;
}

void FaceWorker::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    wake_.wait(lock, [this] { return closing_ || job_.has_value(); });
    if (closing_) return;
    const Job job = std::move(*job_);
    job_.reset();
    lock.unlock();
    Result<FacesPercept> found = find_(job.frame, job.neck, job.X_OR);
    lock.lock();
    answer_ = std::move(found);
  }
}

}  // namespace mirada::robot
