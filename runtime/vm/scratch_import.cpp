#include "vm/scratch_import.h"

#include <set>

#include "vm/blockly_writer.h"
#include "vm/literal.h"
#include "vm/messages.h"
#include "vm/reader.h"
#include "vm/validate.h"

namespace mirada::vm {
namespace {

Faults long_lists(const Program& program) {
  Faults out;
  for (const Variable& variable : program.variables) {
    if (variable.initial_items.size() <= kMostKeptItems) continue;
    out.push_back(make_fault("", messages::list_left_empty,
                             {{"name", variable.name},
                              {"count", std::to_string(variable.initial_items.size())},
                              {"limit", std::to_string(kMostKeptItems)}},
                             Severity::warning));
  }
  return out;
}

/// What the editor will show in grey: blocks of Scratch's that are not blocks of ours.
Faults placeholders(const Program& program, const BlockCatalog& catalog) {
  std::set<std::string> grey;
  for (const Block& block : program.blocks) {
    const BlockDef* def = catalog.find(block.opcode);
    const bool ours =
        def && (def->implementation != Implementation::native || block.opcode.starts_with("looks_say"));
    if (!ours && !literal_field(block)) grey.insert(block.opcode);
  }
  if (grey.empty()) return {};
  std::string list;
  for (const std::string& opcode : grey) list += (list.empty() ? "" : ", ") + opcode;
  return {make_fault("", messages::placeholder_blocks, {{"blocks", list}}, Severity::warning)};
}

}  // namespace

ImportedProject import_scratch(std::string_view bytes, const BlockCatalog& catalog, const std::string& name) {
  ReadProgram read = read_program(bytes);
  // What was opened is a file of Scratch's, not JSON that somebody wrote.
  for (Fault& fault : read.faults)
    if (fault.code() == mirada::messages::json_broken.code) fault = make_fault("", messages::archive_broken);
  if (!has_errors(read.faults) && !read.program.from_scratch) {
    return {{}, {make_fault("", messages::no_targets)}};
  }
  ImportedProject out{{}, std::move(read.faults)};
  for (Fault& fault : validate(read.program, catalog).faults) {
    if (fault.code() != messages::stage_blocks.code) out.faults.push_back(std::move(fault));
  }
  if (has_errors(out.faults)) return out;
  for (Fault& fault : placeholders(read.program, catalog)) out.faults.push_back(std::move(fault));
  for (Fault& fault : long_lists(read.program)) out.faults.push_back(std::move(fault));
  out.program_json = write_blockly(read.program, catalog, name);
  return out;
}

}  // namespace mirada::vm
