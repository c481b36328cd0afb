#pragma once
#include <cstdint>
#include <numbers>

namespace mirada {

/// Time in integer microseconds. What zero means is the clock's own affair.
using Micros = std::int64_t;

constexpr Micros kMillisecond = 1'000;
constexpr Micros kSecond = 1'000'000;

constexpr double seconds(Micros t) { return static_cast<double>(t) * 1e-6; }
constexpr Micros micros(double t_s) { return static_cast<Micros>(t_s * 1e6 + (t_s >= 0 ? 0.5 : -0.5)); }

constexpr double rad(double angle_deg) { return angle_deg * std::numbers::pi / 180.0; }
constexpr double deg(double angle_rad) { return angle_rad * 180.0 / std::numbers::pi; }

/// The same angle in (-pi, pi], for any angle.
double wrap_any_rad(double angle_rad);
/// The same angle in (-pi, pi]. Within a turn and a half a difference is exact, and much cheaper.
inline double wrap_rad(double angle_rad) {
  constexpr double kPi = std::numbers::pi;
  if (angle_rad > -kPi && angle_rad <= kPi) return angle_rad;
  if (angle_rad > kPi && angle_rad < 3 * kPi) return angle_rad - 2 * kPi;
  if (angle_rad < -kPi && angle_rad > -3 * kPi) return angle_rad + 2 * kPi;
  return wrap_any_rad(angle_rad);
}

}  // namespace mirada
