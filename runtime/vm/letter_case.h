#pragma once
#include <cstddef>
#include <string_view>

namespace mirada::vm {

/// The lower-case form of one UTF-16 unit, for comparisons that ignore case. Units without one stay.
char16_t lower_case(char16_t unit);

/// A text's units as JavaScript's toLowerCase gives them, one after the other. It is more than lower_case()
/// of each: the dotted capital I becomes two units, the capital sigma another letter at a word's end, and
/// some capitals are two units themselves. The text must outlive it.
class LowerCase {
 public:
  /// From `place` on, or a little before: where the text behind can no longer change what is given.
  explicit LowerCase(std::u16string_view text, std::size_t place = 0);
  /// Of a text that begins as the other's does, from where the other began.
  LowerCase(std::u16string_view text, const LowerCase& beside)
      : text_(text), start_(beside.start_), at_(beside.start_) {}

  bool more() const { return at_ < text_.size() || pending_ != 0; }
  char16_t next() {
    const char16_t unit = at_ < text_.size() ? text_[at_] : u'\0';
    if (pending_ != 0 || is_special(unit)) return next_special();
    ++at_;
    return lower_case(unit);
  }
  /// Goes past the next unit of both where it is the same letter whatever stands around it.
  bool skip_same(LowerCase& other) {
    if (at_ >= text_.size() || other.at_ >= other.text_.size() || text_[at_] != other.text_[other.at_])
      return false;
    if (text_[at_] == 0x03A3 || pending_ != other.pending_) return false;
    ++at_;
    ++other.at_;
    return true;
  }

 private:
  static bool is_special(char16_t unit) {
    return unit >= 0x0130 && (unit == 0x0130 || unit == 0x03A3 || (unit >= 0xDC00 && unit < 0xE000));
  }
  char16_t next_special();

  std::u16string_view text_;
  std::size_t start_;
  std::size_t at_;
  char16_t pending_ = 0;
};

}  // namespace mirada::vm
