#pragma once
#include <array>

#include "memory/visual_memory.h"

namespace mirada::memory {

/// How far a round robot can roll straight in each direction, from its origin: until it would touch something
/// remembered, or until floor ends that was looked at. Every 5 degrees, all round.
class Corridors {
 public:
  static constexpr int kDirections = 72;

  Corridors(const VisualMemory& memory, double radius_m, double most_m);

  double free_m(double bearing_rad) const { return free_m_[index(bearing_rad)]; }
  /// The nearest thing remembered, whether floor before it was looked at or not.
  double touch_m(double bearing_rad) const { return touch_m_[index(bearing_rad)]; }
  static double bearing_rad(int i) { return wrap_rad(rad(5.0 * i)); }

 private:
  static std::size_t index(double bearing_rad);

  std::array<double, kDirections> free_m_{};
  std::array<double, kDirections> touch_m_{};
};

}  // namespace mirada::memory
