#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "model/robot_config.h"
#include "session/run_report.h"
#include "vision/identity/face_book.h"
#include "vm/machine.h"
#include "world/simulation.h"

namespace mirada::rig {

struct LockstepOptions {
  std::optional<world::WorldConfig>
      world;  ///< none: no pictures, an ideal body, nothing but the budget ends a tick
  RobotConfig robot;
  std::uint64_t seed = 1;
  double seconds = 60;
  bool remembers = true;   ///< false: the visual memory keeps no more than the newest picture shows
  std::string face_model;  ///< a network's file; "" = the one that was fetched, or none
  /// Who is known; null = nobody, and nobody may be learnt. What a run learns stays in it: give each run its
  /// own for the same result.
  std::shared_ptr<vision::FaceBook> book;
  vm::Limits limits;
  std::function<bool()> stop_asked;  ///< looked at once a tick; may be empty
  /// Called after each world step with the truth (not without a world); may be empty.
  std::function<void(Micros, const world::Truth&)> watch;
  /// Asked before each world step: where somebody puts the robot now, if anywhere; may be empty.
  std::function<std::optional<Pose2>(Micros)> carry;
};

/// Runs one program to its end on the calling thread, as fast as it goes, in simulated time: the same binary,
/// program, robot, world and seed give the same report (but wall_s), bit for bit (DESIGN section 4). A
/// program that cannot start gives a report `invalid` with every fault.
session::RunReport run_lockstep(const std::string& program_json, const LockstepOptions& options);

}  // namespace mirada::rig
