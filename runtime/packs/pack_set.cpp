#include <algorithm>

#include "base/files.h"
#include "packs/messages.h"
#include "packs/packs.h"

namespace mirada::packs {
namespace fs = std::filesystem;
namespace {

std::vector<fs::path> pack_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (fs::exists(entry.path() / "pack.json", error)) files.push_back(entry.path() / "pack.json");
  }
  std::sort(files.begin(), files.end());
  return files;
}

void append(Faults& all, const Faults& more) { all.insert(all.end(), more.begin(), more.end()); }

void add_to_catalog(const Pack& pack, PackSet& set) {
  for (const vm::BlockDef& block : pack.blocks) {
    if (set.catalog.add(block)) continue;
    set.faults.push_back(
        make_fault(pack.id, messages::opcode_taken, {{"opcode", block.opcode}, {"pack", pack.id}}));
  }
}

}  // namespace

PackSet load_packs(const fs::path& folder, const vm::NativeTable& natives) {
  PackSet set;
  for (const fs::path& file : pack_files(folder)) {
    const Result<std::string> text = read_file(file, 8u << 20);
    if (!text) {
      append(set.faults, text.faults());
      continue;
    }
    Result<Pack> pack = read_pack(*text, (file.parent_path().filename() / "pack.json").string(), natives);
    if (pack) {
      set.packs.push_back(std::move(*pack));
    } else {
      append(set.faults, pack.faults());
    }
  }
  std::stable_sort(set.packs.begin(), set.packs.end(), [](const Pack& a, const Pack& b) {
    return std::tie(a.order, a.id) < std::tie(b.order, b.id);
  });
  for (const Pack& pack : set.packs) add_to_catalog(pack, set);
  return set;
}

}  // namespace mirada::packs
