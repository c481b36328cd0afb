#include "blocks/motion/moving.h"
#include "model/angles.h"

namespace mirada::blocks {

std::optional<NativeResult> cannot_move(robot::Robot& robot) {
  if (!robot.safety().has_drive()) return NativeResult::failed(messages::no_drive);
  if (!robot.motion().may_move()) return NativeResult::failed(messages::not_running);
  return std::nullopt;
}

robot::MotionOwner owner_of(const NativeCall& call) { return {call.thread().value, call.block()}; }

NativeResult follow_motion(robot::Robot& robot, NativeCall& call) {
  const auto& in_hand = static_cast<const MotionInHand&>(*call.state());
  const robot::MotionState state = robot.motion().state(in_hand.ticket);
  if (state == robot::MotionState::going) return NativeResult::again_at();
  if (state == robot::MotionState::stalled) {
    robot.note(call.block(), make_fault(call.block(), messages::not_getting_there));
  }
  return NativeResult::finished();
}

namespace {

constexpr double kMostDistance_cm = 1'000;
constexpr double kMostTurn_deg = 3'600;
constexpr double kMostSpeed_percent = 100;

NativeResult drive(robot::Robot& robot, NativeCall& call) {
  if (call.state()) return follow_motion(robot, call);
  if (auto why = cannot_move(robot)) return *why;
  const double distance_cm = call.number(1);
  if (auto why = refused(distance_cm, -kMostDistance_cm, kMostDistance_cm, "cm")) return *why;
  const double sign = call.text(0) == "backward" ? -1 : 1;
  const auto ticket = robot.motion().drive(sign * distance_cm / 100, owner_of(call));
  call.state() = std::make_unique<MotionInHand>(ticket);
  return NativeResult::again_at();
}

NativeResult turn(robot::Robot& robot, NativeCall& call) {
  if (call.state()) return follow_motion(robot, call);
  if (auto why = cannot_move(robot)) return *why;
  const double angle_deg = call.number(1);
  if (auto why = refused(angle_deg, -kMostTurn_deg, kMostTurn_deg, "°")) return *why;
  const double right_deg = call.text(0) == "right" ? angle_deg : -angle_deg;
  const auto ticket = robot.motion().turn(bearing_from_block(right_deg), owner_of(call));
  call.state() = std::make_unique<MotionInHand>(ticket);
  return NativeResult::again_at();
}

NativeResult set_speeds(robot::Robot& robot, NativeCall& call) {
  if (auto why = cannot_move(robot)) return *why;
  for (const std::size_t arg : {0u, 1u}) {
    if (auto why = refused(call.number(arg), -kMostSpeed_percent, kMostSpeed_percent, "%")) return *why;
  }
  const double per_percent_mps = robot.config().drive.max_wheel_mps / 100;
  robot.motion().set_speeds({call.number(0) * per_percent_mps, call.number(1) * per_percent_mps},
                            owner_of(call));
  return NativeResult::finished();
}

NativeResult stop(robot::Robot& robot, NativeCall&) {
  robot.motion().halt();
  return NativeResult::finished();
}

}  // namespace

void add_motion_blocks(vm::NativeTable& table, const std::shared_ptr<const Link>& link) {
  table["motion_drive"] = with_robot(link, drive);
  table["motion_turn"] = with_robot(link, turn);
  table["motion_set_speeds"] = with_robot(link, set_speeds);
  table["motion_stop"] = with_robot(link, stop);
  add_driving_blocks(table, link);
}

}  // namespace mirada::blocks
