#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "vm/catalog.h"
#include "vm/native.h"

namespace mirada::packs {

/// One block pack: its blocks' definitions, and its manifest as the editor gets it.
struct Pack {
  std::string id;
  std::string version;
  double order = 1000;  ///< place in the toolbox; packs without one come last
  std::vector<vm::BlockDef> blocks;
  std::string manifest_json;  ///< pack.json as it was read
};

/// Reads pack.json (docs/pack-authoring.md). `native` blocks take their meaning from `natives`; one that is
/// missing there is a fault. All faults at once.
Result<Pack> read_pack(const std::string& json_text, const std::string& file_name,
                       const vm::NativeTable& natives);

struct PackSet {
  vm::BlockCatalog catalog;
  std::vector<Pack> packs;  ///< in toolbox order: by pack.json "order", then id
  Faults faults;            ///< packs that could not be loaded: the rest goes on
};

/// Every <folder>/<pack>/pack.json.
PackSet load_packs(const std::filesystem::path& folder, const vm::NativeTable& natives);

}  // namespace mirada::packs
