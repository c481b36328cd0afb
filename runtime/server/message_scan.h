#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace mirada::server {

/// The members of the outermost object of a JSON text, each with its value's text. A program inside is passed
/// on as it came: it may be nested as deeply as its sender likes and is never built as a tree here. Only what
/// is needed to find the members is checked; whoever reads a value parses it.
struct ScannedObject {
  std::map<std::string, std::string_view, std::less<>> members;  ///< of two with one name the last
  std::optional<std::size_t> broken_at;  ///< the byte where the text stops making sense
};

/// The views point into `text`.
ScannedObject scan_object(std::string_view text);

}  // namespace mirada::server
