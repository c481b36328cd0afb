#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hal/camera.h"
#include "hal/drive.h"
#include "hal/neck.h"
#include "model/robot_config.h"
#include "world/held_board.h"
#include "world/world_config.h"

namespace mirada::world {

/// What a referee may know and a block never: the truth.
struct Truth {
  Pose2 X_WR;
  NeckAngles neck;
  double path_m = 0;
  int contacts = 0;
  int line_crossings = 0;
  bool touching = false;
  std::vector<Pose2> people;  ///< as the room lists them
};

/// A robot in a room, stepped from outside (10 ms). The same (world, robot, seed, steps, commands) gives the
/// same bits. step(), put_back(), truth() and scene_json() on one thread; the devices keep their contracts of
/// hal/ (stop() from any thread, at once).
class Simulation {
 public:
  Simulation(const WorldConfig& world, const RobotConfig& robot, std::uint64_t seed);
  ~Simulation();

  /// Advances the world by dt; a picture whose exposure falls into the step is rendered only while the camera
  /// is enabled, and can be polled once it is robot.latency.frame_us old. now() is the robot's clock.
  void step(Micros dt);
  Micros now() const;
  /// The start pose again, contacts and path at zero; a new picture of chance is drawn only for another seed.
  void put_back();
  /// Somebody lifts the robot and puts it down here; it notices nothing of it but by what it sees.
  void carry_to(const Pose2& X_WR);
  /// From now on pictures show this print before the camera, or none.
  void hold_board(std::optional<HeldBoard> board);

  hal::Camera& camera();
  hal::Drive& drive();
  hal::Neck& neck();

  Truth truth() const;
  /// docs/protocol.md, `scene`. The parts that never change are cached.
  std::string scene_json() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mirada::world
