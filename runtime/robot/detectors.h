#pragma once
#include <functional>
#include <memory>

#include "base/result.h"
#include "model/frame.h"
#include "model/percepts.h"
#include "vision/identity/face_book.h"

namespace mirada::robot {

/// What turns pictures into percepts. Wired by rig/; each is called from one thread only.
struct Detectors {
  /// Picture, neck and odometry at the exposure.
  std::function<SonarPercept(const Frame&, const NeckAngles&, const Pose2&)> sonar;
  /// A fault in words when faces cannot be looked for at all. Live it is called on a thread of its own.
  std::function<Result<FacesPercept>(const Frame&, const NeckAngles&, const Pose2&)> faces;
  /// Tags and balls.
  std::function<ThingsPercept(const Frame&, const NeckAngles&, const Pose2&)> things;
  /// Lines painted on the floor; empty when it knows no place that has some.
  std::function<LinesPercept(const Frame&, const NeckAngles&, const Pose2&)> lines;
  /// Whose faces are known; null = faces are not told apart. Any thread.
  std::shared_ptr<vision::FaceBook> book;
  /// Forgets the faces that are followed. Any thread.
  std::function<void()> forget_faces;
  /// Forgets what was learnt about the floor.
  std::function<void()> forget_floor;
};

}  // namespace mirada::robot
