#pragma once
#include <bit>
#include <cstdint>
#include <string_view>

namespace mirada::vm {

// A place that holds numbers and such texts as "5" keeps both bare: the text sits in the bits of a NaN that
// no arithmetic gives. Whatever computes with it finds a NaN, and only then asks what is behind it.
constexpr std::uint64_t kDigitsTag = 0xFFFCULL << 48;

/// Whether this register holds a text of digits.
inline bool is_digits(double x) { return std::bit_cast<std::uint64_t>(x) >= kDigitsTag; }
/// A text that a number prints as exactly, with no more digits than fit: it may be kept bare.
bool is_canonical_number(std::string_view text);
/// The register for the text that this number prints as, which is canonical.
double digits_of(double number);
/// The number that the text in a register means; anything else stays what it is.
double behind_digits(double x);
/// A register read as a number; what is none is 0.
inline double plain(double x) {
  if (x == x) [[likely]]
    return x;
  return is_digits(x) ? behind_digits(x) : 0;
}

}  // namespace mirada::vm
