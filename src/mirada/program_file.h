#pragma once
#include <memory>
#include <string>

#include "packs/packs.h"
#include "vm/machine.h"

namespace mirada {

/// A program's file, loaded with the packs that ship. The packs must live as long as the code.
struct ProgramFile {
  std::unique_ptr<packs::PackSet> packs;
  Result<vm::LoadedProgram> program;
};
ProgramFile load_program_file(const std::string& path);

}  // namespace mirada
