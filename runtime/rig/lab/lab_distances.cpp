#include "rig/lab/lab_distances.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/random.h"
#include "base/units.h"
#include "rig/lab/lab_truth.h"
#include "rig/lab/paper_geometry.h"
#include "vision/ground_projection.h"
#include "world/render/renderer.h"

namespace mirada::rig {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kPans_rad[] = {0, rad(40), rad(-40)};
constexpr double kBearingMatch_rad = rad(0.75);

Eigen::Isometry3d on_floor(const Pose2& X_WR) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.translation() = Eigen::Vector3d(X_WR.x_m, X_WR.y_m, 0);
  X.linear() = Eigen::AngleAxisd(X_WR.heading_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return X;
}

/// The robot whose camera really takes the pictures: off from the file by chance.
RobotConfig as_it_stands(const RobotConfig& told, Random& random) {
  RobotConfig out = told;
  out.mount.tilt_rad += told.mount.sigma_tilt_rad * random.gaussian();
  out.mount.p_TM_m.z() += told.mount.sigma_height_m * random.gaussian();
  out.mount.yaw_rad += told.mount.sigma_pan_rad * random.gaussian();
  return out;
}

bool in_picture(const CameraModel& camera, const std::optional<Eigen::Vector2d>& pixel) {
  return pixel && pixel->x() >= 0 && pixel->y() >= 0 && pixel->x() <= camera.width_px - 1 &&
         pixel->y() <= camera.height_px - 1;
}

struct Room {
  const LabPlan& plan;
  world::FloorKind floor;
  LabLight light;
  LabRoom lab;
  LabTruth truth;
  RobotConfig real;
};

void score_percept(const Room& room, const Pose2& X_WR, const NeckAngles& neck, const SonarPercept& seen,
                   std::vector<LabSample>& out) {
  const RobotConfig& told = room.plan.robot;
  const vision::GroundProjection ground(room.real, room.real.camera, neck);
  const std::vector<double> paper = paper_readings(told, told.camera, seen);
  for (std::size_t i = 0; i < seen.readings.size(); ++i) {
    const SonarReading& reading = seen.readings[i];
    LabSample sample;
    sample.floor = to_string(room.floor);
    sample.light = to_string(room.light);
    sample.off_axis_rad = reading.bearing_rad - neck.pan_rad;
    sample.truth_m = sample.free_m = room.truth.distance_m(X_WR, reading.bearing_rad);
    const Eigen::Vector2d foot_R_m(sample.truth_m * std::cos(reading.bearing_rad),
                                   sample.truth_m * std::sin(reading.bearing_rad));
    sample.foot_seen = std::isfinite(sample.truth_m) && in_picture(room.real.camera, ground.pixel(foot_R_m));
    sample.reading = reading;
    sample.paper_m = paper[i];
    out.push_back(sample);
  }
}

void look_at_room(const Room& room, std::uint64_t seed, const std::function<void(const LabShot&)>& on_shot,
                  std::vector<LabSample>& out) {
  const std::string name =
      std::string(to_string(room.floor)) + "-" + to_string(room.light) + "-" + std::to_string(seed);
  world::Renderer renderer(room.lab.world, room.real.camera, seed);
  vision::VisualSonar sonar(told_robot(room.plan), room.plan.sonar);
  Frame frame;
  for (const Pose2& X_WR : room.lab.stands) {
    for (const double pan_rad : kPans_rad) {
      const NeckAngles neck{pan_rad, 0};
      frame.bgr = renderer.render(on_floor(X_WR) * room.real.X_RC(neck), {},
                                  static_cast<std::int64_t>(frame.number) + 1);
      ++frame.number;
      frame.t_exposure += 500 * kMillisecond;
      LabShot shot{name + "-" + std::to_string(frame.number), name, frame.bgr, neck, {}};
      score_percept(room, X_WR, neck, sonar.look(frame, neck, X_WR), shot.samples);
      for (LabSample& sample : shot.samples) sample.picture = shot.name;
      if (on_shot) on_shot(shot);
      out.insert(out.end(), shot.samples.begin(), shot.samples.end());
    }
  }
}

}  // namespace

RobotConfig lab_robot() {
  RobotConfig robot;
  robot.id = "lab";
  robot.footprint_R_m = {{0.1, 0.09}, {-0.1, 0.09}, {-0.1, -0.09}, {0.1, -0.09}};
  robot.camera.fx_px = robot.camera.width_px / (2 * std::tan(rad(62.2) / 2));
  robot.camera.fy_px = robot.camera.height_px / (2 * std::tan(rad(48.8) / 2));
  robot.neck.pan = {rad(-80), rad(80), 5};
  robot.mount.p_TM_m = {0.05, 0, 0.2};
  robot.mount.tilt_rad = rad(22);
  return robot;
}

RobotConfig told_robot(const LabPlan& plan) {
  RobotConfig robot = plan.robot;
  if (plan.exact_mount) {
    robot.mount.sigma_tilt_rad = robot.mount.sigma_height_m = robot.mount.sigma_pan_rad = 0;
  }
  return robot;
}

double paper_distance_m(const RobotConfig& robot, const CameraModel& camera, const NeckAngles& neck,
                        double u_px, double v_px) {
  const Eigen::Isometry3d X_RC = robot.X_RC(neck);
  const Eigen::Vector3d forward_R = X_RC.linear().col(2);
  PaperGeometry paper;
  paper.width_px = camera.width_px;
  paper.height_px = camera.height_px;
  paper.eye_height_m = X_RC.translation().z();
  paper.tilt_rad = std::asin(std::clamp(-forward_R.z(), -1.0, 1.0));
  paper.pan_rad = std::atan2(forward_R.y(), forward_R.x());
  paper.p_RC_m = X_RC.translation().head<2>();
  const auto point = paper.floor_point({u_px, v_px});
  return point ? point->norm() : kNone;
}

std::vector<double> paper_readings(const RobotConfig& robot, const CameraModel& camera,
                                   const SonarPercept& seen) {
  std::vector<double> out(seen.readings.size(), kNone);
  std::vector<double> nearest(seen.readings.size(), kBearingMatch_rad);
  const vision::GroundProjection ground(robot, camera, seen.neck);
  for (const BoundaryPixel& pixel : seen.boundary) {
    if (pixel.answer != Answer::blocked) continue;
    const auto point = ground.floor_point({pixel.u_px, pixel.v_px});
    if (!point) continue;
    const double bearing_rad = std::atan2(point->y(), point->x());
    for (std::size_t i = 0; i < out.size(); ++i) {
      const double off_rad = std::abs(seen.readings[i].bearing_rad - bearing_rad);
      if (off_rad >= nearest[i] || seen.readings[i].answer != Answer::blocked) continue;
      nearest[i] = off_rad;
      out[i] = paper_distance_m(robot, camera, seen.neck, pixel.u_px, pixel.v_px);
    }
  }
  return out;
}

std::vector<LabSample> look_at_rooms(const LabPlan& plan,
                                     const std::function<void(int done, int all)>& on_room,
                                     const std::function<void(const LabShot&)>& on_shot) {
  std::vector<LabSample> out;
  const int all = static_cast<int>(plan.floors.size() * plan.lights.size()) * plan.seeds;
  int done = 0;
  for (const world::FloorKind floor : plan.floors) {
    for (const LabLight light : plan.lights) {
      for (int i = 0; i < plan.seeds; ++i) {
        const std::uint64_t seed = plan.first_seed + static_cast<std::uint64_t>(i);
        Random random(seed, std::string("lab/mount/") + to_string(floor) + "/" + to_string(light));
        LabRoom lab = lab_room(floor, light, seed);
        LabTruth truth(lab.world);
        const RobotConfig real = plan.exact_mount ? plan.robot : as_it_stands(plan.robot, random);
        look_at_room({plan, floor, light, std::move(lab), std::move(truth), real}, seed, on_shot, out);
        if (on_room) on_room(++done, all);
      }
    }
  }
  return out;
}

}  // namespace mirada::rig
