#include "vm/value.h"

#include <algorithm>
#include <cstring>
#include <new>

#include "vm/letter_case.h"
#include "vm/numbers.h"

namespace mirada::vm {
namespace {

std::size_t bytes_of(std::uint32_t length, bool wide) {
  return sizeof(Text) + static_cast<std::size_t>(length) * (wide ? 2 : 1);
}

/// JavaScript's white space beyond ASCII.
bool is_wide_space(char16_t u) {
  return u == 0xA0 || u == 0xFEFF || u == 0x1680 || (u >= 0x2000 && u <= 0x200A) || u == 0x2028 ||
         u == 0x2029 || u == 0x202F || u == 0x205F || u == 0x3000;
}

/// A wide text as ASCII for the number grammar: its spaces become plain ones, any other unit breaks every
/// number.
std::string ascii_of(const Text& text) {
  std::string out(text.length, '?');
  for (std::uint32_t i = 0; i < text.length; ++i) {
    const char16_t u = text.at(i);
    if (u < 0x80) out[i] = static_cast<char>(u);
    if (is_wide_space(u)) out[i] = ' ';
  }
  return out;
}

struct Reading {
  double number;
  bool is_number;  ///< neither blank nor something else
};

Reading reading_of(const Text& text) {
  const std::string narrow = text.wide ? ascii_of(text) : std::string();
  const std::string_view view = text.wide ? std::string_view(narrow) : text.ascii_view();
  const double number = string_to_number(view);
  return {number, number == number && !(number == 0 && is_blank(view))};
}

Reading reading_of(const Value& value) {
  if (value.is_number()) return {value.number(), value.number() == value.number()};
  if (value.is_truth()) return {value.truth() ? 1.0 : 0.0, true};
  return reading_of(*value.text());
}

char32_t next_code_point(std::string_view utf8, std::size_t& i) {
  const auto lead = static_cast<unsigned char>(utf8[i++]);
  if (lead < 0x80) return lead;
  const int more = lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : 1;
  if (lead < 0xC2 || lead > 0xF4 || i + static_cast<std::size_t>(more) > utf8.size()) return 0xFFFD;
  char32_t point = lead & (0x3F >> more);
  for (int k = 0; k < more; ++k) {
    const auto byte = static_cast<unsigned char>(utf8[i + static_cast<std::size_t>(k)]);
    if ((byte & 0xC0) != 0x80) return 0xFFFD;
    point = (point << 6) | (byte & 0x3F);
  }
  i += static_cast<std::size_t>(more);
  const bool overlong = (more == 2 && point < 0x800) || (more == 3 && point < 0x10000);
  return overlong || point > 0x10FFFF || (point >= 0xD800 && point < 0xE000) ? 0xFFFD : point;
}

void append_utf8(std::string& out, char32_t point) {
  if (point < 0x80) {
    out += static_cast<char>(point);
    return;
  }
  const int more = point < 0x800 ? 1 : point < 0x10000 ? 2 : 3;
  static constexpr unsigned char kLead[] = {0, 0xC0, 0xE0, 0xF0};
  out += static_cast<char>(kLead[more] | (point >> (6 * more)));
  for (int k = more - 1; k >= 0; --k) out += static_cast<char>(0x80 | ((point >> (6 * k)) & 0x3F));
}

double compare_ascii(std::string_view a, std::string_view b) {
  const std::size_t common = std::min(a.size(), b.size());
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? c + 32 : c + 0; };
  for (std::size_t i = 0; i < common; ++i) {
    if (a[i] == b[i]) continue;
    if (const int x = lower(a[i]), y = lower(b[i]); x != y) return x < y ? -1 : 1;
  }
  return a.size() == b.size() ? 0 : a.size() < b.size() ? -1 : 1;
}

std::u16string widened(std::string_view ascii) { return {ascii.begin(), ascii.end()}; }

/// How many units at the front are the same, told block by block.
std::size_t same_front(std::u16string_view a, std::u16string_view b) {
  constexpr std::size_t kBlock = 512;
  const std::size_t common = std::min(a.size(), b.size());
  std::size_t at = 0;
  while (at + kBlock <= common && std::memcmp(&a[at], &b[at], kBlock * sizeof(char16_t)) == 0) at += kBlock;
  while (at < common && a[at] == b[at]) ++at;
  return at;
}

double compare_units(std::u16string_view a, std::u16string_view b) {
  LowerCase left(a, same_front(a, b));
  LowerCase right(b, left);
  while (left.more() && right.more()) {
    if (left.skip_same(right)) continue;
    const char16_t x = left.next();
    const char16_t y = right.next();
    if (x != y) return x < y ? -1 : 1;
  }
  return left.more() ? 1 : right.more() ? -1 : 0;
}

double compare_texts(const Text& a, const Text& b) {
  if (!a.wide && !b.wide) return compare_ascii(a.ascii_view(), b.ascii_view());
  const std::u16string wide_a = a.wide ? std::u16string() : widened(a.ascii_view());
  const std::u16string wide_b = b.wide ? std::u16string() : widened(b.ascii_view());
  return compare_units(a.wide ? std::u16string_view(a.units(), a.length) : wide_a,
                       b.wide ? std::u16string_view(b.units(), b.length) : wide_b);
}

}  // namespace

Text* new_text(Heap& heap, std::uint32_t length, bool wide) {
  const std::size_t bytes = bytes_of(length, wide);
  heap.used += bytes;
  return new (::operator new(bytes)) Text{&heap, 1, length, wide};
}

void free_text(Text* text) {
  text->heap->used -= bytes_of(text->length, text->wide);
  ::operator delete(text);
}

Value make_text(Heap& heap, std::string_view utf8) {
  const bool ascii =
      std::all_of(utf8.begin(), utf8.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  if (!ascii) return make_text(heap, utf16_of(utf8));
  Text* text = new_text(heap, static_cast<std::uint32_t>(utf8.size()), false);
  if (!utf8.empty()) std::memcpy(text->ascii(), utf8.data(), utf8.size());
  return Value(text);
}

Value make_text(Heap& heap, std::u16string_view units) {
  const bool wide = std::any_of(units.begin(), units.end(), [](char16_t u) { return u >= 0x80; });
  Text* text = new_text(heap, static_cast<std::uint32_t>(units.size()), wide);
  for (std::size_t i = 0; i < units.size(); ++i) {
    if (wide) {
      text->units()[i] = units[i];
    } else {
      text->ascii()[i] = static_cast<char>(units[i]);
    }
  }
  return Value(text);
}

std::u16string utf16_of(std::string_view utf8) {
  std::u16string out;
  for (std::size_t i = 0; i < utf8.size();) {
    const char32_t point = next_code_point(utf8, i);
    if (point < 0x10000) {
      out += static_cast<char16_t>(point);
    } else {
      out += static_cast<char16_t>(0xD7C0 + (point >> 10));
      out += static_cast<char16_t>(0xDC00 + (point & 0x3FF));
    }
  }
  return out;
}

std::string to_utf8(const Text& text, std::size_t most) {
  const char* const rest = text.length > most ? "\u2026" : "";
  if (!text.wide) return std::string(text.ascii_view().substr(0, most)) + rest;
  std::string out;
  for (std::uint32_t i = 0; i < text.length && i < most; ++i) {
    const char16_t u = text.units()[i];
    if (u < 0xD800 || u >= 0xE000) {
      append_utf8(out, u);
    } else if (u < 0xDC00 && i + 1 < text.length && (text.units()[i + 1] & 0xFC00) == 0xDC00) {
      append_utf8(out, 0x10000 + ((u - 0xD800U) << 10) + (text.units()[++i] - 0xDC00U));
    } else {
      append_utf8(out, 0xFFFD);
    }
  }
  return out + rest;
}

double number_of(std::string_view utf8) {
  Heap scratch;
  return reading_of(*make_text(scratch, utf8).text()).number;
}

double to_number(const Value& value) {
  const double number = value.is_number() ? value.number() : reading_of(value).number;
  return number == number ? number : 0;
}

bool to_truth(const Value& value) {
  if (value.is_truth()) return value.truth();
  if (value.is_number()) return value.number() != 0 && value.number() == value.number();
  const Text& text = *value.text();
  if (text.wide || text.length == 0) return text.length != 0;
  const std::string_view view = text.ascii_view();
  if (view == "0") return false;
  if (view.size() != 5) return true;
  constexpr std::string_view kFalse = "false";
  return !std::equal(view.begin(), view.end(), kFalse.begin(),
                     [](char c, char f) { return (c | 0x20) == f; });
}

Value to_text(Heap& heap, const Value& value) {
  if (value.is_text()) return value;
  if (value.is_truth()) return make_text(heap, std::string_view(value.truth() ? "true" : "false"));
  return make_text(heap, number_to_string(value.number()));
}

std::string to_string(const Value& value) {
  if (value.is_text()) return to_utf8(*value.text());
  if (value.is_truth()) return value.truth() ? "true" : "false";
  return number_to_string(value.number());
}

double compare(const Value& a, const Value& b) {
  const Reading x = reading_of(a);
  const Reading y = x.is_number ? reading_of(b) : Reading{0, false};
  if (x.is_number && y.is_number) return x.number == y.number ? 0 : x.number - y.number;
  Heap scratch;
  return compare_texts(*to_text(scratch, a).text(), *to_text(scratch, b).text());
}

bool is_whole(const Value& value) {
  if (value.is_truth()) return true;
  if (value.is_number()) {
    const double n = value.number();
    if (n != n) return true;
    // parseInt reads the digits before an exponent, so a number that is printed with one is not whole to
    // Scratch.
    return std::fabs(n) < 1e21 && std::trunc(n) == n;
  }
  const Text& text = *value.text();
  for (std::uint32_t i = 0; i < text.length; ++i) {
    if (text.at(i) == '.') return false;
  }
  return true;
}

}  // namespace mirada::vm
