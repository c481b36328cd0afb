#pragma once
#include <optional>
#include <string>
#include <vector>

#include "memory/visual_memory.h"

namespace mirada::memory {

/// What attention keeps an eye on. The zones are the three of Vega & Cañas 2019: in turn, each for half a
/// second; ranked: the one whose age times its rank is largest.
enum class Watching { nothing, ahead, around, face, zones, ranked_zones };
const char* to_string(Watching watching);

/// Where attention will look next, and why (docs/protocol.md).
struct NextLook {
  std::string watching = "nothing";
  std::string why;  ///< "", "old", "never_seen", "on_the_way", "its_turn", "the_face"
  double pan_rad = 0;
  bool moving = false;
};

/// What attention chooses from, and what the robot does.
struct GazeRange {
  JointConfig pan;
  double half_view_rad = 0;
  double pan_now_rad = 0;
  double speed_mps = 0;
  double turn_radps = 0;
  std::optional<double> face_rad;  ///< where a face is or was
};

/// Chooses the next place to look: where looking is worth most for the time it takes. Worth is age x need x
/// danger, summed over what the view would show. One thread.
class Attention {
 public:
  static constexpr Micros kZoneTime = 500 * kMillisecond;

  void watch(Watching what);
  Watching watching() const { return watching_; }
  NextLook next(const VisualMemory& memory, const GazeRange& range);
  /// How long each look takes at least.
  Micros dwell() const { return watching_ == Watching::zones ? kZoneTime : 0; }

 private:
  NextLook best(const VisualMemory& memory, const GazeRange& range) const;
  NextLook zone(const VisualMemory& memory, const GazeRange& range);

  Watching watching_ = Watching::nothing;
  int zone_ = -1;
};

/// Where to stop to see all that the neck can show within `reach_rad` to both sides, from where it is now:
/// the nearer side first.
std::vector<double> sweep_stops(const GazeRange& range, double reach_rad);

}  // namespace mirada::memory
