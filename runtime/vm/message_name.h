#pragma once
#include <string>
#include <string_view>

#include "vm/value.h"

namespace mirada::vm {

/// What two names of a message have in common when they mean the same one: case is ignored.
std::string message_key(std::string_view name);

}  // namespace mirada::vm
