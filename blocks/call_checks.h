#pragma once
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "blocks/native_blocks.h"
#include "robot/messages.h"

namespace mirada::blocks {

using vm::NativeCall;
using vm::NativeResult;

/// A block's meaning that needs a robot: without one it faults in words.
using RobotBlock = std::function<NativeResult(robot::Robot&, NativeCall&)>;
inline vm::NativeFn with_robot(const std::shared_ptr<const Link>& link, RobotBlock block) {
  return [link, block = std::move(block)](NativeCall& call) {
    if (link->robot == nullptr) return NativeResult::failed(messages::no_robot);
    return block(*link->robot, call);
  };
}

/// Why this number cannot be used here; nothing when it is a finite one in [min, max].
inline std::optional<NativeResult> refused(double value, double min, double max, const std::string& unit) {
  if (!std::isfinite(value)) {
    const std::string text = std::isnan(value) ? "NaN" : value > 0 ? "Infinity" : "-Infinity";
    return NativeResult::failed(messages::number_not_finite, {{"value", text}});
  }
  if (value >= min && value <= max) return std::nullopt;
  return NativeResult::failed(
      messages::beyond_limit,
      {{"value", number_text(value)}, {"unit", unit}, {"min", number_text(min)}, {"max", number_text(max)}});
}

}  // namespace mirada::blocks
