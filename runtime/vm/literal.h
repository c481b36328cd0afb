#pragma once
#include <string_view>

#include "vm/ast.h"

namespace mirada::vm {

/// The field of a literal's shadow ("NUM", "TEXT"), or null when this block is no literal.
const Field* literal_field(const Block& block);
/// A text that a number prints as exactly, without an exponent: it may be kept as that number and nobody can
/// tell.
bool is_canonical_number(std::string_view text);

}  // namespace mirada::vm
