#include "fuzz/reference/casts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace mirada::vm::reference {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string trimmed(const std::string& text) {
  const std::size_t from = text.find_first_not_of(" \t\n\v\f\r");
  if (from == std::string::npos) return "";
  return text.substr(from, text.find_last_not_of(" \t\n\v\f\r") - from + 1);
}

double whole_number(const std::string& digits, int base) {
  char* end = nullptr;
  if (digits.empty() || !std::isxdigit(static_cast<unsigned char>(digits[0]))) return kNaN;
  const auto number = std::strtoull(digits.c_str(), &end, base);
  return *end == '\0' ? static_cast<double>(number) : kNaN;
}

/// JavaScript's Number(text).
double number_of(const std::string& raw) {
  const std::string text = trimmed(raw);
  if (text.empty()) return 0;
  if (text.size() > 2 && text[0] == '0') {
    if (text[1] == 'x' || text[1] == 'X') return whole_number(text.substr(2), 16);
    if (text[1] == 'b' || text[1] == 'B') return whole_number(text.substr(2), 2);
    if (text[1] == 'o' || text[1] == 'O') return whole_number(text.substr(2), 8);
  }
  const bool sign = text[0] == '-' || text[0] == '+';
  const std::string bare = sign ? text.substr(1) : text;
  if (bare == "Infinity") return text[0] == '-' ? -kInfinity : kInfinity;
  std::size_t i = 0;
  std::size_t digits = 0;
  const auto go_over_digits = [&] {
    for (; i < bare.size() && std::isdigit(static_cast<unsigned char>(bare[i])); ++i) ++digits;
  };
  go_over_digits();
  if (i < bare.size() && bare[i] == '.') ++i;
  go_over_digits();
  if (digits == 0) return kNaN;
  if (i < bare.size() && (bare[i] == 'e' || bare[i] == 'E')) {
    ++i;
    if (i < bare.size() && (bare[i] == '-' || bare[i] == '+')) ++i;
    digits = 0;
    go_over_digits();
    if (digits == 0) return kNaN;
  }
  return i == bare.size() ? std::strtod(text.c_str(), nullptr) : kNaN;
}

bool is_blank(const std::string& text) { return trimmed(text).empty(); }

/// JavaScript's String(number): the fewest digits that read back the same.
std::string text_of(double number) {
  if (std::isnan(number)) return "NaN";
  if (std::isinf(number)) return number < 0 ? "-Infinity" : "Infinity";
  if (number == 0) return "0";
  char buffer[40];
  for (int precision = 0; precision <= 16; ++precision) {
    std::snprintf(buffer, sizeof buffer, "%.*e", precision, std::fabs(number));
    if (std::strtod(buffer, nullptr) == std::fabs(number)) break;
  }
  std::string digits;
  const std::string written(buffer);
  const std::size_t e = written.find('e');
  for (std::size_t i = 0; i < e; ++i) {
    if (written[i] != '.') digits += written[i];
  }
  while (digits.size() > 1 && digits.back() == '0') digits.pop_back();
  const int point = std::atoi(written.c_str() + e + 1) + 1;  // digits before the point
  const int count = static_cast<int>(digits.size());
  std::string out = number < 0 ? "-" : "";
  if (point > 21 || point < -5) {
    out += digits.substr(0, 1) + (count > 1 ? "." + digits.substr(1) : "");
    return out + "e" + (point > 0 ? "+" : "-") + std::to_string(std::abs(point - 1));
  }
  if (point <= 0) return out + "0." + std::string(static_cast<std::size_t>(-point), '0') + digits;
  if (count <= point) return out + digits + std::string(static_cast<std::size_t>(point - count), '0');
  return out + digits.substr(0, static_cast<std::size_t>(point)) + "." +
         digits.substr(static_cast<std::size_t>(point));
}

std::string lowered(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// For comparing: NaN where it is no number, blank texts too.
double comparable(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return is_blank(*text) ? kNaN : number_of(*text);
  if (const auto* truth = std::get_if<bool>(&value)) return *truth ? 1 : 0;
  return std::get<double>(value);
}

}  // namespace

double to_number(const Value& value) {
  double number = 0;
  if (const auto* text = std::get_if<std::string>(&value)) {
    number = number_of(*text);
  } else {
    number = comparable(value);
  }
  return std::isnan(number) ? 0 : number;
}

std::string to_text(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* truth = std::get_if<bool>(&value)) return *truth ? "true" : "false";
  return text_of(std::get<double>(value));
}

bool to_truth(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) {
    return !text->empty() && *text != "0" && lowered(*text) != "false";
  }
  if (const auto* truth = std::get_if<bool>(&value)) return *truth;
  const double number = std::get<double>(value);
  return number != 0 && !std::isnan(number);
}

int compare(const Value& a, const Value& b) {
  const double x = comparable(a);
  const double y = comparable(b);
  if (!std::isnan(x) && !std::isnan(y)) return x < y ? -1 : x > y ? 1 : 0;
  const std::string left = lowered(to_text(a));
  const std::string right = lowered(to_text(b));
  return left < right ? -1 : left > right ? 1 : 0;
}

}  // namespace mirada::vm::reference
