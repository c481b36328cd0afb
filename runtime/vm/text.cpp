#include "vm/text.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "vm/letter_case.h"

namespace mirada::vm {
namespace {

constexpr std::uint32_t kLettersUnasked = 1 << 16;

bool lowers_by_unit(const Text& text) {
  return !text.wide || std::all_of(text.units(), text.units() + text.length, lowers_alone);
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
  const std::u16string changed = lowers_by_unit(whole) ? std::u16string() : lowered(whole);
  const std::uint32_t length = changed.empty() ? whole.length : static_cast<std::uint32_t>(changed.size());
  for (std::uint32_t i = 0, matched = 0; i < length; ++i) {
    if (tired(i)) return std::nullopt;
    const char16_t letter = changed.empty() ? lower_case(whole.at(i)) : changed[i];
    while (matched > 0 && letter != needle[matched]) matched = border[matched];
    if (letter == needle[matched]) ++matched;
    if (matched == needle.size()) return true;
  }
  return false;
}

}  // namespace mirada::vm
