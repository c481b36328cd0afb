#include "vm/digits.h"

#include <algorithm>
#include <cassert>
#include <string>

#include "vm/numbers.h"

namespace mirada::vm {
namespace {

// Below the tag: a bit for the sign, four for how many digits stand behind the point, 45 for the digits.
constexpr int kMantissaBits = 45;
constexpr int kPlacesBits = 4;
constexpr std::size_t kMostDigits = 13;  // 10^13 < 2^45
constexpr std::uint64_t kMantissaMask = (1ULL << kMantissaBits) - 1;
constexpr std::uint64_t kPlacesMask = (1ULL << kPlacesBits) - 1;
constexpr double kPowers[] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                              1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

bool is_canonical_number(std::string_view text) {
  const auto digits = std::count_if(text.begin(), text.end(), is_digit);
  if (digits == 0 || digits > static_cast<std::ptrdiff_t>(kMostDigits)) return false;
  const bool may_be =
      std::all_of(text.begin(), text.end(), [](char c) { return is_digit(c) || c == '.' || c == '-'; });
  return may_be && number_to_string(string_to_number(text)) == text;
}

double digits_of(double number) {
  const std::string text = number_to_string(number);
  assert(is_canonical_number(text));
  std::uint64_t mantissa = 0;
  std::uint64_t places = 0;
  bool behind_point = false;
  for (const char c : text) {
    behind_point = behind_point || c == '.';
    if (!is_digit(c)) continue;
    mantissa = mantissa * 10 + static_cast<std::uint64_t>(c - '0');
    places += behind_point ? 1 : 0;
  }
  const std::uint64_t sign = number < 0 ? 1 : 0;
  return std::bit_cast<double>(kDigitsTag | sign << (kMantissaBits + kPlacesBits) | places << kMantissaBits |
                               mantissa);
}

double behind_digits(double x) {
  if (!is_digits(x)) return x;
  const auto bits = std::bit_cast<std::uint64_t>(x);
  // Both are exact, so the quotient is the number that the digits mean.
  const double size =
      static_cast<double>(bits & kMantissaMask) / kPowers[bits >> kMantissaBits & kPlacesMask];
  return (bits >> (kMantissaBits + kPlacesBits) & 1) != 0 ? -size : size;
}

}  // namespace mirada::vm
