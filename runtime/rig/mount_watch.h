#pragma once
#include <optional>

#include "model/frame.h"
#include "model/robot_config.h"
#include "vision/mount/mount_measure.h"
#include "vision/tags/tag_finder.h"

namespace mirada::rig {

/// The start-up check: whether the camera still stands as the robot's file says, from an AprilTag that lies
/// on the floor in view. The tag that robot.json's "check" names is believed to lie flat; any other only when
/// the file's mount makes it do so within 25 degrees, and then its size is not known: tilt and roll are
/// compared, not the height. What it cannot notice: a camera turned about its upright axis, and anything
/// without a tag in view. One thread.
class MountWatch {
 public:
  /// `always`: look for a tag even if the file names none.
  MountWatch(const RobotConfig& robot, bool always);

  bool wants_pictures() const { return left_ > 0; }
  /// Gives up, or is done.
  void end() { left_ = 0; }
  /// A picture taken while robot and neck stood still.
  void look(const Frame& frame, const NeckAngles& neck);
  /// The verdict in words, once there is one: warnings when it was knocked or could not be told.
  const Faults& words() const { return words_; }

 private:
  std::optional<vision::FloorSight> sight(const cv::Mat& gray, const NeckAngles& neck);
  void conclude(const vision::MountCheck& check, const vision::FloorSight& sight);

  RobotConfig robot_;
  vision::TagFinder tags_;
  int left_ = 0;  ///< pictures still to look at
  std::optional<vision::MountCheck::Verdict> last_;
  int agreeing_ = 0;
  Faults words_;
};

}  // namespace mirada::rig
