#pragma once
#include <cstdint>
#include <vector>

#include "model/geometry.h"

namespace mirada::memory {

/// Where floor was seen, in squares around the robot, on odometry. Bounded: what is left behind is forgotten.
/// One thread.
class FreeFloor {
 public:
  static constexpr double kCell_m = 0.05;
  static constexpr int kSide = 256;  ///< cells; 12.8 m
  static constexpr Micros kLife = 90 * kSecond;
  static constexpr double kLongestTyre_m = 5;  ///< driven since: after that drift makes it worthless

  FreeFloor() : cells_(static_cast<std::size_t>(kSide) * kSide) {}

  /// The robot is here now; `tyre_m` as DriftMark's.
  void centre(double x_m, double y_m, Micros now, double tyre_m);
  /// Seen, or (Mark::before) nearer than the picture begins that showed floor farther off.
  enum class Mark : std::uint8_t { seen, before };
  void mark(double x_m, double y_m, Mark mark = Mark::seen);
  /// All squares from (x, y) as far as `length_m` in a direction of O.
  void mark_ray(double x_m, double y_m, double direction_rad, double length_m, Mark mark = Mark::seen);
  /// When floor was seen there; negative: never, or it no longer counts.
  Micros seen_at(double x_m, double y_m) const;
  /// The same, or it lay before such a picture: good enough for who looks down now and then.
  bool likely_at(double x_m, double y_m) const;
  void forget();

 private:
  struct Cell {
    std::int32_t x = 0;
    std::int32_t y = 0;
    std::int32_t seen_cs = -1;  ///< hundredths of a second, for the months that a robot may be left on
    float tyre_m = 0;
    Mark mark = Mark::seen;
  };
  /// The cell there when it still counts; null when not.
  const Cell* known_at(double x_m, double y_m) const;
  std::size_t slot(std::int32_t x, std::int32_t y) const {
    return static_cast<std::size_t>(y & (kSide - 1)) * kSide + static_cast<std::size_t>(x & (kSide - 1));
  }

  std::vector<Cell> cells_;
  std::int32_t middle_x_ = 0;
  std::int32_t middle_y_ = 0;
  Micros now_ = 0;
  double tyre_m_ = 0;
};

}  // namespace mirada::memory
