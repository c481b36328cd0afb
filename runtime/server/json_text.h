#pragma once
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "base/fault.h"
#include "vm/machine.h"

namespace mirada::server {

/// JSON text in which bytes that are no UTF-8 became U+FFFD: what a child typed must never stop a message.
std::string dump(const nlohmann::json& value);

nlohmann::json fault_to_json(const Fault& fault);
nlohmann::json both_languages(const Message& message, const MessageArgs& args);
/// Finite numbers as numbers, truth as true or false, the rest as Scratch's text.
nlohmann::json monitor_to_json(const vm::MonitorValue& value);

}  // namespace mirada::server
