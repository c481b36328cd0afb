#include "rig/calibration/calibration_desk.h"

#include <utility>

#include "vision/calibration/guide_messages.h"
#include "vision/calibration/judge.h"

namespace mirada::rig {

using session::Calibration;
using Phase = Calibration::Phase;

CalibrationDesk::CalibrationDesk()
    : state_(std::make_shared<const Calibration>()), thread_([this] { run(); }) {}

CalibrationDesk::~CalibrationDesk() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
    work_.reset();
  }
  wake_.notify_one();
  thread_.join();
}

void CalibrationDesk::begin(CalibrationJob job) {
  Calibration first;
  first.phase = Phase::looking;
  first.room_holds = static_cast<bool>(job.hold);
  first.views_needed = static_cast<std::size_t>(vision::kFewestViews);
  first.views_good = vision::ViewCollector::kGood;
  auto work = std::make_shared<CalibrationWork>(std::move(job));
  const std::lock_guard lock(mutex_);
  work_.swap(work);
  waiting_.reset();
  take_ = finish_ = false;
  camera_json_.clear();
  show(std::move(first));
}

Status CalibrationDesk::take() {
  const std::lock_guard lock(mutex_);
  const bool poor = state_->phase == Phase::poor;
  if (!poor && state_->phase != Phase::looking) return make_fault("", messages::guide_not_now);
  if (poor) {
    Calibration again = *state_;
    again.phase = Phase::looking;
    again.words.clear();
    show(std::move(again));
  }
  take_ = !poor;
  return Ok{};
}

Status CalibrationDesk::finish() {
  {
    const std::lock_guard lock(mutex_);
    if (state_->phase != Phase::looking) return make_fault("", messages::guide_not_now);
    if (state_->views < static_cast<std::size_t>(vision::kFewestViews)) {
      return make_fault(
          "", messages::guide_few,
          {{"value", std::to_string(state_->views)}, {"min", std::to_string(vision::kFewestViews)}});
    }
    finish_ = true;
  }
  wake_.notify_one();
  return Ok{};
}

void CalibrationDesk::cancel() {
  std::shared_ptr<CalibrationWork> gone;
  const std::lock_guard lock(mutex_);
  gone.swap(work_);
  waiting_.reset();
  camera_json_.clear();
  if (state_->phase != Phase::off) show({});
}

Result<std::string> CalibrationDesk::result() const {
  const std::lock_guard lock(mutex_);
  if (state_->phase != Phase::ready) return make_fault("", messages::guide_not_now);
  return camera_json_;
}

void CalibrationDesk::saved(Faults words) {
  std::shared_ptr<CalibrationWork> gone;
  const std::lock_guard lock(mutex_);
  Calibration done = *state_;
  done.phase = Phase::saved;
  done.words = std::move(words);
  gone.swap(work_);
  show(std::move(done));
}

void CalibrationDesk::offer(const Frame& frame) {
  {
    const std::lock_guard lock(mutex_);
    if (!work_ || state_->phase != Phase::looking) return;
    waiting_ = frame;
  }
  wake_.notify_one();
}

bool CalibrationDesk::wants_pictures() const {
  const std::lock_guard lock(mutex_);
  return work_ != nullptr;
}

std::shared_ptr<const Calibration> CalibrationDesk::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

void CalibrationDesk::show(Calibration state) {
  state_ = std::make_shared<const Calibration>(std::move(state));
}

void CalibrationDesk::publish(const std::shared_ptr<CalibrationWork>& work, Calibration state) {
  const std::lock_guard lock(mutex_);
  // Cancelled or begun anew meanwhile: nobody wants this any more.
  if (work == work_) show(std::move(state));
}

void CalibrationDesk::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    wake_.wait(lock, [this] { return closing_ || finish_ || waiting_.has_value(); });
    if (closing_) return;
    Turn turn{work_, std::exchange(waiting_, std::nullopt), false, std::exchange(finish_, false)};
    if (turn.frame) turn.take = std::exchange(take_, false);
    lock.unlock();
    if (turn.work) do_turn(std::move(turn));
    turn = {};  // the work may end here, its hand with it
    lock.lock();
  }
}

void CalibrationDesk::do_turn(Turn turn) {
  Calibration state = *this->state();
  if (turn.frame && !turn.finish) {
    state = turn.work->look(*turn.frame, turn.take);
    publish(turn.work, state);
  }
  if (!turn.finish && !turn.work->enough()) return;
  state.phase = Phase::working;
  state.now = make_fault("", messages::guide_working, {}, Severity::warning);
  state.corners.clear();
  publish(turn.work, state);
  Calibration solved = turn.work->solve();
  solved.frame = state.frame;
  const std::lock_guard lock(mutex_);
  if (turn.work != work_) return;
  camera_json_ = turn.work->camera_json();
  show(std::move(solved));
}

}  // namespace mirada::rig
