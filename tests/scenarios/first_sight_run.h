#pragma once
#include <cstdint>
#include <optional>
#include <string>

namespace mirada::scenarios {

/// How long until something new is seen by a robot that stands and keeps an eye on what is around it.
struct FirstSight {
  std::uint64_t seed = 0;
  double bearing_rad = 0, distance_m = 0;  ///< of the thing, from the robot
  double placed_s = 0;
  std::optional<double> after_s;  ///< from its placing until it is remembered; nothing: not within 8 s
  bool imagined = false;          ///< an obstacle was told of before there was one
  std::string hash;
};

/// `watching`: what the block *keep an eye on* is given ("around", "zones", "ranks"). Where and when the
/// thing appears depends on the seed alone: within 86° to both sides, which the three zones show too.
FirstSight run_first_sight(std::uint64_t seed, const std::string& watching);

}  // namespace mirada::scenarios
