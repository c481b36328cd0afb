#pragma once
#include <string_view>

#include "base/result.h"
#include "vm/ast.h"
#include "vm/json_tree.h"

namespace mirada::vm {

/// What was read and everything that is wrong with its form. The program is whole enough to be validated as
/// far as it goes, so that one answer can hold the faults of form and of meaning.
struct ReadProgram {
  Program program;
  Faults faults;
};

/// The editor's envelope or a bare Blockly workspace (docs/program-format.md).
ReadProgram read_blockly(JsonValue root);
/// A Scratch 3 project's project.json.
ReadProgram read_scratch_project(JsonValue root);
/// Any of them as text, and .sb3 files: told apart by their content.
ReadProgram read_program(std::string_view bytes);

}  // namespace mirada::vm
