#pragma once
#include "blocks/call_checks.h"

namespace mirada::blocks {

/// What a motion block keeps: the motion that it asked for.
struct MotionInHand final : vm::NativeState {
  explicit MotionInHand(robot::MotionTicket of) : ticket(of) {}
  robot::MotionTicket ticket;
};

/// Why this robot cannot move now, if so.
std::optional<NativeResult> cannot_move(robot::Robot& robot);
robot::MotionOwner owner_of(const NativeCall& call);
/// The turns after the first: until the motion has ended, one way or another.
NativeResult follow_motion(robot::Robot& robot, NativeCall& call);

/// The blocks that drive by memory.
void add_driving_blocks(vm::NativeTable& table, const std::shared_ptr<const Link>& link);

}  // namespace mirada::blocks
