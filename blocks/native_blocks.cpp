#include "blocks/native_blocks.h"

namespace mirada::blocks {

vm::NativeTable native_blocks(const std::shared_ptr<const Link>& link) {
  vm::NativeTable table;
  add_motion_blocks(table, link);
  add_looking_blocks(table, link);
  add_vision_blocks(table, link);
  add_memory_blocks(table, link);
  add_people_blocks(table, link);
  add_say_blocks(table, link);
  return table;
}

}  // namespace mirada::blocks
