#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "vm/block_def.h"

namespace mirada::vm {

/// Every block that can be used, by opcode. Built once by packs/, then shared read-only between threads.
class BlockCatalog {
 public:
  /// Refuses (false) an opcode that is there already.
  bool add(BlockDef def);
  const BlockDef* find(std::string_view opcode) const;
  const std::map<std::string, BlockDef, std::less<>>& all() const { return defs_; }

 private:
  std::map<std::string, BlockDef, std::less<>> defs_;
};

}  // namespace mirada::vm
