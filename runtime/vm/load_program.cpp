#include "vm/compiler.h"
#include "vm/machine.h"
#include "vm/reader.h"
#include "vm/validate.h"

namespace mirada::vm {

Result<LoadedProgram> load_program(std::string_view json_text, const BlockCatalog& catalog) {
  ReadProgram read = read_program(json_text);
  Validation checked = validate(read.program, catalog);
  Faults faults = std::move(read.faults);
  faults.insert(faults.end(), checked.faults.begin(), checked.faults.end());
  if (has_errors(faults)) return faults;
  auto code = std::make_shared<Code>();
  code->program = std::move(read.program);
  code->runs = std::move(checked.runs);
  code->catalog = &catalog;
  CodeTables tables;
  Compiler(code->program, code->runs, tables).compile_program(*code);
  code->functions = std::move(tables.functions);
  code->globals = std::move(tables.globals);
  code->natives = std::move(tables.natives);
  return LoadedProgram{code, std::move(faults), std::move(checked.needs)};
}

}  // namespace mirada::vm
