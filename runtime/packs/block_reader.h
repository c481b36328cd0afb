#pragma once
#include <optional>
#include <string>

#include "base/json_reader.h"
#include "vm/block_def.h"

namespace mirada::packs {

/// One block of a pack.json, its faults collected by `json`. A native block takes its meaning from `natives`.
vm::BlockDef read_block(JsonReader json, const std::string& pack, const vm::NativeTable& natives);

/// The two languages of a `{"en": …, "es": …}` object; a missing or empty one is a fault.
struct TwoLanguages {
  std::string en;
  std::string es;
};
TwoLanguages read_languages(JsonReader& json, std::string_view field);

/// Whether this can be an opcode, a pack's id or an argument's name.
bool is_name(std::string_view text, bool capitals);

}  // namespace mirada::packs
