#pragma once
#include <vector>

#include "memory/attention.h"
#include "memory/segments.h"

namespace mirada::memory {

/// All that the memory panel draws. Odometry frame O. Immutable once published.
struct Snapshot {
  struct Place {
    Eigen::Vector2d p_O_m;
    double sigma_m;
    Micros age;
  };
  /// A face, a tag, a ball: where it was seen last.
  struct Named {
    ThingKind kind;
    int id;  ///< of a tag; 0 for others
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
  std::vector<Named> things;
  Micros now = 0;
  std::vector<double> free_m;  ///< every 5 degrees from ahead to the left: how far floor is known free
  NextLook next;
};

Snapshot snapshot_of(const VisualMemory& memory);

}  // namespace mirada::memory
