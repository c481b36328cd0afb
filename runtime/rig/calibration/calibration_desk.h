#pragma once
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "rig/calibration/calibration_work.h"

namespace mirada::rig {

/// The wizard's own thread: looks at the newest picture as fast as it can, solves, and publishes what to
/// show. Every call from any thread; none waits for a picture or a solution.
class CalibrationDesk {
 public:
  CalibrationDesk();
  ~CalibrationDesk();
  CalibrationDesk(const CalibrationDesk&) = delete;
  CalibrationDesk& operator=(const CalibrationDesk&) = delete;

  void begin(CalibrationJob job);
  /// Takes the next picture's board, moving or not; after a poor result it also goes on looking.
  Status take();
  Status finish();
  void cancel();
  /// The camera.json of a result that is ready; a fault when there is none.
  Result<std::string> result() const;
  /// The result was saved: shown in these words.
  void saved(Faults words);

  void offer(const Frame& frame);
  bool wants_pictures() const;
  std::shared_ptr<const session::Calibration> state() const;

 private:
  struct Turn {
    std::shared_ptr<CalibrationWork> work;
    std::optional<Frame> frame;
    bool take = false;
    bool finish = false;
  };

  void run();
  void do_turn(Turn turn);
  void publish(const std::shared_ptr<CalibrationWork>& work, session::Calibration state);
  void show(session::Calibration state);

  mutable std::mutex mutex_;
  std::condition_variable wake_;
  bool closing_ = false;
  std::shared_ptr<CalibrationWork> work_;  ///< null: off; used by the thread alone
  std::optional<Frame> waiting_;
  bool take_ = false;
  bool finish_ = false;
  std::string camera_json_;
  std::shared_ptr<const session::Calibration> state_;
  std::thread thread_;  ///< last: it uses all of the above
};

}  // namespace mirada::rig
