#pragma once
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace mirada::vm {

/// JavaScript's String(number): shortest digits that read back the same, exponents from 1e21 and below 1e-6.
std::string number_to_string(double number);
/// JavaScript's Number(text); NaN when it is none. Blank text is 0.
double string_to_number(std::string_view ascii);
/// Whether Number() of a text is a number only because it is blank.
bool is_blank(std::string_view ascii);

/// Scratch's mod: the remainder has the divisor's sign. Exact; whole numbers never go through fmod.
inline double modulo(double a, double b) {
  constexpr double kMost = 2147483647;
  const bool small = std::fabs(a) <= kMost && b >= 1 && b <= kMost;
  const auto ia = small ? static_cast<std::int32_t>(a) : 0;
  const auto ib = small ? static_cast<std::int32_t>(b) : 0;
  if (static_cast<double>(ia) == a && static_cast<double>(ib) == b && ib > 0) {
    const std::int32_t r = ia % ib;
    if (r == 0) return std::copysign(0.0, a);
    return r < 0 ? r + ib : r;
  }
  const double r = std::fmod(a, b);
  return r / b < 0 ? r + b : r;
}

/// JavaScript's Math.round: halves go up.
inline double round_half_up(double x) {
  if (!(std::fabs(x) < 4503599627370496.0)) return x;
  const auto whole = static_cast<double>(static_cast<std::int64_t>(x));
  const double down = whole > x ? whole - 1 : whole;
  const double result = x - down >= 0.5 ? down + 1 : down;
  return result == 0 ? std::copysign(0.0, x) : result;
}

/// Math.floor without a library call.
inline double floor_of(double x) {
  if (!(std::fabs(x) < 4503599627370496.0)) return x;
  const auto whole = static_cast<double>(static_cast<std::int64_t>(x));
  if (whole == 0 && x >= 0) return x == 0 ? x : 0.0;
  const double down = whole > x ? whole - 1 : whole;
  return down;
}

enum class MathFn : std::uint8_t {
  abs,
  floor,
  ceiling,
  sqrt,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  ln,
  log,
  exp,
  pow10,
  count
};
/// Scratch's names ("abs", "e ^"); count when there is none such.
MathFn math_fn(std::string_view name);
std::string_view math_fn_name(MathFn fn);
/// Angles in degrees; sine and cosine rounded to ten decimals, as Scratch does.
double apply_math(MathFn fn, double x);

}  // namespace mirada::vm
