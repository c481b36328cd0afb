#pragma once
#include <optional>

#include "memory/visual_memory.h"

namespace mirada::memory {

/// A free way between two edges, from the robot's origin.
struct Way {
  double bearing_rad = 0;  ///< of its middle
  double width_m = 0;      ///< between its edges
  double free_m = 0;       ///< how far it is known to be free
  double edge_m = 0;       ///< how far off its edges are
};

/// All ways that a robot this wide fits through and that are free for `most_m` or as far as anything is;
/// ordered by bearing to the left from ahead.
std::vector<Way> ways(const VisualMemory& memory, double width_m, double most_m);
/// The bearing of the widest; nothing when none is known.
std::optional<double> widest_way(const VisualMemory& memory, double width_m, double most_m);

/// The way nearest to a bearing, at most `within_rad` off.
std::optional<Way> gap_near(const VisualMemory& memory, double bearing_rad, double width_m, double most_m,
                            double within_rad);

}  // namespace mirada::memory
