#pragma once
#include <memory>

#include "robot/robot.h"
#include "vm/host.h"
#include "vm/native.h"

namespace mirada::blocks {

/// What the native blocks act on: looked up at every call, so that one catalog serves robots that come and
/// go. Null where there is none: the blocks then say so. Set and read on the control thread.
struct Link {
  robot::Robot* robot = nullptr;
  vm::Host* host = nullptr;  ///< who speaks
};

/// The meaning of every native block of the packs that ship. The table keeps the link alive.
vm::NativeTable native_blocks(const std::shared_ptr<const Link>& link = std::make_shared<const Link>());

// One a pack; each adds its blocks to the table.
void add_motion_blocks(vm::NativeTable& table, const std::shared_ptr<const Link>& link);
void add_looking_blocks(vm::NativeTable& table, const std::shared_ptr<const Link>& link);
void add_vision_blocks(vm::NativeTable& table, const std::shared_ptr<const Link>& link);
void add_memory_blocks(vm::NativeTable& table, const std::shared_ptr<const Link>& link);
void add_people_blocks(vm::NativeTable& table, const std::shared_ptr<const Link>& link);
void add_say_blocks(vm::NativeTable& table, const std::shared_ptr<const Link>& link);

}  // namespace mirada::blocks
