#pragma once
#include <set>
#include <string>
#include <vector>

#include "base/result.h"
#include "vm/ast.h"

namespace mirada::vm {

/// What validation found out about a program, beside its faults.
struct Validation {
  Faults faults;                ///< each with its block's id as place; errors refuse the start
  std::vector<bool> runs;       ///< by block: a script can reach it
  std::set<std::string> needs;  ///< of all blocks that can run
};

/// Looks every block up in the catalog (sets Block::def) and finds everything that is wrong. What stands in a
/// loose stack cannot run, so it is a warning at most.
Validation validate(Program& program, const BlockCatalog& catalog);

}  // namespace mirada::vm
