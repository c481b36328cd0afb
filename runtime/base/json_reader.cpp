#include "base/json_reader.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "base/messages.h"

namespace mirada {
namespace {

const nlohmann::json& empty_object() {
  static const nlohmann::json empty = nlohmann::json::object();
  return empty;
}

/// Whether anything lies more than two levels deep: writing such a value out recurses once a level.
bool is_deep(const nlohmann::json& value) {
  for (const auto& inner : value) {
    if (!inner.is_structured()) continue;
    for (const auto& item : inner) {
      if (item.is_structured()) return true;
    }
  }
  return false;
}

MessageArgs range_args(std::string field, double min, double max) {
  return {{"field", std::move(field)}, {"min", number_text(min, 6)}, {"max", number_text(max, 6)}};
}

}  // namespace

std::string short_json(const nlohmann::json& value) {
  if (value.is_structured() && is_deep(value)) return value.is_array() ? "[...]" : "{...}";
  const std::string text = value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return text.size() <= 40 ? text : text.substr(0, 37) + "...";
}

Result<nlohmann::json> parse_json(std::string_view text, const std::string& place) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    return make_fault(place, messages::json_broken, {{"byte", std::to_string(error.byte)}});
  } catch (const nlohmann::json::out_of_range&) {
    return make_fault(place, messages::json_number_too_large);
  }
}

JsonReader::JsonReader(const nlohmann::json& object, std::string path, Faults& faults)
    : object_(&object), path_(std::move(path)), faults_(&faults) {
  if (!object.is_object()) {
    faults_->push_back(make_fault(path_, messages::object_needed,
                                  {{"field", path_.empty() ? "/" : path_}, {"value", short_json(object)}}));
    object_ = &empty_object();
  }
}

const nlohmann::json* JsonReader::find(std::string_view field) const {
  const auto it = object_->find(std::string(field));
  return it == object_->end() ? nullptr : &*it;
}

bool JsonReader::has(std::string_view field) const { return find(field) != nullptr; }

void JsonReader::fault(std::string_view field, const Message& message, MessageArgs args) {
  const std::string place = path_ + "/" + std::string(field);
  args.emplace_back("field", place);
  faults_->push_back(make_fault(place, message, std::move(args)));
}

double JsonReader::checked(const nlohmann::json& value, std::string_view field, double min, double max,
                           double fallback) {
  if (value.is_number()) {
    const double number = value.get<double>();
    if (std::isfinite(number) && number >= min && number <= max) return number;
  }
  MessageArgs args = range_args(path_ + "/" + std::string(field), min, max);
  args.emplace_back("value", short_json(value));
  faults_->push_back(make_fault(args.front().second, messages::number_needed, args));
  return fallback;
}

double JsonReader::number(std::string_view field, double min, double max) {
  const double fallback = min <= 0 && max >= 0 ? 0 : min;
  if (const nlohmann::json* value = find(field)) return checked(*value, field, min, max, fallback);
  const std::string place = path_ + "/" + std::string(field);
  faults_->push_back(make_fault(place, messages::number_missing, range_args(place, min, max)));
  return fallback;
}

double JsonReader::number_or(std::string_view field, double min, double max, double fallback) {
  const nlohmann::json* value = find(field);
  return value ? checked(*value, field, min, max, fallback) : fallback;
}

std::string JsonReader::text(std::string_view field) {
  if (!has(field)) fault(field, messages::field_missing);
  return text_or(field, "");
}

std::string JsonReader::text_or(std::string_view field, std::string fallback) {
  const nlohmann::json* value = find(field);
  if (!value) return fallback;
  if (value->is_string()) return value->get<std::string>();
  fault(field, messages::text_needed, {{"value", short_json(*value)}});
  return fallback;
}

bool JsonReader::truth_or(std::string_view field, bool fallback) {
  const nlohmann::json* value = find(field);
  if (!value) return fallback;
  if (value->is_boolean()) return value->get<bool>();
  fault(field, messages::truth_needed, {{"value", short_json(*value)}});
  return fallback;
}

bool JsonReader::truth(std::string_view field) {
  if (!has(field)) fault(field, messages::field_missing);
  return truth_or(field, false);
}

std::string JsonReader::choice(std::string_view field, std::initializer_list<std::string_view> choices) {
  const nlohmann::json* value = find(field);
  std::string list;
  for (const std::string_view choice : choices) {
    if (value && value->is_string() && value->get_ref<const std::string&>() == choice)
      return std::string(choice);
    list += (list.empty() ? "" : ", ") + std::string(choice);
  }
  if (value)
    fault(field, messages::choice_needed, {{"choices", list}, {"value", short_json(*value)}});
  else
    fault(field, messages::choice_missing, {{"choices", list}});
  return std::string(*choices.begin());
}

std::vector<double> JsonReader::numbers(std::string_view field, std::size_t min_size, std::size_t max_size,
                                        double min, double max) {
  const nlohmann::json* value = find(field);
  if (!value || !value->is_array() || value->size() < min_size || value->size() > max_size) {
    fault(field, messages::array_needed,
          {{"min", std::to_string(min_size)},
           {"max", std::to_string(max_size)},
           {"value", value ? short_json(*value) : "-"}});
    return std::vector<double>(min_size, 0.0);
  }
  std::vector<double> out;
  for (std::size_t i = 0; i < value->size(); ++i) {
    out.push_back(checked((*value)[i], std::string(field) + "/" + std::to_string(i), min, max, 0.0));
  }
  return out;
}

JsonReader JsonReader::object(std::string_view field) {
  const nlohmann::json* value = find(field);
  return JsonReader(value ? *value : empty_object(), path_ + "/" + std::string(field), *faults_);
}

std::optional<JsonReader> JsonReader::object_if_present(std::string_view field) {
  if (!has(field)) return std::nullopt;
  return object(field);
}

std::vector<JsonReader> JsonReader::objects(std::string_view field, std::size_t max_size) {
  std::vector<JsonReader> out;
  const nlohmann::json* value = find(field);
  if (!value) return out;
  if (!value->is_array() || value->size() > max_size) {
    fault(field, messages::array_needed,
          {{"min", "0"}, {"max", std::to_string(max_size)}, {"value", short_json(*value)}});
    return out;
  }
  for (std::size_t i = 0; i < value->size(); ++i) {
    out.emplace_back((*value)[i], path_ + "/" + std::string(field) + "/" + std::to_string(i), *faults_);
  }
  return out;
}

void JsonReader::only(std::initializer_list<std::string_view> known) {
  std::string list;
  for (const std::string_view name : known) list += (list.empty() ? "" : ", ") + std::string(name);
  for (const auto& [name, value] : object_->items()) {
    bool found = false;
    for (const std::string_view candidate : known) found = found || name == candidate;
    if (found) continue;
    const std::string place = path_ + "/" + name;
    faults_->push_back(
        make_fault(place, messages::field_unknown, {{"field", place}, {"known", list}}, Severity::warning));
  }
}

}  // namespace mirada
