#include "vm/text.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "vm/letter_case.h"

namespace mirada::vm {
namespace {

constexpr std::uint32_t kLettersUnasked = 1 << 16;

/// A text's units in lower case, one after the other: plain ASCII without ado.
class Letters {
 public:
  explicit Letters(const Text& text)
      : ascii_(text.wide ? std::string_view() : text.ascii_view()),
        wide_(text.wide ? std::u16string_view(text.units(), text.length) : std::u16string_view()) {}
  bool more() const { return at_ < ascii_.size() || wide_.more(); }
  char16_t next() {
    return at_ < ascii_.size() ? lower_case(static_cast<unsigned char>(ascii_[at_++])) : wide_.next();
  }

 private:
  std::string_view ascii_;
  std::size_t at_ = 0;
  LowerCase wide_;
};

std::u16string lowered(const Text& text) {
  std::u16string out;
  out.reserve(text.length);
  for (Letters letters(text); letters.more();) out += letters.next();
  return out;
}

}  // namespace

std::size_t joined_bytes(const Text& a, const Text& b) {
  const std::size_t unit = a.wide || b.wide ? 2 : 1;
  return (static_cast<std::size_t>(a.length) + b.length) * unit;
}

Value joined(Heap& heap, const Text& a, const Text& b) {
  Text* out = new_text(heap, a.length + b.length, a.wide || b.wide);
  if (!out->wide) {
    std::memcpy(out->ascii(), a.ascii(), a.length);
    std::memcpy(out->ascii() + a.length, b.ascii(), b.length);
    return Value(out);
  }
  char16_t* to = out->units();
  for (const Text* part : {&a, &b}) {
    for (std::uint32_t i = 0; i < part->length; ++i) *to++ = part->at(i);
  }
  return Value(out);
}

Value letter_of(Heap& heap, const Text& text, double place) {
  if (!(place >= 0 && place < text.length)) return make_text(heap, std::string_view());
  const char16_t unit = text.at(static_cast<std::uint32_t>(place));
  return make_text(heap, std::u16string_view(&unit, 1));
}

std::optional<bool> contains_text(const Text& whole, const Text& part, const std::atomic<bool>& give_up) {
  if (part.length == 0) return true;
  const auto tired = [&](std::uint32_t i) { return i % kLettersUnasked == 0 && give_up.load(); };
  // Knuth, Morris, Pratt: border[i] is the length of the longest start of `needle` that ends before letter i.
  const std::u16string needle = lowered(part);
  std::vector<std::uint32_t> border(needle.size() + 1, 0);
  for (std::uint32_t i = 1, matched = 0; i < needle.size(); ++i) {
    if (tired(i)) return std::nullopt;
    while (matched > 0 && needle[i] != needle[matched]) matched = border[matched];
    if (needle[i] == needle[matched]) ++matched;
    border[i + 1] = matched;
  }
  Letters letters(whole);
  for (std::uint32_t i = 0, matched = 0; letters.more(); ++i) {
    if (tired(i)) return std::nullopt;
    const char16_t letter = letters.next();
    while (matched > 0 && letter != needle[matched]) matched = border[matched];
    if (letter == needle[matched]) ++matched;
    if (matched == needle.size()) return true;
  }
  return false;
}

}  // namespace mirada::vm
