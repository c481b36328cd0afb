#include "server/message_scan.h"

namespace mirada::server {
namespace {

constexpr std::string_view kSpace = " \t\r\n";

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  ScannedObject object() {
    ScannedObject out;
    if (!members(out)) out.broken_at = at_;
    return out;
  }

 private:
  bool members(ScannedObject& out) {
    if (!take('{')) return false;
    if (!take('}')) {
      do {
        if (!member(out)) return false;
      } while (take(','));
      if (!take('}')) return false;
    }
    skip_space();
    return at_ == text_.size();
  }

  bool member(ScannedObject& out) {
    skip_space();
    const std::size_t key_begin = at_;
    if (!string()) return false;
    const std::string key(text_.substr(key_begin + 1, at_ - key_begin - 2));
    if (!take(':')) return false;
    skip_space();
    const std::size_t value_begin = at_;
    if (!value()) return false;
    const std::string_view with_space = text_.substr(value_begin, at_ - value_begin);
    out.members[key] = with_space.substr(0, with_space.find_last_not_of(kSpace) + 1);
    return true;
  }

  bool value() {
    std::size_t depth = 0;
    const std::size_t begin = at_;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '"') {
        if (!string()) return false;
        continue;
      }
      if (depth == 0 && (c == ',' || c == '}' || c == ']')) return at_ > begin;
      if (c == '{' || c == '[') ++depth;
      if (c == '}' || c == ']') --depth;
      ++at_;
    }
    return false;
  }

  bool string() {
    if (at_ >= text_.size() || text_[at_] != '"') return false;
    for (++at_; at_ < text_.size(); ++at_) {
      if (text_[at_] == '\\') {
        ++at_;
      } else if (text_[at_] == '"') {
        ++at_;
        return true;
      }
    }
    at_ = text_.size();
    return false;
  }

  bool take(char wanted) {
    skip_space();
    if (at_ >= text_.size() || text_[at_] != wanted) return false;
    ++at_;
    return true;
  }

  void skip_space() {
    while (at_ < text_.size() && kSpace.find(text_[at_]) != std::string_view::npos) ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

ScannedObject scan_object(std::string_view text) { return Scanner(text).object(); }

}  // namespace mirada::server
