#include "vm/numbers.h"

#include <array>
#include <cassert>
#include <charconv>
#include <cstdlib>
#include <limits>
#include <numbers>

#include "vm/elementary.h"

namespace mirada::vm {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::array<std::string_view, static_cast<std::size_t>(MathFn::count)> kMathNames = {
    "abs",  "floor", "ceiling", "sqrt", "sin", "cos", "tan",
    "asin", "acos",  "atan",    "ln",   "log", "e ^", "10 ^"};

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

int digit_value(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return 99;
}

double based_number(std::string_view digits, int base) {
  if (digits.empty()) return kNaN;
  double number = 0;
  for (const char c : digits) {
    const int digit = digit_value(c);
    if (digit >= base) return kNaN;
    number = number * base + digit;
  }
  return number;
}

/// Digits with at most one point, at least one digit, then perhaps an exponent: what from_chars may be
/// trusted with.
bool is_decimal(std::string_view text) {
  std::size_t i = 0;
  std::size_t digits = 0;
  bool point = false;
  for (; i < text.size(); ++i) {
    if (text[i] >= '0' && text[i] <= '9') {
      ++digits;
    } else if (text[i] == '.' && !point) {
      point = true;
    } else {
      break;
    }
  }
  if (digits == 0) return false;
  if (i == text.size()) return true;
  if (text[i] != 'e' && text[i] != 'E') return false;
  ++i;
  if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
  if (i == text.size()) return false;
  for (; i < text.size(); ++i) {
    if (text[i] < '0' || text[i] > '9') return false;
  }
  return true;
}

double decimal_number(std::string_view text) {
  bool negative = false;
  if (text.front() == '+' || text.front() == '-') {
    negative = text.front() == '-';
    text.remove_prefix(1);
  }
  double number = kNaN;
  if (text == "Infinity") {
    number = kInfinity;
  } else if (is_decimal(text)) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error == std::errc::result_out_of_range) number = std::strtod(std::string(text).c_str(), nullptr);
  }
  return negative ? -number : number;
}

/// Puts the digits of a shortest representation where String() puts the point. `exponent` is that of the
/// first digit.
std::string placed(std::string_view digits, int exponent) {
  const int count = static_cast<int>(digits.size());
  if (exponent >= 21 || exponent < -6) {
    std::string out(1, digits[0]);
    if (count > 1) out.append(".").append(digits.substr(1));
    return out + (exponent < 0 ? "e-" : "e+") + std::to_string(std::abs(exponent));
  }
  if (exponent < 0)
    return "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + std::string(digits);
  if (exponent >= count - 1) {
    return std::string(digits) + std::string(static_cast<std::size_t>(exponent - count + 1), '0');
  }
  const auto before = static_cast<std::size_t>(exponent) + 1;
  return std::string(digits.substr(0, before)) + "." + std::string(digits.substr(before));
}

double tenth_decimal(double x) { return std::nearbyint(x * 1e10) / 1e10; }

/// Number(x.toFixed(10)): round half away, with JavaScript's exactness for the sizes that sines have.
double to_fixed_10(double x) {
  if (x == 0) return 0;
  char buffer[64];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, x, std::chars_format::fixed, 10);
  if (error != std::errc{}) return tenth_decimal(x);
  double number = 0;
  std::from_chars(buffer, end, number);
  return number;
}

double tangent(double degrees) {
  const double angle = std::fmod(degrees, 360.0);
  if (angle == -270 || angle == 90) return kInfinity;
  if (angle == -90 || angle == 270) return -kInfinity;
  return to_fixed_10(std::tan(std::numbers::pi * angle / 180.0));
}

}  // namespace

std::string number_to_string(double number) {
  if (number != number) return "NaN";
  if (number == 0) return "0";
  if (std::isinf(number)) return number > 0 ? "Infinity" : "-Infinity";
  char buffer[40];
  const auto whole = static_cast<std::int64_t>(std::fabs(number) < 1e15 ? number : 0.0);
  if (static_cast<double>(whole) == number) {
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, whole).ptr};
  }
  const char* end =
      std::to_chars(buffer, buffer + sizeof buffer, std::fabs(number), std::chars_format::scientific).ptr;
  const std::string_view all(buffer, static_cast<std::size_t>(end - buffer));
  const std::size_t e = all.find('e');
  std::string digits(1, all[0]);
  if (e > 2) digits += all.substr(2, e - 2);
  const int exponent = std::atoi(std::string(all.substr(e + 1)).c_str());
  return (number < 0 ? "-" : "") + placed(digits, exponent);
}

double string_to_number(std::string_view ascii) {
  const std::string_view text = trimmed(ascii);
  if (text.empty()) return 0;
  if (text.size() > 2 && text[0] == '0') {
    const char kind = static_cast<char>(text[1] | 0x20);
    if (kind == 'x') return based_number(text.substr(2), 16);
    if (kind == 'o') return based_number(text.substr(2), 8);
    if (kind == 'b') return based_number(text.substr(2), 2);
  }
  return decimal_number(text);
}

bool is_blank(std::string_view ascii) { return trimmed(ascii).empty(); }

MathFn math_fn(std::string_view name) {
  std::size_t i = 0;
  while (i < kMathNames.size() && kMathNames[i] != name) ++i;
  return static_cast<MathFn>(i);
}

std::string_view math_fn_name(MathFn fn) { return kMathNames[static_cast<std::size_t>(fn)]; }

double apply_math(MathFn fn, double x) {
  constexpr double kPi = std::numbers::pi;
  switch (fn) {
    case MathFn::abs:
      return std::fabs(x);
    case MathFn::floor:
      return std::floor(x);
    case MathFn::ceiling:
      return std::ceil(x);
    case MathFn::sqrt:
      return std::sqrt(x);
    case MathFn::sin:
      return to_fixed_10(std::sin(kPi * x / 180.0));
    case MathFn::cos:
      return to_fixed_10(std::cos(kPi * x / 180.0));
    case MathFn::tan:
      return tangent(x);
    case MathFn::asin:
      return arc_sine(x) * 180.0 / kPi;
    case MathFn::acos:
      return arc_cosine(x) * 180.0 / kPi;
    case MathFn::atan:
      return arc_tangent(x) * 180.0 / kPi;
    case MathFn::ln:
      return logarithm(x);
    case MathFn::log:
      return logarithm(x) / std::numbers::ln10;
    case MathFn::exp:
      return exponential(x);
    case MathFn::pow10:
      return power_of_ten(x);
    case MathFn::count:
      break;
  }
  assert(false);
  return 0;
}

}  // namespace mirada::vm
