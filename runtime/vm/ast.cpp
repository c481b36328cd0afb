#include "vm/ast.h"

#include <algorithm>

namespace mirada::vm {

const Field* Block::field(std::string_view name) const {
  const auto it = std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.name == name; });
  return it == fields.end() ? nullptr : &*it;
}

const Input* Block::input(std::string_view name) const {
  const auto it = std::find_if(inputs.begin(), inputs.end(), [&](const Input& i) { return i.name == name; });
  return it == inputs.end() ? nullptr : &*it;
}

std::size_t counted_blocks(const Program& program) {
  return static_cast<std::size_t>(std::count_if(program.blocks.begin(), program.blocks.end(),
                                                [](const Block& b) { return !b.is_shadow; }));
}

}  // namespace mirada::vm
