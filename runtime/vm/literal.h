#pragma once
#include <string_view>

#include "vm/ast.h"

namespace mirada::vm {

/// The field of a literal's shadow ("NUM", "TEXT"), or null when this block is no literal.
const Field* literal_field(const Block& block);

}  // namespace mirada::vm
