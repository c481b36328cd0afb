#pragma once
#include <optional>
#include <vector>

#include "fuzz/reference/casts.h"
#include "fuzz/reference/tree.h"

namespace mirada::vm::reference {

/// What a program leaves.
struct Outcome {
  std::vector<Value> variables{};
  std::vector<std::vector<Value>> lists{};
};

/// Runs a tree as Scratch steps its scripts, plainly and slowly. Nothing when the program does too much to be
/// worth comparing (it may not end).
std::optional<Outcome> evaluate(const Tree& tree);

}  // namespace mirada::vm::reference
