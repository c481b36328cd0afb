#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mirada {

enum class Lang { en, es };

/// "en" or "es"; nothing for another word.
std::optional<Lang> lang_from(std::string_view code);

/// One sentence shown to people, in every language that we speak; `{name}` marks an argument. Rooms define
/// theirs as `inline constexpr Message` in a file `messages.h`, so that no language can lack a sentence.
struct Message {
  std::string_view code;  ///< stable, machine-readable: "unknown_block"
  std::string_view en;
  std::string_view es;
};

using MessageArgs = std::vector<std::pair<std::string, std::string>>;

/// The sentence with its arguments put in. An argument that the sentence does not name is ignored.
std::string format(const Message& message, const MessageArgs& args, Lang lang);

/// A number as people write it: up to `digits` decimals, no trailing zeros.
std::string number_text(double value, int digits = 3);

}  // namespace mirada
