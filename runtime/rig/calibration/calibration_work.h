#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "model/camera_preset.h"
#include "model/frame.h"
#include "rig/calibration/board_hand.h"
#include "session/calibration.h"
#include "vision/calibration/board_finder.h"
#include "vision/calibration/solve.h"
#include "vision/calibration/view_collector.h"

namespace mirada::rig {

/// What one run of the wizard starts from.
struct CalibrationJob {
  vision::BoardSpec board;
  std::optional<CameraPreset> preset;
  CameraModel camera;  ///< as the robot's file has it: where to look for the board, roughly
  HoldBoard hold;      ///< empty: a person holds the board
};

/// Reads the plan: every fault at once.
Result<CalibrationJob> read_plan(const session::CalibrationPlan& plan, const CameraModel& camera);

/// One run of the wizard, without threads: pictures in, states and at last a camera.json out. One thread.
class CalibrationWork {
 public:
  explicit CalibrationWork(CalibrationJob job);

  /// Looks at a picture; `take`: a person asks to take it as it is. Gives the state to show.
  session::Calibration look(const Frame& frame, bool take);
  /// Whether the views will do, and solve() should follow.
  bool enough() const;
  std::size_t views() const { return collector_ ? collector_->views().size() : 0; }
  /// Solves from what there is (seconds): ready or poor.
  session::Calibration solve();
  /// The camera.json of a solve() that was ready.
  const std::string& camera_json() const { return camera_json_; }

 private:
  void start_over(cv::Size size);
  void show_seen(const Result<vision::BoardView>& found, bool take, session::Calibration& out);
  void show_progress(session::Calibration& out) const;
  void tell(const vision::Calibration& found, Faults faults, session::Calibration& out);

  CalibrationJob job_;
  vision::BoardFinder finder_;
  std::unique_ptr<BoardHand> hand_;
  cv::Size size_;
  CameraModel guess_;
  std::optional<vision::ViewCollector> collector_;
  std::size_t views_when_poor_ = 0;
  std::string camera_json_;
  cv::Mat gray_;
};

}  // namespace mirada::rig
