#pragma once
#include <atomic>
#include <condition_variable>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "base/messages.h"
#include "session/station.h"

namespace mirada::server {

/// A station that writes down what is asked of it and publishes what a test gives it. Thread-safe.
class FakeStation final : public session::Station {
 public:
  Result<session::Started> start(const std::string& program_json) override {
    log("start " + program_json);
    if (on_start) on_start();
    if (program_json == "\"bad\"") return make_fault("block-1", messages::field_missing, {{"field", "x"}});
    const std::lock_guard lock(mutex_);
    publish_locked([](session::Telemetry& t) {
      ++t.run;
      t.state = session::RunState::running;
      t.stop_reason = session::StopReason::none;
    });
    return session::Started{telemetry_->run, {}};
  }
  void stop(session::StopReason why) override {
    stops.fetch_add(1);
    log(std::string("stop ") + session::to_string(why));
    const std::lock_guard lock(mutex_);
    publish_locked([&](session::Telemetry& t) {
      t.state = session::RunState::idle;
      t.stop_reason = why;
    });
  }
  void pause(bool on) override { log(on ? "pause on" : "pause off"); }
  void key(const std::string& name, bool down) override { log("key " + name + (down ? " down" : " up")); }
  void evaluate(const std::string& program_json, const std::string& block_id,
                std::function<void(Result<vm::MonitorValue>)> answer) override {
    log("evaluate " + block_id + " of " + program_json);
    const std::lock_guard lock(mutex_);
    answers.push_back(std::move(answer));
  }
  session::Setup setup() const override {
    const std::lock_guard lock(mutex_);
    return setup_;
  }
  std::vector<session::Option> worlds() const override { return {{"room1", "Room 1", "Sala 1"}}; }
  std::vector<session::Option> robots() const override { return {{"bot", "Bot", "Robot"}}; }
  Status choose(const session::Setup& setup) override {
    log("choose " + setup.world + " " + setup.robot + " " + std::to_string(setup.seed));
    if (setup.world == "nowhere") return make_fault("--world", messages::file_missing, {{"file", "nowhere"}});
    const std::lock_guard lock(mutex_);
    setup_ = setup;
    return Ok{};
  }
  Status put_back() override {
    log("put_back");
    return Ok{};
  }
  void want(const session::Wanted& wanted) override {
    log(std::string("want") + (wanted.camera ? " camera" : "") + (wanted.sonar ? " sonar" : "") +
        (wanted.faces ? " faces" : "") + (wanted.room ? " room" : ""));
  }
  std::shared_ptr<const session::Telemetry> telemetry() const override {
    const std::lock_guard lock(mutex_);
    return telemetry_;
  }
  std::shared_ptr<const session::Picture> picture() const override {
    const std::lock_guard lock(mutex_);
    return picture_;
  }

  session::KnownFaces known_faces() const override {
    const std::lock_guard lock(mutex_);
    return known_faces_;
  }
  std::uint64_t known_faces_revision() const override {
    const std::lock_guard lock(mutex_);
    return known_faces_.revision;
  }
  Status change_faces(const session::FacesStep& step) override {
    using Action = session::FacesStep::Action;
    const char* names[] = {"allow", "rename", "forget", "forget_all"};
    log(std::string("faces ") + names[static_cast<std::size_t>(step.action)] + " " + step.name);
    if (step.name == "nobody") return make_fault("", messages::field_missing, {{"field", "name"}});
    const std::lock_guard lock(mutex_);
    ++known_faces_.revision;
    if (step.action == Action::allow) known_faces_.allowed = step.on;
    return Ok{};
  }
  std::vector<session::Option> cameras() const override { return {{"cam", "Cam", "Cámara"}}; }
  Status calibrate(const session::CalibrationStep& step) override {
    using Action = session::CalibrationStep::Action;
    const char* names[] = {"begin", "take", "finish", "save", "cancel"};
    log(std::string("calibrate ") + names[static_cast<std::size_t>(step.action)] +
        (step.action == Action::begin ? " " + step.plan.size : ""));
    if (step.plan.size == "0x0") return make_fault("size", messages::field_missing, {{"field", "size"}});
    session::Calibration next;
    if (step.action == Action::begin) next.phase = session::Calibration::Phase::looking;
    show(next);
    return Ok{};
  }
  std::shared_ptr<const session::Calibration> calibration() const override {
    const std::lock_guard lock(mutex_);
    return calibration_;
  }
  std::optional<Fault> camera_words() const override {
    const std::lock_guard lock(mutex_);
    return camera_words_;
  }

  void show(session::Calibration calibration) {
    const std::lock_guard lock(mutex_);
    calibration_ = std::make_shared<const session::Calibration>(std::move(calibration));
  }
  void say_of_camera(std::optional<Fault> words) {
    const std::lock_guard lock(mutex_);
    camera_words_ = std::move(words);
  }
  void publish(const std::function<void(session::Telemetry&)>& change) {
    const std::lock_guard lock(mutex_);
    publish_locked(change);
  }
  void show(session::Picture picture) {
    const std::lock_guard lock(mutex_);
    picture_ = std::make_shared<const session::Picture>(std::move(picture));
  }
  std::vector<std::string> calls() const {
    const std::lock_guard lock(log_mutex_);
    return log_;
  }
  void forget_calls() {
    const std::lock_guard lock(log_mutex_);
    log_.clear();
  }
  void answer_all(const Result<vm::MonitorValue>& value) {
    std::vector<std::function<void(Result<vm::MonitorValue>)>> waiting;
    {
      const std::lock_guard lock(mutex_);
      waiting.swap(answers);
    }
    for (auto& answer : waiting) answer(value);
  }

  std::function<void()> on_start;  ///< runs inside start(), as compiling would
  std::atomic<int> stops{0};

 private:
  void publish_locked(const std::function<void(session::Telemetry&)>& change) {
    session::Telemetry next = *telemetry_;
    change(next);
    telemetry_ = std::make_shared<const session::Telemetry>(std::move(next));
  }
  void log(std::string line) {
    const std::lock_guard lock(log_mutex_);
    log_.push_back(std::move(line));
  }

  mutable std::mutex mutex_;
  mutable std::mutex log_mutex_;
  std::vector<std::string> log_;
  std::vector<std::function<void(Result<vm::MonitorValue>)>> answers;
  session::KnownFaces known_faces_;
  session::Setup setup_{"room1", "bot", 1, true};
  std::shared_ptr<const session::Telemetry> telemetry_ = std::make_shared<const session::Telemetry>();
  std::shared_ptr<const session::Picture> picture_;
  std::shared_ptr<const session::Calibration> calibration_ = std::make_shared<const session::Calibration>();
  std::optional<Fault> camera_words_;
};

}  // namespace mirada::server
