// Arc sine, arc cosine and arc tangent: reductions and coefficients as Sun published them with fdlibm.
#include <cmath>
#include <limits>

#include "vm/elementary.h"

namespace mirada::vm {
namespace {

// Parts of pi; its half in two parts.
constexpr double kQuarterPi = 7.85398163397448278999e-01;
constexpr double kHalfPi = 1.57079632679489655800e+00;
constexpr double kHalfPiRest = 6.12323399573676603587e-17;
constexpr double kWholePi = 3.14159265358979311600e+00;

/// (asin(x) - x) / x for t = x^2 up to a quarter.
double arc_series(double t) {
  const double above =
      t * (1.66666666666666657415e-01 +
           t * (-3.25565818622400915405e-01 +
                t * (2.01212532134862925881e-01 +
                     t * (-4.00555345006794114027e-02 +
                          t * (7.91534994289814532176e-04 + t * 3.47933107596021167570e-05)))));
  const double below = 1.0 + t * (-2.40339491173441421878e+00 +
                                  t * (2.02094576023350569471e+00 +
                                       t * (-6.88283971605453293030e-01 + t * 7.70381505559019352791e-02)));
  return above / below;
}

/// For x from 0.5 to 1: pi/2 less twice the arc sine of the root of (1 - x) / 2.
double arc_sine_near_one(double x) {
  const double t = (1.0 - x) * 0.5;
  const double s = std::sqrt(t);
  const double r = arc_series(t);
  if (upper_half(x) >= 0x1.f3333p-1) {  // 0.975
    return kHalfPi - (2.0 * (s + s * r) - kHalfPiRest);
  }
  const double upper = upper_half(s);
  const double c = (t - upper * upper) / (s + upper);
  const double p = 2.0 * s * r - (kHalfPiRest - 2.0 * c);
  const double q = kQuarterPi - 2.0 * upper;
  return kQuarterPi - (p - q);
}

/// (x - atan(x)) / x for z = x^2.
double tangent_series(double z) {
  const double w = z * z;
  const double odd =
      z * (3.33333333333329318027e-01 +
           w * (1.42857142725034663711e-01 +
                w * (9.09088713343650656196e-02 +
                     w * (6.66107313738753120669e-02 +
                          w * (4.97687799461593236017e-02 + w * 1.62858201153657823623e-02)))));
  const double even = w * (-1.99999999998764832476e-01 +
                           w * (-1.11111104054623557880e-01 +
                                w * (-7.69187620504482999495e-02 +
                                     w * (-5.83357013379057348645e-02 + w * -3.65315727442169155270e-02))));
  return odd + even;
}

/// The angle (in two parts) and what x, the tangent of the rest, adds.
double arc_tangent_from(double angle, double angle_rest, double x) {
  return angle - ((x * tangent_series(x * x) - angle_rest) - x);
}

double arc_tangent_of_positive(double x) {
  if (x < 0.6875)
    return arc_tangent_from(4.63647609000806093515e-01, 2.26987774529616870924e-17,
                            (2.0 * x - 1.0) / (2.0 + x));
  if (x < 1.1875) return arc_tangent_from(kQuarterPi, 3.06161699786838301793e-17, (x - 1.0) / (x + 1.0));
  if (x < 2.4375)
    return arc_tangent_from(9.82793723247329054082e-01, 1.39033110312309984516e-17,
                            (x - 1.5) / (1.0 + 1.5 * x));
  return arc_tangent_from(kHalfPi, kHalfPiRest, -1.0 / x);
}

}  // namespace

double arc_sine(double x) {
  const double size = std::fabs(x);
  if (size == 1) return x * kHalfPi + x * kHalfPiRest;
  if (!(size < 1)) return std::numeric_limits<double>::quiet_NaN();
  if (size < 0x1p-27) return x;
  if (size < 0.5) return x + x * arc_series(x * x);
  return std::copysign(arc_sine_near_one(size), x);
}

double arc_cosine(double x) {
  if (x == 1) return 0;
  if (x == -1) return kWholePi + 2.0 * kHalfPiRest;
  if (!(std::fabs(x) < 1)) return std::numeric_limits<double>::quiet_NaN();
  if (std::fabs(x) < 0x1p-57) return kHalfPi + kHalfPiRest;
  if (std::fabs(x) < 0.5) return kHalfPi - (x - (kHalfPiRest - x * arc_series(x * x)));
  const double z = (1.0 - std::fabs(x)) * 0.5;
  const double s = std::sqrt(z);
  if (x < 0) return kWholePi - 2.0 * (s + (arc_series(z) * s - kHalfPiRest));
  const double upper = upper_half(s);
  const double c = (z - upper * upper) / (s + upper);
  return 2.0 * (upper + (arc_series(z) * s + c));
}

double arc_tangent(double x) {
  const double size = std::fabs(x);
  if (x != x || size < 0x1p-29) return x;
  if (size >= 0x1p66) return std::copysign(kHalfPi + kHalfPiRest, x);
  if (size < 0.4375) return x - x * tangent_series(x * x);
  return std::copysign(arc_tangent_of_positive(size), x);
}

}  // namespace mirada::vm
