#pragma once
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "model/percepts.h"
#include "model/robot_config.h"
#include "vision/faces/face_track.h"

namespace mirada::vision {

/// Gives faces their numbers and keeps them through short losses: each is a
/// point above the floor of the odometry frame O with a speed, so that it stays
/// itself while the neck and the robot move. One thread.
class FaceTracker {
 public:
  explicit FaceTracker(const RobotConfig& robot) : robot_(robot) {}

  /// Where the known faces should be in this picture, their boxes included; of
  /// those out of view only where the box would be, unless it is behind the
  /// camera.
  std::vector<FacePercept> expected(const FacesPercept& picture, const NeckAngles& neck,
                                    const Pose2& X_OR) const;

  /// Those who have not been seen for a while, as if they stood straight ahead of the camera.
  std::vector<FacePercept> lost_ahead(const FacesPercept& picture, const NeckAngles& neck,
                                      const Pose2& X_OR) const;

  /// Numbers the faces of a picture and steadies their distance; adds, as
  /// `predicted`, those that were there a moment ago. `sized`: the boxes were found in this picture; else
  /// they were only moved along, and their size is an older one.
  void follow(FacesPercept& seen, const NeckAngles& neck, const Pose2& X_OR, bool sized = true);

  /// Somebody seen by what they wear: their bearing, when > 0 distance, and where the clothes end above.
  struct BodySeen {
    int id = 0;
    double bearing_rad = 0;
    double distance_m = 0;
    double likeness = 0;
    std::optional<double> top_elevation_rad{};
    /// Of the picture's upper edge, where the clothes go on above it.
    std::optional<double> goes_above_rad{};
  };
  /// How far below the face the clothes of somebody end whose face was seen in the newest picture.
  void learn_top(const BodySeen& body, const NeckAngles& neck, const Pose2& X_OR);
  /// After follow(), of the same picture: puts them into seen.bodies.
  void follow_bodies(const std::vector<BodySeen>& bodies, FacesPercept& seen, const NeckAngles& neck,
                     const Pose2& X_OR);
  std::vector<int> ids() const;

  bool lost_one() const;
  /// One was seen for the first time just now.
  bool met_one() const;
  void forget() { tracks_.clear(); }

  /// How long a face that is no longer seen counts as being there.
  static constexpr Micros kHold = FaceTrack::kHold;

 private:
  using Track = FaceTrack;
  struct View {
    CameraModel camera;
    Eigen::Isometry3d X_RC;
    Pose2 X_OR;
  };

  View view(const FacesPercept& picture, const NeckAngles& neck, const Pose2& X_OR) const;
  static std::optional<FacePercept> as_seen(const Track& track, const View& view);
  static double farthest_m(const Track& track, const BodySeen& body, const Eigen::Vector3d& p_OC);
  static FacePercept made_whole(const FacePercept& face, const Track& track, const View& view);
  void correct(Track& track, const FacePercept& seen, const View& view, bool sized) const;
  Track begin(const FacePercept& face, const View& view, Micros t);
  struct Pair {
    double cost;
    std::size_t track, face;
  };
  std::vector<Pair> pairs(const FacesPercept& seen, const View& here) const;
  void take(Track& track, FacePercept& face, const View& here, bool sized) const;
  void forget_old(Micros now);
  void add_predicted(FacesPercept& seen, const View& here) const;

  RobotConfig robot_;
  std::vector<Track> tracks_;
  int next_id_ = 1;
};

}  // namespace mirada::vision
