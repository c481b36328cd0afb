#pragma once
#include <optional>
#include <string>

#include "base/result.h"
#include "model/place.h"

namespace mirada::rig {

/// What a robot is told of where it is. `asked`: the id of a place that ships or a file; "" = nothing. Every
/// fault of the file at once.
Result<std::optional<Place>> choose_place(const std::string& asked);

}  // namespace mirada::rig
