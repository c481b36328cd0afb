#pragma once
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace mirada::vm {

/// The text of a plain JSON value, numbers in JavaScript's form; empty for anything else.
std::string plain_text(const nlohmann::json& value);
/// A value for a message: what is not plain is only hinted at.
std::string shown_json(const nlohmann::json& value);
/// A field of an object, or null.
const nlohmann::json* find_field(const nlohmann::json& object, const char* name);
std::string text_at(const nlohmann::json& object, const char* name);
bool truth_at(const nlohmann::json& object, const char* name);

}  // namespace mirada::vm
