#include "vm/json_scanner.h"

#include <charconv>
#include <cmath>
#include <cstdlib>

namespace mirada::vm {
namespace {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_plain(char c) { return c >= ' ' && c < '\x7f' && c != '"' && c != '\\'; }
constexpr bool is_high(unsigned unit) { return unit >= 0xD800 && unit < 0xDC00; }
constexpr bool is_low(unsigned unit) { return unit >= 0xDC00 && unit < 0xE000; }
constexpr unsigned kNoLetter = 0xFFFD;

void append_utf8(std::string& out, unsigned code) {
  if (code < 0x80) {
    out += static_cast<char>(code);
  } else if (code < 0x800) {
    out += {static_cast<char>(0xC0 | code >> 6), static_cast<char>(0x80 | (code & 0x3F))};
  } else if (code < 0x10000) {
    out += {static_cast<char>(0xE0 | code >> 12), static_cast<char>(0x80 | (code >> 6 & 0x3F)),
            static_cast<char>(0x80 | (code & 0x3F))};
  } else {
    out += {static_cast<char>(0xF0 | code >> 18), static_cast<char>(0x80 | (code >> 12 & 0x3F)),
            static_cast<char>(0x80 | (code >> 6 & 0x3F)), static_cast<char>(0x80 | (code & 0x3F))};
  }
}

/// How many bytes the letter at the front takes; 0 when it is no UTF-8 (or none that is allowed: overlong,
/// half a surrogate pair, beyond the last letter).
std::size_t utf8_size(std::string_view text) {
  const auto at = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const auto within = [&](std::size_t i, unsigned low, unsigned high) {
    return at(i) >= low && at(i) <= high;
  };
  const unsigned first = at(0);
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return within(1, 0x80, 0xBF) ? 2 : 0;
  if (first >= 0xE0 && first <= 0xEF) {
    const bool second = within(1, first == 0xE0 ? 0xA0 : 0x80, first == 0xED ? 0x9F : 0xBF);
    return second && within(2, 0x80, 0xBF) ? 3 : 0;
  }
  if (first < 0xF0 || first > 0xF4) return 0;
  const bool second = within(1, first == 0xF0 ? 0x90 : 0x80, first == 0xF4 ? 0x8F : 0xBF);
  return second && within(2, 0x80, 0xBF) && within(3, 0x80, 0xBF) ? 4 : 0;
}

}  // namespace

JsonScanner::JsonScanner(std::string_view text) : text_(text) {
  if (text.starts_with("\xEF\xBB\xBF")) at_ = 3;
}

char JsonScanner::peek() {
  while (byte() == ' ' || byte() == '\n' || byte() == '\t' || byte() == '\r') ++at_;
  return byte();
}

bool JsonScanner::take(char wanted) {
  if (at_ >= text_.size() || peek() != wanted) return false;
  ++at_;
  return true;
}

void JsonScanner::word(std::string_view wanted) {
  if (!text_.substr(at_).starts_with(wanted)) return fail();
  at_ += wanted.size();
}

void JsonScanner::digits() {
  if (!is_digit(byte())) fail();
  while (is_digit(byte())) ++at_;
}

double JsonScanner::number() {
  const std::size_t start = at_;
  if (byte() == '-') ++at_;
  if (byte() == '0') {
    ++at_;
  } else {
    digits();
  }
  if (byte() == '.') {
    ++at_;
    digits();
  }
  if (byte() == 'e' || byte() == 'E') {
    ++at_;
    if (byte() == '+' || byte() == '-') ++at_;
    digits();
  }
  if (broken_) return 0;
  double out = 0;
  const auto read = std::from_chars(text_.data() + start, text_.data() + at_, out);
  if (read.ec != std::errc::result_out_of_range) return out;
  out = std::strtod(std::string(text_.substr(start, at_ - start)).c_str(),
                    nullptr);  // very small, or too large
  if (std::isinf(out)) {
    number_too_large_ = true;
    fail();
  }
  return out;
}

std::size_t JsonScanner::text(std::string& out) {
  const std::size_t before = out.size();
  while (!broken_) {
    const std::size_t start = at_;
    while (is_plain(byte())) ++at_;
    out.append(text_, start, at_ - start);
    if (byte() == '"') break;
    if (byte() == '\\') {
      ++at_;
      escape(out);
    } else {
      letter(out);
    }
  }
  if (!broken_) ++at_;
  return out.size() - before;
}

/// One that is more than a plain ASCII letter.
void JsonScanner::letter(std::string& out) {
  const std::size_t size = utf8_size(text_.substr(at_));
  if (at_ >= text_.size() || static_cast<unsigned char>(byte()) < ' ' || size == 0) return fail();
  out.append(text_, at_, size);
  at_ += size;
}

/// Behind the backslash.
void JsonScanner::escape(std::string& out) {
  constexpr std::string_view kNames = "\"\\/bfnrt";
  constexpr std::string_view kLetters = "\"\\/\b\f\n\r\t";
  const std::size_t known = kNames.find(byte());
  if (at_ < text_.size() && known != std::string_view::npos) {
    ++at_;
    out += kLetters[known];
    return;
  }
  if (byte() != 'u') return fail();
  ++at_;
  unsigned code = hex4();
  if (is_high(code) && text_.substr(at_).starts_with("\\u")) {
    const std::size_t behind = at_;
    at_ += 2;
    const unsigned low = hex4();
    if (is_low(low)) {
      code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
    } else {
      at_ = behind;
    }
  }
  append_utf8(out, is_high(code) || is_low(code) ? kNoLetter : code);
}

unsigned JsonScanner::hex4() {
  unsigned out = 0;
  for (int i = 0; i < 4 && !broken_; ++i) {
    const char c = byte();
    const char lower = static_cast<char>(c | 0x20);
    const bool hex = is_digit(c) || (lower >= 'a' && lower <= 'f');
    if (!hex) fail();
    if (hex) ++at_;
    out = out * 16 + static_cast<unsigned>(is_digit(c) ? c - '0' : lower - 'a' + 10);
  }
  return out;
}

}  // namespace mirada::vm
