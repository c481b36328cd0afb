#include "rig/calibration/calibration_work.h"

#include <cmath>

#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include "base/units.h"
#include "vision/calibration/camera_json.h"
#include "vision/calibration/guide_messages.h"
#include "vision/calibration/judge.h"

namespace mirada::rig {
namespace {

using session::Calibration;
using vision::ViewCollector;

constexpr std::size_t kMoreAfterPoor = 4;
constexpr double kLikeShape = 0.01;

session::PicturePoint point_of(const cv::Point2f& p) { return {p.x, p.y}; }

session::Outline outline_of(const std::vector<cv::Point2f>& points) {
  session::Outline out;
  for (const cv::Point2f& p : points) out.push_back(point_of(p));
  return out;
}

session::Outline hull_of(const vision::BoardView& view) {
  std::vector<cv::Point2f> hull;
  cv::convexHull(view.corners_px, hull);
  return outline_of(hull);
}

/// The lens to look with before it is known: the datasheet's, else the robot's file's.
CameraModel guess_for(const CalibrationJob& job, cv::Size size) {
  const CameraModel& told = job.camera;
  const double shape = static_cast<double>(size.width) * told.height_px / size.height / told.width_px;
  if (std::abs(shape - 1) <= kLikeShape && !job.preset) return told.scaled_to(size.width, size.height);
  CameraModel out;
  out.width_px = size.width;
  out.height_px = size.height;
  out.cx_px = (size.width - 1) / 2.0;
  out.cy_px = (size.height - 1) / 2.0;
  double hfov_rad = told.hfov_rad();
  const CameraMode* mode = job.preset ? job.preset->nearest_mode(size.width, size.height, hfov_rad) : nullptr;
  if (mode != nullptr) hfov_rad = mode->hfov_rad;
  out.fx_px = out.fy_px = size.width / 2.0 / std::tan(std::min(hfov_rad, rad(120)) / 2);
  return out;
}

const Message& words_of(ViewCollector::Verdict verdict) {
  switch (verdict) {
    case ViewCollector::Verdict::taken:
      return messages::guide_taken;
    case ViewCollector::Verdict::moving:
      return messages::guide_moving;
    case ViewCollector::Verdict::known:
      return messages::guide_known;
    case ViewCollector::Verdict::unclear:
      return messages::guide_unclear;
    case ViewCollector::Verdict::full:
      break;
  }
  return messages::guide_full;
}

Fault say(const Message& message, MessageArgs args = {}) {
  return make_fault("", message, std::move(args), Severity::warning);
}

std::vector<CameraPreset> known_cameras() {
  std::vector<CameraPreset> out;
  for (const std::string& id : shipped_cameras()) {
    if (auto preset = camera_preset(id)) out.push_back(std::move(*preset));
  }
  return out;
}

void append(Faults& faults, const Faults& more) { faults.insert(faults.end(), more.begin(), more.end()); }

}  // namespace

Result<CalibrationJob> read_plan(const session::CalibrationPlan& plan, const CameraModel& camera) {
  CalibrationJob job;
  job.camera = camera;
  Faults faults;
  auto board = plan.charuco ? vision::charuco_spec(plan.size, plan.square_mm, plan.marker_mm, plan.dictionary)
                            : vision::chessboard_spec(plan.size, plan.square_mm);
  if (board) {
    job.board = *board;
  } else {
    append(faults, board.faults());
  }
  if (!plan.camera.empty()) {
    auto preset = camera_preset(plan.camera);
    if (preset) {
      job.preset = std::move(*preset);
    } else {
      append(faults, preset.faults());
    }
  }
  if (!faults.empty()) return faults;
  return job;
}

CalibrationWork::CalibrationWork(CalibrationJob job) : job_(std::move(job)), finder_(job_.board) {
  if (job_.hold) hand_ = std::make_unique<BoardHand>(job_.board, job_.hold);
}

void CalibrationWork::start_over(cv::Size size) {
  size_ = size;
  guess_ = guess_for(job_, size);
  collector_.emplace(job_.board, guess_);
  views_when_poor_ = 0;
}

Calibration CalibrationWork::look(const Frame& frame, bool take) {
  Calibration out;
  out.phase = Calibration::Phase::looking;
  const cv::Size size = frame.bgr.size();
  const bool changed = size != size_;
  const bool anew = changed && collector_.has_value();
  const cv::Size before = size_;
  if (changed) start_over(size);
  cv::cvtColor(frame.bgr, gray_, cv::COLOR_BGR2GRAY);
  out.frame = frame.number;
  show_seen(finder_.find(gray_, std::to_string(views() + 1)), take, out);
  if (anew) {
    const auto text = [](cv::Size s) { return std::to_string(s.width) + "x" + std::to_string(s.height); };
    out.now = say(messages::guide_size_changed, {{"wanted", text(before)}, {"value", text(size)}});
  }
  show_progress(out);
  if (hand_) {
    if (const auto next = collector_->next()) hand_->step(next->X_CB);
  }
  return out;
}

void CalibrationWork::show_seen(const Result<vision::BoardView>& found, bool take, Calibration& out) {
  if (!found) {
    collector_->look_in_vain();
    out.now = found.faults().front();
    out.now->severity = Severity::warning;
    return;
  }
  out.corners = outline_of(found->corners_px);
  out.now = say(words_of(collector_->look(*found, take)));
}

void CalibrationWork::show_progress(Calibration& out) const {
  out.room_holds = hand_ != nullptr;
  out.width_px = size_.width;
  out.height_px = size_.height;
  out.views_needed = static_cast<std::size_t>(vision::kFewestViews);
  out.views_good = ViewCollector::kGood;
  if (!collector_) return;
  for (const vision::BoardView& view : collector_->views()) out.taken.push_back(hull_of(view));
  out.views = collector_->views().size();
  out.coverage = collector_->coverage().share;
  out.tilt_deg = deg(collector_->tilt_spread_rad());
  const auto next = collector_->next();
  if (next) out.target = outline_of(vision::outline_px(next->X_CB, job_.board, guess_));
  out.next = say(next ? *next->words : messages::hold_elsewhere);
}

bool CalibrationWork::enough() const {
  if (!collector_) return false;
  const bool nowhere_left = hand_ && !collector_->next();
  const bool new_since_poor = views_when_poor_ == 0 || views() >= views_when_poor_ + kMoreAfterPoor;
  return new_since_poor && (collector_->enough() || nowhere_left);
}

Calibration CalibrationWork::solve() {
  Calibration out;
  show_progress(out);
  out.phase = Calibration::Phase::poor;
  views_when_poor_ = views();
  auto found = vision::solve(collector_ ? collector_->views() : std::vector<vision::BoardView>{},
                             vision::LensChoice::automatic);
  if (!found) {
    out.words = found.faults();
    return out;
  }
  Faults faults = vision::distrust(*found);
  if (job_.preset) append(faults, vision::check_datasheet(*found, *job_.preset, known_cameras()));
  found->camera.name = !job_.camera.name.empty() ? job_.camera.name : job_.preset ? job_.preset->name_en : "";
  tell(*found, std::move(faults), out);
  return out;
}

void CalibrationWork::tell(const vision::Calibration& found, Faults faults, Calibration& out) {
  out.rms_px = found.rms_px;
  out.hfov_deg = deg(found.camera.hfov_rad());
  out.vfov_deg = deg(found.camera.vfov_rad());
  for (const vision::SolvedView& view : found.views) out.view_rms_px.push_back(view.rms_px);
  out.words.push_back(
      say(messages::guide_good, {{"hfov", number_text(out.hfov_deg, 1)},
                                 {"vfov", number_text(out.vfov_deg, 1)},
                                 {"rms", number_text(found.rms_px, 2)},
                                 {"max", number_text(vision::highest_rms_px(found.camera), 2)}}));
  if (has_errors(faults)) {
    out.words.push_back(say(messages::guide_poor));
  } else {
    out.phase = Calibration::Phase::ready;
    camera_json_ = vision::camera_json(found, job_.board, job_.preset ? job_.preset->id : "").dump(2) + "\n";
  }
  append(out.words, faults);
  append(out.words, found.refused);
}

}  // namespace mirada::rig
