#include "vm/text.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <string>

#include "vm/letter_case.h"

namespace mirada::vm {
namespace {

std::u16string lowered(const Text& text) {
  std::u16string out(text.length, u'\0');
  for (std::uint32_t i = 0; i < text.length; ++i) out[i] = lower_case(text.at(i));
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

bool contains_text(const Text& whole, const Text& part) {
  if (part.length == 0) return true;
  if (part.length > whole.length) return false;
  const std::u16string haystack = lowered(whole);
  const std::u16string needle = lowered(part);
  if (needle.size() < 32) return haystack.find(needle) != std::u16string::npos;
  const std::boyer_moore_horspool_searcher searcher(needle.begin(), needle.end());
  return std::search(haystack.begin(), haystack.end(), searcher) != haystack.end();
}

}  // namespace mirada::vm
