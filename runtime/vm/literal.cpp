#include "vm/literal.h"

namespace mirada::vm {

const Field* literal_field(const Block& block) {
  const std::string& opcode = block.opcode;
  if (opcode == "text") return block.field("TEXT");
  const bool number = opcode == "math_number" || opcode == "math_angle" || opcode == "math_integer" ||
                      opcode == "math_whole_number" || opcode == "math_positive_number";
  return number ? block.field("NUM") : nullptr;
}

}  // namespace mirada::vm
