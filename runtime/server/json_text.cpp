#include "server/json_text.h"

#include <cmath>

#include <nlohmann/json.hpp>

namespace mirada::server {

using nlohmann::json;

std::string dump(const json& value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); }

json both_languages(const Message& message, const MessageArgs& args) {
  return {{"en", format(message, args, Lang::en)}, {"es", format(message, args, Lang::es)}};
}

json fault_to_json(const Fault& fault) {
  return {{"place", fault.place},
          {"code", std::string(fault.code())},
          {"severity", fault.severity == Severity::error ? "error" : "warning"},
          {"message", both_languages(*fault.message, fault.args)}};
}

json monitor_to_json(const vm::MonitorValue& value) {
  if (value.is_number && std::isfinite(value.number)) return value.number;
  if (value.is_truth) return value.text == "true";
  return value.text;
}

}  // namespace mirada::server
