#pragma once
#include <cstdint>
#include <string>

namespace mirada::scenarios {

/// What the truth says of a robot that drove into a corner between two field lines (Vega & Cañas 2019, 5.3).
struct CornerRun {
  std::uint64_t seed = 0;
  double nearest_m = 0;  ///< least distance of its middle to the corner's point
  double end_m = 0;      ///< the same at the end
  int crossings = 0;     ///< of the lines
  bool looked = false;   ///< the neck moved at any time
  bool left = false;     ///< was in the corner, ended outside of it, crossed nothing and did not look again
  std::string status;
  std::string hash;
};

/// Drives into the corner with the camera ahead, stops before the lines, asks *is the way clear?* of
/// directions from behind to the sides and takes the first that is. With `memory` false it forgets everything
/// before it asks.
CornerRun run_corner(std::uint64_t seed, bool memory);

}  // namespace mirada::scenarios
