#pragma once
#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "rig/calibration/calibration_desk.h"
#include "rig/live_robot.h"
#include "session/station.h"

namespace mirada::rig {

/// The live robot's threads behind the server's contract: a control thread (room, perception, scripts), a
/// watchdog, and the picture encoder. Stop is a path of its own: it goes straight to Safety.
class LiveStation final : public session::Station {
 public:
  /// `camera`, `book` and `tell` do not change with choose().
  LiveStation(std::unique_ptr<LiveRobot> robot, std::string camera, std::string face_model,
              std::shared_ptr<vision::FaceBook> book, Tell tell);
  ~LiveStation() override;

  Result<session::Started> start(const std::string& program_json) override;
  void stop(session::StopReason why) override;
  void pause(bool on) override;
  void key(const std::string& name, bool down) override;
  void evaluate(const std::string& program_json, const std::string& block_id,
                std::function<void(Result<vm::MonitorValue>)> answer) override;

  session::Setup setup() const override;
  std::vector<session::Option> worlds() const override;
  std::vector<session::Option> robots() const override;
  Status choose(const session::Setup& setup) override;
  Status put_back() override;

  void want(const session::Wanted& wanted) override;
  std::shared_ptr<const session::Telemetry> telemetry() const override;
  std::shared_ptr<const session::Picture> picture() const override;

  std::vector<session::Option> cameras() const override;
  Status calibrate(const session::CalibrationStep& step) override;
  std::shared_ptr<const session::Calibration> calibration() const override;
  std::optional<Fault> camera_words() const override;

  session::KnownFaces known_faces() const override;
  std::uint64_t known_faces_revision() const override {
    book_->notice_changes();
    return book_->revision();
  }
  Status change_faces(const session::FacesStep& step) override;

 private:
  using Command = std::function<void(LiveRobot&)>;

  std::shared_ptr<LiveRobot> robot() const;
  void post(Command command);
  /// post(), and waits until it has been done.
  void post_and_wait(const Command& command);
  void control_loop();
  void watchdog_loop();
  std::deque<Command> take_commands();
  /// Pictures go to whoever looks at them beside the programs, or to nobody.
  void update_tap();
  Status begin_calibration(const session::CalibrationPlan& plan);
  Status save_calibration();
  void end_calibration();
  Status rebuild(const session::Setup& setup);

  const std::string camera_;
  const std::string face_model_;
  const std::shared_ptr<vision::FaceBook> book_;
  const Tell tell_;
  PictureEncoder encoder_;
  mutable std::mutex robot_mutex_;  // the pointer
  std::shared_ptr<LiveRobot> robot_;
  std::mutex choose_mutex_;  // one choose() at a time
  std::mutex commands_mutex_;
  std::condition_variable commands_wake_;
  std::deque<Command> commands_;
  bool closing_ = false;    // the control thread's alone
  session::Wanted wanted_;  // under commands_mutex_
  std::mutex watchdog_mutex_;
  std::condition_variable watchdog_wake_;
  bool watchdog_closing_ = false;
  CalibrationDesk desk_;
  std::thread control_;
  std::thread watchdog_;
};

}  // namespace mirada::rig
