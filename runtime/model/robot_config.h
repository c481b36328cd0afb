#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "base/result.h"
#include "model/camera_model.h"
#include "model/geometry.h"
#include "model/place.h"

namespace mirada {

/// Differential drive. Wheel speeds are of the tyre on the floor.
struct DriveConfig {
  double track_m = 0.15;  ///< between the wheels' contact points
  double wheel_radius_m = 0.033;
  double max_wheel_mps = 0.35;
  double max_accel_mps2 = 1.0;  ///< per wheel, also while braking
  double cruise_mps = 0.18;     ///< what "drive cm" uses
  double turn_radps = 1.6;      ///< what "turn degrees" uses
};

/// One joint of the neck. min == max: the joint does not exist.
struct JointConfig {
  double min_rad = 0;
  double max_rad = 0;
  double max_radps = 5;
};

/// The chain robot R -> neck base N -> pan P -> tilt T -> camera mount M -> optical C; offsets in the
/// parent's frame (x forward, y left, z up).
struct NeckConfig {
  Eigen::Vector3d p_RN_m = Eigen::Vector3d::Zero();  ///< the pan axis
  Eigen::Vector3d p_PT_m = Eigen::Vector3d::Zero();  ///< the tilt axis, with pan = 0
  JointConfig pan;
  JointConfig tilt;
};
struct MountConfig {
  Eigen::Vector3d p_TM_m = Eigen::Vector3d::Zero();  ///< the lens's centre, with pan = tilt = 0
  double tilt_rad = 0;                               ///< fixed, positive down; adds to the neck's tilt
  double yaw_rad = 0;                                ///< fixed, positive left
  double roll_rad = 0;                               ///< fixed, positive clockwise seen from behind
  double sigma_tilt_rad = 0.0087;                    ///< how well the tilt is known
  double sigma_height_m = 0.003;
  double sigma_pan_rad = 0.0087;
};

/// How old an answer is when it arrives, in lockstep (live it is what it is).
struct LatencyConfig {
  Micros frame_us = 30'000;  ///< from exposure to a frame that can be read
  Micros sonar_us = 10'000;  ///< from a readable frame to its answer
  Micros faces_us = 80'000;
  Micros identity_us = 60'000;  ///< more, for each face that is looked at closely to tell who it is
};

/// A tag that lies on the floor before the robot when it is switched on, by which it checks its camera.
struct CheckConfig {
  double tag_m = 0.08;  ///< side of its black square
  int tag_id = -1;      ///< any
};

struct RobotConfig {
  std::string id;
  std::string name_en;
  std::string name_es;
  std::vector<Eigen::Vector2d> footprint_R_m;  ///< convex, counter-clockwise
  DriveConfig drive;
  CameraModel camera;
  double camera_fps = 20;
  NeckConfig neck;
  MountConfig mount;
  LatencyConfig latency;
  std::optional<CheckConfig> check;
  /// Painted lines on the floor end it, as walls do: for fields that must not be left.
  bool lines_are_obstacles = false;
  std::optional<Place> place;  ///< what it knows of where it is; never from robot.json

  /// The robot's widest extent across its direction of travel.
  double width_m() const;
  /// X_RC: the camera's optical frame seen from the robot's, for these joint angles.
  Eigen::Isometry3d X_RC(const NeckAngles& neck) const;
};

/// Reads robot.json (docs/robot-json.md). On success `warnings` holds what was odd but harmless (unknown
/// fields).
Result<RobotConfig> read_robot(std::string_view json_text, const std::string& file_name,
                               Faults* warnings = nullptr);
Result<RobotConfig> load_robot(const std::filesystem::path& file, Faults* warnings = nullptr);

/// The ids of the robots that ship (runtime/model/robots/<id>.json), sorted, and one of them or of a file by
/// path.
std::vector<std::string> shipped_robots();
Result<RobotConfig> robot_by_name(const std::string& id_or_path, Faults* warnings = nullptr);

}  // namespace mirada
