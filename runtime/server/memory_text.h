#pragma once
#include <string>

#include "memory/snapshot.h"

namespace mirada::server {

/// The telemetry's `memory` (docs/protocol.md).
std::string memory_text(const memory::Snapshot& memory);

}  // namespace mirada::server
