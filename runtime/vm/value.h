#pragma once
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

namespace mirada::vm {

/// Counts the bytes that one machine's texts and lists hold, so that its memory stays bounded.
struct Heap {
  std::size_t used = 0;
};

/// An immutable, counted text: ASCII bytes or UTF-16 units, so that length and letters are as Scratch counts
/// them. Belongs to one thread.
struct Text {
  Heap* heap;
  std::uint32_t count;
  std::uint32_t length;  ///< in UTF-16 units
  bool wide;

  const char* ascii() const { return reinterpret_cast<const char*>(this + 1); }
  const char16_t* units() const { return reinterpret_cast<const char16_t*>(this + 1); }
  char* ascii() { return reinterpret_cast<char*>(this + 1); }
  char16_t* units() { return reinterpret_cast<char16_t*>(this + 1); }
  char16_t at(std::uint32_t i) const { return wide ? units()[i] : static_cast<unsigned char>(ascii()[i]); }
  std::string_view ascii_view() const { return {ascii(), length}; }
};

Text* new_text(Heap& heap, std::uint32_t length, bool wide);  ///< count 1; the content is not set
void free_text(Text* text);

/// A number, a text or a truth in 64 bits: texts and truths live in the patterns that no arithmetic gives
/// (NaN boxing).
class Value {
 public:
  Value() : bits_(0) {}  // the number 0
  explicit Value(double number)
      : bits_(std::bit_cast<std::uint64_t>(number == number ? number
                                                            : std::numeric_limits<double>::quiet_NaN())) {}
  explicit Value(bool truth) : bits_(kTruth | static_cast<std::uint64_t>(truth)) {}
  /// Takes over the caller's count.
  explicit Value(Text* text) : bits_(kText | reinterpret_cast<std::uintptr_t>(text)) {}
  Value(const Value& other) : bits_(other.bits_) { retain(); }
  Value(Value&& other) noexcept : bits_(std::exchange(other.bits_, 0)) {}
  Value& operator=(const Value& other) {
    other.retain();
    release();
    bits_ = other.bits_;
    return *this;
  }
  Value& operator=(Value&& other) noexcept {
    if (this != &other) {
      release();
      bits_ = std::exchange(other.bits_, 0);
    }
    return *this;
  }
  ~Value() { release(); }

  bool is_number() const { return bits_ < kText; }
  bool is_text() const { return (bits_ & kTagMask) == kText; }
  bool is_truth() const { return (bits_ & kTagMask) == kTruth; }
  double number() const { return std::bit_cast<double>(bits_); }
  bool truth() const { return (bits_ & 1) != 0; }
  Text* text() const { return reinterpret_cast<Text*>(bits_ & ~kTagMask); }

 private:
  static constexpr std::uint64_t kTagMask = 0xFFFFULL << 48;
  static constexpr std::uint64_t kText = 0xFFFAULL << 48;
  static constexpr std::uint64_t kTruth = 0xFFFBULL << 48;

  void retain() const {
    if (is_text()) ++text()->count;
  }
  void release() const {
    if (is_text() && --text()->count == 0) free_text(text());
  }
  std::uint64_t bits_;
};
static_assert(sizeof(Value) == 8);

Value make_text(Heap& heap, std::string_view utf8);
Value make_text(Heap& heap, std::u16string_view units);
/// UTF-8; a lone surrogate becomes U+FFFD. Of a longer text no more than so many units, and a sign that it
/// goes on.
std::string to_utf8(const Text& text, std::size_t most = SIZE_MAX);
std::u16string utf16_of(std::string_view utf8);

/// JavaScript's Number(text), of any text; NaN when it is none.
double number_of(std::string_view utf8);

// Scratch's casts (its util/cast.js).
double to_number(const Value& value);
bool to_truth(const Value& value);
/// The value as text: itself when it is one.
Value to_text(Heap& heap, const Value& value);
std::string to_string(const Value& value);

/// Below, at or above zero, as Scratch orders two values: as numbers when both are, else as texts without
/// case.
double compare(const Value& a, const Value& b);
/// compare() of two numbers, NaN included.
inline bool equal_numbers(double a, double b) { return a == b || (a != a && b != b); }
inline bool less_numbers(double a, double b) { return a < b || (b != b && a == a); }

/// Whether Scratch takes it for a whole number when it draws at random: a text without a point, an integral
/// number.
bool is_whole(const Value& value);

}  // namespace mirada::vm
