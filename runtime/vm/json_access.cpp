#include "vm/json_access.h"

#include <nlohmann/json.hpp>

#include "vm/numbers.h"

namespace mirada::vm {

std::string plain_text(const nlohmann::json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "true" : "false";
  if (value.is_number()) return number_to_string(value.get<double>());
  return {};
}

std::string shown_json(const nlohmann::json& value) {
  if (value.is_structured()) return value.is_array() ? "[...]" : "{...}";
  const std::string text = value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return text.size() <= 40 ? text : text.substr(0, 37) + "...";
}

const nlohmann::json* find_field(const nlohmann::json& object, const char* name) {
  if (!object.is_object()) return nullptr;
  const auto it = object.find(name);
  return it == object.end() ? nullptr : &*it;
}

std::string text_at(const nlohmann::json& object, const char* name) {
  const nlohmann::json* value = find_field(object, name);
  return value ? plain_text(*value) : std::string();
}

bool truth_at(const nlohmann::json& object, const char* name) {
  const nlohmann::json* value = find_field(object, name);
  return value && value->is_boolean() && value->get<bool>();
}

}  // namespace mirada::vm
