#include "vm/literal.h"

#include <algorithm>

#include "vm/numbers.h"

namespace mirada::vm {

const Field* literal_field(const Block& block) {
  const std::string& opcode = block.opcode;
  if (opcode == "text") return block.field("TEXT");
  const bool number = opcode == "math_number" || opcode == "math_angle" || opcode == "math_integer" ||
                      opcode == "math_whole_number" || opcode == "math_positive_number";
  return number ? block.field("NUM") : nullptr;
}

bool is_canonical_number(std::string_view text) {
  if (text.empty() || text.size() > 24) return false;
  const bool plain = std::all_of(text.begin(), text.end(),
                                 [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-'; });
  return plain && number_to_string(string_to_number(text)) == text;
}

}  // namespace mirada::vm
