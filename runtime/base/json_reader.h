#pragma once
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "base/result.h"

namespace mirada {

/// Parses text as JSON; the fault says at which byte it breaks. Duplicate keys: the last wins.
Result<nlohmann::json> parse_json(std::string_view text, const std::string& place);

/// A value as a fault shows it: at most 40 characters, and no more than its brackets where it is deep
/// (writing such a value out would recurse as deep).
std::string short_json(const nlohmann::json& value);

/// Reads the fields of one JSON object and collects every fault with its path ("/camera/fx_px"). A getter
/// that fails adds a fault and gives a harmless value, so that one pass finds all of them. The JSON must
/// outlive the reader.
class JsonReader {
 public:
  JsonReader(const nlohmann::json& object, std::string path, Faults& faults);

  bool has(std::string_view field) const;
  double number(std::string_view field, double min, double max);
  double number_or(std::string_view field, double min, double max, double fallback);
  std::string text(std::string_view field);
  std::string text_or(std::string_view field, std::string fallback);
  /// `field_missing` when it is absent.
  bool truth(std::string_view field);
  bool truth_or(std::string_view field, bool fallback);
  /// One of `choices`; the first of them when it fails.
  std::string choice(std::string_view field, std::initializer_list<std::string_view> choices);
  /// A list of min..max numbers; `min_size` to `max_size` of them.
  std::vector<double> numbers(std::string_view field, std::size_t min_size, std::size_t max_size, double min,
                              double max);
  /// A reader on a nested object; on an empty object (whose required fields then fault) when it is missing.
  JsonReader object(std::string_view field);
  /// The same, or nothing and no fault when the field is absent.
  std::optional<JsonReader> object_if_present(std::string_view field);
  /// One reader an element of a list of objects; empty when the field is absent.
  std::vector<JsonReader> objects(std::string_view field, std::size_t max_size = 10'000);

  /// Adds a warning for every field that is not in `known`: a typing error must not be silent.
  void only(std::initializer_list<std::string_view> known);
  void fault(std::string_view field, const Message& message, MessageArgs args = {});
  const nlohmann::json& json() const { return *object_; }
  const std::string& path() const { return path_; }

 private:
  const nlohmann::json* find(std::string_view field) const;
  double checked(const nlohmann::json& value, std::string_view field, double min, double max,
                 double fallback);

  const nlohmann::json* object_;
  std::string path_;
  Faults* faults_;
};

}  // namespace mirada
