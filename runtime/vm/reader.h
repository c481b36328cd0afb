#pragma once
#include <string_view>

#include "base/result.h"
#include "vm/ast.h"

namespace mirada::vm {

/// What was read and everything that is wrong with its form. The program is whole enough to be validated as
/// far as it goes, so that one answer can hold the faults of form and of meaning.
struct ReadProgram {
  Program program;
  Faults faults;
};

/// The editor's envelope or a bare Blockly workspace (docs/program-format.md).
ReadProgram read_blockly(std::string_view json_text);

}  // namespace mirada::vm
