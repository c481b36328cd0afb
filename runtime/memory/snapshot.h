#pragma once
#include <string>
#include <vector>

#include "memory/segments.h"
#include "memory/visual_memory.h"

namespace mirada::memory {

/// Where attention will look next, and why (docs/protocol.md).
struct NextLook {
  std::string watching = "nothing";  ///< "nothing", "ahead", "around", "face", "zones"
  std::string why;                   ///< "", "old", "never_seen", "on_the_way", "its_turn", "the_face"
  double pan_rad = 0;
  bool moving = false;
};

/// All that the memory panel draws. Odometry frame O. Immutable once published.
struct Snapshot {
  struct Place {
    Eigen::Vector2d p_O_m;
    double sigma_m;
    Micros age;
  };
  std::uint64_t version = 0;
  Pose2 X_OR;
  NeckAngles neck;
  double hfov_rad = 0;
  std::vector<Place> places;
  std::vector<Segment> segments;
  Micros now = 0;
  std::vector<double> free_m;  ///< every 5 degrees from ahead to the left: how far floor is known free
  NextLook next;
};

Snapshot snapshot_of(const VisualMemory& memory);

}  // namespace mirada::memory
