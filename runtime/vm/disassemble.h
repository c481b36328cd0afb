#pragma once
#include <string>

#include "vm/machine.h"

namespace mirada::vm {

/// A compiled program as text: its variables, then each function's instructions with the block that each
/// belongs to.
std::string disassemble(const LoadedProgram& program);
/// The instruction set as a Markdown table, for docs/block-engine.md.
std::string instruction_table();

}  // namespace mirada::vm
