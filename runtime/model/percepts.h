#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "base/units.h"
#include "model/geometry.h"

namespace mirada {

/// What vision can say about one direction (DESIGN section 7).
enum class Answer { blocked, clear, not_seen, above_horizon };
const char* to_string(Answer answer);

/// One direction of the visual sonar. Bearing and distance from the robot's origin, positive left. For
/// `clear`, distance is how far floor was seen. Distance and sigma are NaN for not_seen and above_horizon.
struct SonarReading {
  double bearing_rad = 0;
  Answer answer = Answer::not_seen;
  double distance_m = 0;
  double sigma_m = 0;
};

/// Where the boundary was found in the picture, for drawing: one an image column that was scanned.
struct BoundaryPixel {
  float u_px = 0;
  float v_px = 0;
  Answer answer = Answer::not_seen;
};

struct SonarPercept {
  std::uint64_t frame = 0;  ///< the picture's number; 0 = none yet
  Micros t_exposure = 0;
  NeckAngles neck;                      ///< at the exposure
  Pose2 X_OR;                           ///< odometry at the exposure
  std::vector<SonarReading> readings;   ///< every whole degree within view, ascending bearing (right to left)
  std::vector<BoundaryPixel> boundary;  ///< left to right
  bool floor_model_trusted = false;
};

/// Whether a face has been recognised: `unsure` until it was looked at often enough, or when nobody may be.
enum class Familiar { unsure, stranger, known };
const char* to_string(Familiar familiar);

/// How the learning of a face goes.
struct LessonPercept {
  std::string name;
  int looks = 0;
  int needed = 0;
  const Message* hint = nullptr;  ///< what to do now, in words; null = nothing
};

/// Box in source pixels, top-left origin; bearing of its middle from the robot's origin, positive left, and
/// its elevation above the lens's own height, positive up. The distance, along the floor from the robot's
/// origin, is judged by its size.
struct FacePercept {
  double x_px = 0, y_px = 0, w_px = 0, h_px = 0;
  double score = 0;
  double bearing_rad = 0;
  double elevation_rad = 0;
  double distance_m = 0;
  double sigma_m = 0;
  int id = 0;                                       ///< the same while it is followed; 0 = not followed
  bool predicted = false;                           ///< not seen in this picture: where it should be
  Eigen::Vector2d p_O_m = Eigen::Vector2d::Zero();  ///< of one that is followed
  Eigen::Vector2d v_O_mps = Eigen::Vector2d::Zero();
  Micros age = 0;      ///< of the picture that it was last seen in, when this one was taken
  std::string name{};  ///< who it is, when that is known
  Familiar familiar = Familiar::unsure;
};

struct FacesPercept {
  std::uint64_t frame = 0;
  Micros t_exposure = 0;
  int picture_width_px = 320;
  int picture_height_px = 240;
  std::string detector;
  std::vector<FacePercept> faces;  ///< largest first
  /// People who are followed by what they wear while their face is not seen: where the face should be.
  std::vector<FacePercept> bodies;
  std::optional<LessonPercept> lesson{};  ///< a face is being learnt
  int described = 0;                      ///< faces that were described for this answer, which takes its time
};

enum class ThingKind { face, tag, red_ball };

/// Something with a name, and where it stands: from the robot's origin, along the floor, bearing positive
/// left; sigma of the distance.
struct ThingSeen {
  ThingKind kind = ThingKind::face;
  int id = 0;  ///< of a tag
  double bearing_rad = 0;
  double distance_m = 0;
  double sigma_m = 0;
  double facing_rad = 0;      ///< of a tag: which way it looks, in the robot's frame
  bool facing_known = false;  ///< false: the corners fit two ways of facing
};

/// Side of a tag's black square, when nothing else is known: distances are told for this.
inline constexpr double kTagSide_m = 0.1;

struct ThingsPercept {
  std::uint64_t frame = 0;
  Micros t_exposure = 0;
  Pose2 X_OR;  ///< odometry at the exposure
  std::vector<ThingSeen> things;
};

/// A straight piece of a line painted on the floor, by its middle from A to B, in the robot's frame at the
/// exposure. Sigmas of where its middle lies across it, and of its direction.
struct LineSeen {
  Eigen::Vector2d p_RA_m, p_RB_m;
  double across_sigma_m = 0;
  double angle_sigma_rad = 0;
};

struct LinesPercept {
  std::uint64_t frame = 0;
  Micros t_exposure = 0;
  Pose2 X_OR;  ///< odometry at the exposure
  std::vector<LineSeen> lines;
};

/// All that is perceived now. Immutable once published; blocks read the newest snapshot.
struct Percepts {
  SonarPercept sonar;
  FacesPercept faces;
  ThingsPercept things;
  LinesPercept lines;
};

}  // namespace mirada
