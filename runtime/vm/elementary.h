#pragma once
#include <bit>
#include <cstdint>

namespace mirada::vm {

// What JavaScript engines give, to the last bit: they follow the reductions and coefficients that Sun
// published with fdlibm, while C libraries round a little differently.
double logarithm(double x);
double exponential(double x);
double power_of_ten(double x);
// In radians.
double arc_sine(double x);
double arc_cosine(double x);
double arc_tangent(double x);

/// The number with the lower half of its bits cleared.
inline double upper_half(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & ~0xFFFFFFFFULL);
}

}  // namespace mirada::vm
