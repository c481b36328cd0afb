#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace mirada::vm {

/// Takes JSON apart from the front (RFC 8259), token by token; JsonTree puts them together. The first thing
/// that is no JSON breaks it: nothing more is taken then.
class JsonScanner {
 public:
  explicit JsonScanner(std::string_view text);

  bool broken() const { return broken_; }
  std::size_t place() const { return at_ + 1; }  ///< of the next byte, from 1; of what broke it
  bool number_too_large() const { return number_too_large_; }

  /// The next byte that is no space; 0 at the end.
  char peek();
  /// Whether nothing but spaces is left.
  bool at_end() { return peek() == '\0' && at_ >= text_.size(); }
  /// Whether the next byte that is no space is this one; takes it then.
  bool take(char wanted);
  /// A word such as "true", or broken.
  void word(std::string_view wanted);
  double number();
  /// Behind its opening quote: appended as UTF-8, half a surrogate pair as U+FFFD. Its size in bytes.
  std::size_t text(std::string& out);
  void fail() { broken_ = true; }

 private:
  char byte() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void digits();
  void escape(std::string& out);
  void letter(std::string& out);
  unsigned hex4();

  std::string_view text_;
  std::size_t at_ = 0;
  bool broken_ = false;
  bool number_too_large_ = false;
};

}  // namespace mirada::vm
