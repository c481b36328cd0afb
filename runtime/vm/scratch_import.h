#pragma once
#include <string>
#include <string_view>

#include "base/result.h"
#include "vm/catalog.h"

namespace mirada::vm {

/// A Scratch file (archive or project.json) as a program for the editor.
struct ImportedProject {
  std::string program_json;  ///< empty when the file is refused
  Faults faults;  ///< warnings (what became a placeholder, what was left out), or why it is refused
};

ImportedProject import_scratch(std::string_view bytes, const BlockCatalog& catalog, const std::string& name);

}  // namespace mirada::vm
