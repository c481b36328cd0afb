#include "rig/mount_watch.h"

#include <cmath>
#include <limits>

#include <opencv2/imgproc.hpp>

#include "base/units.h"
#include "rig/messages.h"
#include "vision/mount/messages.h"
#include "vision/tags/tag_pose.h"

namespace mirada::rig {
namespace {

using vision::MountCheck;

constexpr int kLooks = 30;
constexpr int kAgreeing = 3;
constexpr double kTagCorner_px = 0.15;
constexpr double kFlat_rad = rad(25);
constexpr double kSomeSize_m = 0.1;  ///< tilt and roll do not depend on it
constexpr double kSameAspect = 0.01;

bool lies_flat(const vision::TagSighting& tag, const CameraModel& camera, const Eigen::Isometry3d& X_RC) {
  const auto pose = vision::tag_pose(tag.corners_px, camera, kSomeSize_m);
  if (!pose) return false;
  const auto upright = [&](const Eigen::Isometry3d& X_CT) {
    return (X_RC * X_CT).linear()(2, 2) > std::cos(kFlat_rad);
  };
  return upright(pose->X_CT) || (pose->other_X_CT && pose->ambiguity > 0.5 && upright(*pose->other_X_CT));
}

}  // namespace

MountWatch::MountWatch(const RobotConfig& robot, bool always)
    : robot_(robot), left_(always || robot.check ? kLooks : 0) {}

std::optional<vision::FloorSight> MountWatch::sight(const cv::Mat& gray, const NeckAngles& neck) {
  const CameraModel& calibrated = robot_.camera;
  const double aspect =
      static_cast<double>(gray.cols) * calibrated.height_px / gray.rows / calibrated.width_px;
  if (std::abs(aspect - 1) > kSameAspect) return std::nullopt;
  const CameraModel camera = calibrated.scaled_to(gray.cols, gray.rows);
  const Eigen::Isometry3d X_RC = robot_.X_RC(neck);
  for (const vision::TagSighting& tag : tags_.find(gray)) {
    const bool named = robot_.check && (robot_.check->tag_id < 0 || robot_.check->tag_id == tag.id);
    if (!named && !lies_flat(tag, camera, X_RC)) continue;
    const double h = (named ? robot_.check->tag_m : kSomeSize_m) / 2;
    auto found = vision::sight_from_points(camera, {tag.corners_px.begin(), tag.corners_px.end()},
                                           {{-h, h}, {h, h}, {h, -h}, {-h, -h}}, 0, kTagCorner_px);
    if (!found) continue;
    if (!named) found->height_m = std::numeric_limits<double>::quiet_NaN();
    return *found;
  }
  return std::nullopt;
}

void MountWatch::look(const Frame& frame, const NeckAngles& neck) {
  if (left_ <= 0 || frame.bgr.empty()) return;
  cv::Mat gray;
  cv::cvtColor(frame.bgr, gray, cv::COLOR_BGR2GRAY);
  const auto seen = sight(gray, neck);
  if (seen) {
    const MountCheck check = vision::check_mount(robot_, neck, *seen);
    agreeing_ = last_ == check.verdict ? agreeing_ + 1 : 1;
    last_ = check.verdict;
    if (agreeing_ >= kAgreeing) return conclude(check, *seen);
  }
  if (--left_ == 0) {
    words_ = {make_fault("camera", messages::mount_check_no_tag, {}, Severity::warning)};
  }
}

void MountWatch::conclude(const MountCheck& check, const vision::FloorSight& sight) {
  left_ = 0;
  words_ = check.words;
  if (check.verdict != MountCheck::Verdict::fine) return;
  words_ = {make_fault("camera", messages::mount_check_fine, {{"tilt", number_text(deg(sight.tilt_rad), 1)}},
                       Severity::warning)};
}

}  // namespace mirada::rig
