#include "program_file.h"

#include "base/files.h"
#include "rig/shipped_packs.h"

namespace mirada {

ProgramFile load_program_file(const std::string& path) {
  auto packs = std::make_unique<packs::PackSet>(rig::shipped_packs(std::make_shared<const blocks::Link>()));
  const Result<std::string> text = read_file(path);
  if (!text) return {std::move(packs), text.faults()};
  Result<vm::LoadedProgram> program = vm::load_program(*text, packs->catalog);
  return {std::move(packs), std::move(program)};
}

}  // namespace mirada
