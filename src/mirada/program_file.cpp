#include "program_file.h"

#include "base/files.h"
#include "rig/shipped_packs.h"

namespace mirada {

ProgramFile load_program_file(const std::string& path) {
  auto packs = std::make_unique<packs::PackSet>(rig::shipped_packs(std::make_shared<const blocks::Link>()));
  const Result<std::string> text = read_file(path);
  if (!text) return {std::move(packs), text.faults()};
  Result<vm::LoadedProgram> program = vm::load_program(*text, packs->catalog);
  if (program) return {std::move(packs), std::move(program)};
  Faults faults = program.faults();
  for (Fault& fault : faults)
    if (fault.place.empty()) fault.place = path;
  return {std::move(packs), std::move(faults)};
}

}  // namespace mirada
