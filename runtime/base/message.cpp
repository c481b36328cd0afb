#include "base/message.h"

#include <fmt/format.h>

namespace mirada {

std::optional<Lang> lang_from(std::string_view code) {
  if (code == "en") return Lang::en;
  if (code == "es") return Lang::es;
  return std::nullopt;
}

std::string format(const Message& message, const MessageArgs& args, Lang lang) {
  const std::string_view pattern = lang == Lang::es ? message.es : message.en;
  std::string out;
  for (std::size_t i = 0; i < pattern.size();) {
    const std::size_t close = pattern[i] == '{' ? pattern.find('}', i) : std::string_view::npos;
    if (close == std::string_view::npos) {
      out += pattern[i++];
      continue;
    }
    const std::string_view name = pattern.substr(i + 1, close - i - 1);
    for (const auto& [key, value] : args) {
      if (key == name) out += value;
    }
    i = close + 1;
  }
  return out;
}

std::string number_text(double value, int digits) {
  std::string text = fmt::format("{:.{}f}", value, digits);
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

}  // namespace mirada
