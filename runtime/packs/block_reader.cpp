#include "packs/block_reader.h"

#include <algorithm>
#include <set>

#include <nlohmann/json.hpp>

#include "base/messages.h"
#include "packs/messages.h"

namespace mirada::packs {
namespace {

using vm::ArgDef;
using vm::ArgType;
using vm::BlockDef;

constexpr double kAnyNumber = 1e15;

template <class T>
struct Named {
  std::string_view name;
  T value;
};

constexpr Named<vm::Shape> kShapes[] = {{"command", vm::Shape::command}, {"reporter", vm::Shape::reporter},
                                        {"boolean", vm::Shape::boolean}, {"hat", vm::Shape::hat},
                                        {"cap", vm::Shape::cap},         {"c_block", vm::Shape::c_block}};

constexpr Named<ArgType> kArgTypes[] = {{"number", ArgType::number}, {"angle", ArgType::angle},
                                        {"text", ArgType::text},     {"boolean", ArgType::boolean},
                                        {"menu", ArgType::menu},     {"variable", ArgType::variable},
                                        {"list", ArgType::list},     {"broadcast", ArgType::broadcast},
                                        {"key", ArgType::key},       {"statements", ArgType::statements}};

template <class T, std::size_t N>
T value_of(const Named<T> (&table)[N], const std::string& name) {
  const auto* row =
      std::find_if(std::begin(table), std::end(table), [&](const auto& r) { return r.name == name; });
  return row == std::end(table) ? table[0].value : row->value;
}

bool is_field_type(ArgType type) {
  return type == ArgType::menu || type == ArgType::variable || type == ArgType::list ||
         type == ArgType::broadcast || type == ArgType::key;
}

std::string default_text(JsonReader& json) {
  if (!json.has("default")) return "";
  const nlohmann::json& value = json.json().at("default");
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number()) return number_text(value.get<double>(), 10);
  if (value.is_object()) return read_languages(json, "default").en;
  json.fault("default", messages::wrong_default, {{"value", short_json(value)}});
  return "";
}

void read_options(JsonReader& json, ArgDef& arg) {
  std::string choices;
  for (JsonReader option : json.objects("options", 200)) {
    vm::MenuOption row;
    row.value = option.text("value");
    const TwoLanguages text = read_languages(option, "text");
    row.en = text.en;
    row.es = text.es;
    option.only({"value", "text"});
    choices += (choices.empty() ? "" : ", ") + row.value;
    arg.options.push_back(std::move(row));
  }
  if (arg.options.empty()) {
    json.fault("options", messages::empty_list);
    return;
  }
  const bool offered = std::any_of(arg.options.begin(), arg.options.end(),
                                   [&](const auto& row) { return row.value == arg.default_value; });
  if (!offered) {
    json.fault("default", messages::default_not_offered,
               {{"value", arg.default_value}, {"choices", choices}});
  }
}

ArgDef read_arg(JsonReader json) {
  ArgDef arg;
  arg.name = json.text("name");
  if (!is_name(arg.name, true)) json.fault("name", messages::wrong_name, {{"value", arg.name}});
  arg.type = value_of(kArgTypes, json.choice("type", {"number", "angle", "text", "boolean", "menu",
                                                      "variable", "list", "broadcast", "key", "statements"}));
  arg.is_field = is_field_type(arg.type);
  arg.unit = json.text_or("unit", "");
  arg.default_value = default_text(json);
  if (json.has("min")) arg.min = json.number("min", -kAnyNumber, kAnyNumber);
  if (json.has("max")) arg.max = json.number("max", -kAnyNumber, kAnyNumber);
  if (arg.min && arg.max && *arg.min > *arg.max) {
    json.fault("min", messages::range_upside_down,
               {{"min", number_text(*arg.min)}, {"max", number_text(*arg.max)}});
  }
  if (arg.type == ArgType::menu) read_options(json, arg);
  json.only({"name", "type", "unit", "default", "min", "max", "options"});
  return arg;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// Every argument stands exactly once in the sentence, and nothing else stands in brackets.
void check_text(JsonReader& json, const std::string& field, const std::string& text, const BlockDef& block) {
  for (const ArgDef& arg : block.args) {
    if (count(text, "[" + arg.name + "]") != 1) {
      json.fault(field, messages::placeholder_missing, {{"value", arg.name}});
    }
  }
  for (std::size_t open = text.find('['); open != std::string::npos; open = text.find('[', open + 1)) {
    const std::size_t close = text.find(']', open);
    if (close == std::string::npos) break;
    const std::string name = text.substr(open + 1, close - open - 1);
    const bool known =
        std::any_of(block.args.begin(), block.args.end(), [&](const auto& a) { return a.name == name; });
    if (!known) json.fault(field, messages::placeholder_unknown, {{"value", name}});
  }
}

void read_args(JsonReader& json, BlockDef& block) {
  std::set<std::string> names;
  for (JsonReader arg : json.objects("args", 50)) {
    block.args.push_back(read_arg(arg));
    const std::string& name = block.args.back().name;
    if (!names.insert(name).second) json.fault("args", messages::twice, {{"value", name}});
  }
}

void read_needs(JsonReader& json, BlockDef& block) {
  if (!json.has("needs")) return;
  const nlohmann::json& needs = json.json().at("needs");
  for (std::size_t i = 0; needs.is_array() && i < needs.size(); ++i) {
    const nlohmann::json& need = needs[i];
    if (need.is_string() && is_name(need.get<std::string>(), false)) {
      block.needs.push_back(need.get<std::string>());
    } else {
      json.fault("needs", messages::wrong_name, {{"value", short_json(need)}});
    }
  }
  if (!needs.is_array()) {
    json.fault("needs", mirada::messages::array_needed,
               {{"min", "0"}, {"max", "10"}, {"value", short_json(needs)}});
  }
}

void bind_native(JsonReader& json, const vm::NativeTable& natives, BlockDef& block) {
  const auto native = natives.find(block.opcode);
  if (native != natives.end()) {
    block.native = native->second;
  } else {
    json.fault("opcode", messages::code_missing, {{"value", block.opcode}});
  }
}

}  // namespace

bool is_name(std::string_view text, bool capitals) {
  const auto allowed = [capitals](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || (capitals && c >= 'A' && c <= 'Z');
  };
  return !text.empty() && text.size() <= 60 && std::all_of(text.begin(), text.end(), allowed);
}

TwoLanguages read_languages(JsonReader& json, std::string_view field) {
  JsonReader text = json.object(field);
  const TwoLanguages out{text.text("en"), text.text("es")};
  return out;
}

vm::BlockDef read_block(JsonReader json, const std::string& pack, const vm::NativeTable& natives) {
  BlockDef block;
  block.pack = pack;
  block.opcode = json.text("opcode");
  if (!is_name(block.opcode, false)) json.fault("opcode", messages::wrong_name, {{"value", block.opcode}});
  block.shape =
      value_of(kShapes, json.choice("shape", {"command", "reporter", "boolean", "hat", "cap", "c_block"}));
  read_args(json, block);
  const TwoLanguages text = read_languages(json, "text");
  block.text_en = text.en;
  block.text_es = text.es;
  check_text(json, "text/en", text.en, block);
  check_text(json, "text/es", text.es, block);
  if (json.has("help")) read_languages(json, "help");
  read_needs(json, block);
  const bool native = json.choice("implementation", {"core", "native"}) == "native";
  block.implementation = native ? vm::Implementation::native : vm::Implementation::core;
  block.visible = json.truth_or("visible", native && !block.needs.empty());
  json.truth_or("toolbox", true);
  if (native) bind_native(json, natives, block);
  json.only(
      {"opcode", "shape", "text", "args", "help", "needs", "implementation", "visible", "toolbox", "cap"});
  return block;
}

}  // namespace mirada::packs
