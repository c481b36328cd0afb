#include "vm/catalog.h"

#include <utility>

namespace mirada::vm {

bool BlockCatalog::add(BlockDef def) {
  std::string opcode = def.opcode;
  return defs_.emplace(std::move(opcode), std::move(def)).second;
}

const BlockDef* BlockCatalog::find(std::string_view opcode) const {
  const auto it = defs_.find(opcode);
  return it == defs_.end() ? nullptr : &it->second;
}

}  // namespace mirada::vm
