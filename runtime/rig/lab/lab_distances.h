#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "model/robot_config.h"
#include "rig/lab/lab_room.h"
#include "rig/lab/lab_sample.h"
#include "vision/visual_sonar.h"

namespace mirada::rig {

/// What `mirada lab distances` is to render.
struct LabPlan {
  std::vector<world::FloorKind> floors;
  std::vector<LabLight> lights;
  int seeds = 4;  ///< rooms of each floor in each light
  std::uint64_t first_seed = 1000;
  RobotConfig robot;
  vision::SonarSettings sonar;
  /// The camera stands as the file says, and vision is told so (sigma 0). Otherwise tilt, height and pan are
  /// off by chance as the file's sigma say, and vision knows only the sigma.
  bool exact_mount = true;
};

/// One picture that was looked at, with its scored bearings.
struct LabShot {
  std::string name;  ///< floor-light-seed-number
  std::string room;  ///< floor-light-seed: pictures of one room follow each other
  cv::Mat bgr;
  NeckAngles neck;
  std::vector<LabSample> samples;
};

/// The robot of the accuracy figures: 320x240 with 62.2 x 48.8 degrees, 20 cm high, 22 degrees down, pan axis
/// 5 cm behind the lens.
RobotConfig lab_robot();

/// The robot as vision is told of it: with sigma 0 when the mount is exactly known.
RobotConfig told_robot(const LabPlan& plan);

/// Looks about from several places in each room, straight ahead and to both sides, and scores every whole
/// degree. `on_room` and `on_shot` (may be empty) hear of each finished room and of each picture. One
/// thread, deterministic.
std::vector<LabSample> look_at_rooms(const LabPlan& plan,
                                     const std::function<void(int done, int all)>& on_room = {},
                                     const std::function<void(const LabShot&)>& on_shot = {});

/// What the paper's geometry makes of a boundary pixel, for a robot that looks straight at it.
double paper_distance_m(const RobotConfig& robot, const CameraModel& camera, const NeckAngles& neck,
                        double u_px, double v_px);

/// The paper's geometry at each bearing of a percept, from the percept's own boundary pixels; NaN where there
/// is none.
std::vector<double> paper_readings(const RobotConfig& robot, const CameraModel& camera,
                                   const SonarPercept& seen);

}  // namespace mirada::rig
