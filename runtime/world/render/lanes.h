#pragma once
#include <bit>
#include <cstdint>
#include <cstring>
#include <numbers>

#include <opencv2/core/hal/intrin.hpp>

#include "world/render/per_cpu.h"

namespace mirada::world {

/// Eight numbers at once, in GCC's and Clang's own vector types: what a CPU cannot do at once is done in
/// halves. Functions that take or give them are always inlined, since how they are passed depends on the CPU.
using Floats = float __attribute__((vector_size(32)));
using Ints = std::int32_t __attribute__((vector_size(32)));
/// The channels of four pixels, or both neighbours' of two.
using Words = std::uint16_t __attribute__((vector_size(32)));
using Bytes = std::uint8_t __attribute__((vector_size(16)));
#define MIRADA_LANES [[gnu::always_inline]] inline

template <typename Vector, typename Element>
MIRADA_LANES Vector load_lanes(const Element* from) {
  Vector out;
  std::memcpy(&out, from, sizeof out);
  return out;
}

MIRADA_LANES Floats all_lanes(float value) {
  return Floats{value, value, value, value, value, value, value, value};
}
MIRADA_LANES Ints all_lanes(std::int32_t value) {
  return Ints{value, value, value, value, value, value, value, value};
}
template <typename Vector>
MIRADA_LANES Vector least(Vector a, Vector b) {
  return a < b ? a : b;
}
template <typename Vector>
MIRADA_LANES Vector most(Vector a, Vector b) {
  return a > b ? a : b;
}

MIRADA_LANES Floats root(Floats of) {
  float lanes[8];
  std::memcpy(lanes, &of, sizeof of);
  for (int i = 0; i < 8; i += 4) cv::v_store(lanes + i, cv::v_sqrt(cv::v_load(lanes + i)));
  return load_lanes<Floats>(lanes);
}

/// The angle of (x, y), -pi to pi, within 0.0004: a polynomial in the smaller over the larger part.
MIRADA_LANES Floats arc_tangent(Floats y, Floats x) {
  constexpr float kHalfTurn = std::numbers::pi_v<float>;
  const Floats ax = most(x, -x);
  const Floats ay = most(y, -y);
  const Floats a = least(ax, ay) / most(most(ax, ay), all_lanes(1e-20F));
  const Floats a2 = a * a;
  const Floats octant = ((-0.0464964749F * a2 + 0.15931422F) * a2 - 0.327622764F) * a2 * a + a;
  const Floats quadrant = ay > ax ? kHalfTurn / 2 - octant : octant;
  const Floats half = x < 0 ? kHalfTurn - quadrant : quadrant;
  return y < 0 ? -half : half;
}

/// Of each lane's index, below 8, what the table holds there.
MIRADA_LANES Ints looked_up(Ints table, Ints index) {
#ifdef __clang__
  Ints out;
  for (int i = 0; i < 8; ++i) out[i] = table[index[i]];
  return out;
#else
  return __builtin_shuffle(table, index);
#endif
}

/// Sixteen bytes, given as two numbers, as words.
MIRADA_LANES Words widened(std::uint64_t low, std::uint64_t high) {
  using Halves = std::uint64_t __attribute__((vector_size(16)));
  return __builtin_convertvector(std::bit_cast<Bytes>(Halves{low, high}), Words);
}

}  // namespace mirada::world
