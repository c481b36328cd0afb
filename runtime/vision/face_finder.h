#pragma once
#include <memory>
#include <optional>
#include <string>

#include "base/result.h"
#include "model/frame.h"
#include "model/percepts.h"
#include "model/robot_config.h"
#include "vision/faces/face_net.h"

namespace mirada::vision {

/// Finds faces in one picture: with a network, or with Debian's Haar cascade where there is none. One thread.
class FaceFinder {
 public:
  /// `model`: a network's file, which must be one; "" = the one that scripts/run fetches, and without it the
  /// cascade. Fault in words when there is nothing to look with.
  static Result<std::unique_ptr<FaceFinder>> open(const RobotConfig& robot, const std::string& model = "");
  virtual ~FaceFinder() = default;
  virtual FacesPercept find(const Frame& frame, const NeckAngles& neck) = 0;
  /// The answer for this picture, still without faces; and where a box of it lies.
  virtual FacesPercept none(const Frame& frame) const = 0;
  virtual FacePercept place(const FaceBox& box, const Frame& frame, const NeckAngles& neck) const = 0;
  /// Said when the plain cascade is used because there is no network.
  virtual const std::optional<Fault>& fallback() const = 0;
};

/// A fault when this is meant to be a network's file and is none.
Status check_face_model(const std::string& model);
/// What fallback() will say, before anything is opened; nothing when a network's file is there.
std::optional<Fault> face_fallback(const std::string& model);

}  // namespace mirada::vision
