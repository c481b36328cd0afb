#pragma once
#include <cstdint>
#include <string>

#include "base/result.h"

namespace mirada::scenarios {

/// What one run of a program in one room came to, by the truth.
struct AvoidRun {
  std::string world;
  std::uint64_t seed = 0;
  std::string status;
  int contacts = 0;
  double path_m = 0;
  int cells = 0;              ///< different 25 cm squares that the robot's origin was in
  std::string first_contact;  ///< when and where, for people
  double simulated_s = 0;
  double wall_s = 0;
  std::string hash;
};

/// Runs the program in a shipped room, or in one of the laboratory's ("lab:FLOOR:LIGHT:NUMBER"), with the
/// visual memory or without. Faults when program, room or robot cannot be used.
Result<AvoidRun> run_in_room(const std::string& program_json, const std::string& world, std::uint64_t seed,
                             double seconds, bool remembers = true);

/// The shipped example *Avoid the obstacles*.
std::string avoid_program();

}  // namespace mirada::scenarios
