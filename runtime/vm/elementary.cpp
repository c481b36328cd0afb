#include "vm/elementary.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace mirada::vm {
namespace {

// ln 2 in two parts: multiples of the first are exact.
constexpr double kLn2High = 6.93147180369123816490e-01;
constexpr double kLn2Low = 1.90821492927058770002e-10;

std::uint32_t high_word(double x) {
  return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(x) >> 32);
}

double with_high_word(double x, std::uint32_t high) {
  return std::bit_cast<double>((std::bit_cast<std::uint64_t>(x) & 0xFFFFFFFFULL) |
                               (std::uint64_t{high} << 32));
}

/// What exp(r) needs of t = r^2.
double exponential_series(double t) {
  return t * (1.66666666666666019037e-01 +
              t * (-2.77777777770155933842e-03 +
                   t * (6.61375632143793436117e-05 +
                        t * (-1.65339022054652515390e-06 + t * 4.13813679705723846039e-08))));
}

/// 2^(high + low), as V8 works it out: the divisor holds a term that Sun's has outside, which costs the last
/// bit here and there.
double power_of_two(double high, double low) {
  constexpr double kLn2 = 6.93147180559945286227e-01;
  constexpr double kLn2Upper = 6.93147182464599609375e-01;
  constexpr double kLn2Rest = -1.90465429995776804525e-09;
  const double size = std::fabs(low + high);
  const double whole = upper_half(size) > 0.5 ? std::floor(size + 0.5) : 0;
  const double n = std::copysign(whole, low + high);
  high -= n;
  const double t = upper_half(low + high);
  const double u = t * kLn2Upper;
  const double v = (low - (t - high)) * kLn2 + t * kLn2Rest;
  const double z = u + v;
  const double w = v - (z - u);
  const double zz = z * z;
  const double q = z - exponential_series(zz);
  const double r = (z * q) / ((q - 2.0) - (w + z * w));
  return std::ldexp(1.0 - (r - z), static_cast<int>(n));
}

/// The series of log(1 + f) beyond f - f^2 / 2, for s = f / (2 + f).
double log_series(double s) {
  const double z = s * s;
  const double w = z * z;
  const double odd =
      z * (6.666666666666735130e-01 +
           w * (2.857142874366239149e-01 + w * (1.818357216161805012e-01 + w * 1.479819860511658591e-01)));
  const double even =
      w * (3.999999999940941908e-01 + w * (2.222219843214978396e-01 + w * 1.531383769920937332e-01));
  return odd + even;
}

double log_near_one(double f, double k) {
  if (f == 0) return k == 0 ? 0 : k * kLn2High + k * kLn2Low;
  const double r = f * f * (0.5 - 0.33333333333333333 * f);
  return k == 0 ? f - r : k * kLn2High - ((r - k * kLn2Low) - f);
}

}  // namespace

double logarithm(double x) {
  if (x == 0) return -std::numeric_limits<double>::infinity();
  if (!(x > 0)) return std::numeric_limits<double>::quiet_NaN();
  if (std::isinf(x)) return x;
  int exponent = 0;
  if (x < std::numeric_limits<double>::min()) {
    exponent = -54;
    x *= 18014398509481984.0;  // 2^54
  }
  // x = 2^k (1 + f) with 1 + f between sqrt(1/2) and sqrt(2).
  const std::uint32_t high = high_word(x);
  const std::uint32_t fraction = high & 0xFFFFF;
  const std::uint32_t carry = (fraction + 0x95F64) & 0x100000;
  exponent += static_cast<int>(high >> 20) - 1023 + static_cast<int>(carry >> 20);
  const double f = with_high_word(x, fraction | (carry ^ 0x3FF00000)) - 1.0;
  const double k = exponent;
  if ((0xFFFFF & (2 + fraction)) < 3) return log_near_one(f, k);
  const double s = f / (2.0 + f);
  const double r = log_series(s);
  const auto low = static_cast<std::int32_t>(fraction) - 0x6147A;
  const auto top = 0x6B851 - static_cast<std::int32_t>(fraction);
  if ((low | top) > 0) {
    const double half = 0.5 * f * f;
    return k == 0 ? f - (half - s * (half + r))
                  : k * kLn2High - ((half - (s * (half + r) + k * kLn2Low)) - f);
  }
  return k == 0 ? f - s * (f - r) : k * kLn2High - ((s * (f - r) - k * kLn2Low) - f);
}

double exponential(double x) {
  if (x != x) return x;
  if (x > 7.09782712893383973096e+02) return std::numeric_limits<double>::infinity();
  if (x < -7.45133219101941108420e+02) return 0;
  if (x == 1) return std::numbers::e;
  const std::uint32_t high = high_word(x) & 0x7FFFFFFF;
  if (high < 0x3E300000) return 1.0 + x;
  double upper = x;
  double lower = 0;
  int k = 0;
  if (high > 0x3FD62E42) {  // beyond half of ln 2
    k = high < 0x3FF0A2B2 ? (x < 0 ? -1 : 1)
                          : static_cast<int>(1.44269504088896338700 * x + (x < 0 ? -0.5 : 0.5));
    upper = x - k * kLn2High;
    lower = k * kLn2Low;
  }
  const double r = upper - lower;
  const double t = r * r;
  const double c = r - exponential_series(t);
  if (k == 0) return 1.0 - ((r * c) / (c - 2.0) - r);
  return std::ldexp(1.0 - ((lower - (r * c) / (2.0 - c)) - upper), k);
}

double power_of_ten(double x) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  // The binary logarithm of 10 in two parts.
  constexpr double kLog2Of10High = 3.3219280242919921875;
  constexpr double kLog2Of10Low = 7.0595370160369406338e-8;
  if (x != x) return x;
  if (x == 1) return 10;
  if (x == 2) return 100;
  if (x == 0.5) return std::sqrt(10.0);
  if (x == -1) return 0.1;
  if (x > 309) return kInfinity;
  if (x < -324) return 0;
  const double upper = upper_half(x);
  const double high = upper * kLog2Of10High;
  const double low = (x - upper) * kLog2Of10High + x * kLog2Of10Low;
  return power_of_two(high, low);
}

}  // namespace mirada::vm
