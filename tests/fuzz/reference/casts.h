#pragma once
#include <string>
#include <variant>

namespace mirada::vm::reference {

/// What a block gives. All texts are ASCII here.
using Value = std::variant<double, std::string, bool>;

// Scratch's casts, written from docs/scratch-rules.md and nothing else.
double to_number(const Value& value);
std::string to_text(const Value& value);
bool to_truth(const Value& value);
/// Below, at or above zero.
int compare(const Value& a, const Value& b);

}  // namespace mirada::vm::reference
