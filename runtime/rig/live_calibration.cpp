// The live station's part that lets a camera be calibrated.
#include "rig/calibration/kept_camera.h"
#include "rig/live_station.h"
#include "rig/messages.h"
#include "rig/setup_reader.h"
#include "vision/calibration/guide_messages.h"

namespace mirada::rig {
namespace fs = std::filesystem;

using Action = session::CalibrationStep::Action;

std::vector<session::Option> LiveStation::cameras() const { return camera_options(); }

std::shared_ptr<const session::Calibration> LiveStation::calibration() const { return desk_.state(); }

std::optional<Fault> LiveStation::camera_words() const {
  for (const Fault& word : robot()->camera_words()) {
    if (word.message != &messages::mount_check_fine) return word;
  }
  return std::nullopt;
}

Status LiveStation::calibrate(const session::CalibrationStep& step) {
  switch (step.action) {
    case Action::begin:
      return begin_calibration(step.plan);
    case Action::take:
      return desk_.take();
    case Action::finish:
      return desk_.finish();
    case Action::save:
      return save_calibration();
    case Action::cancel:
      break;
  }
  end_calibration();
  return Ok{};
}

Status LiveStation::begin_calibration(const session::CalibrationPlan& plan) {
  auto job = read_plan(plan, robot()->config().camera);
  if (!job) return job.faults();
  stop(session::StopReason::put_back);
  if (camera_.empty()) {
    job->hold = [this](std::optional<world::HeldBoard> board) {
      post([board = std::move(board)](LiveRobot& robot) { robot.hold_board(board); });
    };
  }
  desk_.begin(std::move(*job));
  update_tap();
  return Ok{};
}

Status LiveStation::save_calibration() {
  const auto json = desk_.result();
  if (!json) return json.faults();
  const session::Setup now = setup();
  const fs::path file = kept_camera_file(now.robot, camera_.empty());
  const auto before = keep_camera(file, *json);
  if (!before) return before.faults();
  if (const Status built = rebuild(now); !built) {
    // The robot's file contradicts what was measured: nothing is changed, and the words say why.
    std::error_code error;
    if (*before) {
      fs::rename(**before, file, error);
    } else {
      fs::remove(file, error);
    }
    return built.faults();
  }
  Faults words = {make_fault("", messages::guide_saved, {{"file", file.string()}}, Severity::warning)};
  if (*before) {
    words.push_back(make_fault("", messages::guide_kept_old, {{"file", (*before)->filename().string()}},
                               Severity::warning));
  }
  desk_.saved(std::move(words));
  update_tap();
  return Ok{};
}

void LiveStation::end_calibration() {
  if (desk_.state()->phase == session::Calibration::Phase::off) return;
  desk_.cancel();
  update_tap();
}

void LiveStation::update_tap() {
  post([this](LiveRobot& robot) {
    if (!desk_.wants_pictures()) return robot.tap({});
    robot.tap([this](const Frame& frame, const NeckAngles&) { desk_.offer(frame); });
  });
}

}  // namespace mirada::rig
