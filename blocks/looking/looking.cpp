#include <algorithm>

#include "blocks/call_checks.h"
#include "model/angles.h"

namespace mirada::blocks {
namespace {

constexpr Micros kMovePatience = 2 * kSecond;
constexpr Micros kSeePatience = 400 * kMillisecond;
constexpr double kMostPan_deg = 360;
constexpr double kSide_rad = rad(45);
constexpr double kEndSlack_deg = 0.5;

struct LookInHand final : vm::NativeState {
  Micros started = 0;
  Micros settled = 0;  // 0: the neck is on its way
};

/// Until the neck is there and, where pictures are looked at, one of the new view has been: what is asked
/// next is answered from there.
NativeResult follow(robot::Robot& robot, NativeCall& call) {
  auto& in_hand = static_cast<LookInHand&>(*call.state());
  const Micros now = robot.now();
  if (in_hand.settled == 0) {
    if (robot.gaze().state(now).settled || now - in_hand.started > kMovePatience) in_hand.settled = now;
    return NativeResult::again_at();
  }
  const robot::Perception& eye = robot.perception();
  const bool waits = eye.has_camera() && eye.needs().sonar;
  const bool seen = eye.percepts()->sonar.t_exposure >= in_hand.settled;
  if (waits && !seen && now - in_hand.settled < kSeePatience) return NativeResult::again_at();
  return NativeResult::finished();
}

NativeResult begin(robot::Robot& robot, NativeCall& call, double pan_rad) {
  if (!robot.motion().may_move()) return NativeResult::failed(messages::not_running);
  const double aim_rad = robot.gaze().pan_to(pan_rad);
  if (std::abs(deg(aim_rad - pan_rad)) > kEndSlack_deg) {
    robot.note(call.block(), make_fault(call.block(), messages::pan_clamped,
                                        {{"limit", number_text(bearing_to_block(aim_rad), 0)},
                                         {"value", number_text(bearing_to_block(pan_rad), 0)}}));
  }
  auto in_hand = std::make_unique<LookInHand>();
  in_hand->started = robot.now();
  call.state() = std::move(in_hand);
  return NativeResult::again_at();
}

NativeResult pan_to(robot::Robot& robot, NativeCall& call) {
  if (call.state()) return follow(robot, call);
  if (!robot.gaze().can_pan()) return NativeResult::failed(messages::no_neck);
  const double right_deg = call.number(0);
  if (auto why = refused(right_deg, -kMostPan_deg, kMostPan_deg, "°")) return *why;
  return begin(robot, call, bearing_from_block(right_deg));
}

/// As far as the neck goes: what stands farther round is looked at as well as can be, without a complaint.
/// Nothing to look at: the neck stays.
NativeResult look_toward(robot::Robot& robot, NativeCall& call, const std::optional<double>& bearing_rad) {
  if (!robot.gaze().can_pan()) return NativeResult::failed(messages::no_neck);
  if (!bearing_rad) return NativeResult::finished();
  const JointConfig& joint = robot.gaze().pan_joint();
  return begin(robot, call, std::clamp(*bearing_rad, joint.min_rad, joint.max_rad));
}

NativeResult look_at(robot::Robot& robot, NativeCall& call) {
  if (call.state()) return follow(robot, call);
  const std::string where = call.text(0);
  return look_toward(robot, call, where == "left" ? kSide_rad : where == "right" ? -kSide_rad : 0.0);
}

NativeResult look_at_face(robot::Robot& robot, NativeCall& call) {
  if (call.state()) return follow(robot, call);
  const FacesPercept* faces = robot.faces();
  const bool seen = faces != nullptr && !faces->faces.empty();
  return look_toward(robot, call, seen ? std::optional(faces->faces.front().bearing_rad) : std::nullopt);
}

NativeResult look_at_obstacle(robot::Robot& robot, NativeCall& call) {
  if (call.state()) return follow(robot, call);
  const auto nearest = robot.sonar().nearest_obstacle();
  return look_toward(robot, call, nearest ? std::optional(nearest->bearing_rad) : std::nullopt);
}

NativeResult pan_angle(robot::Robot& robot, NativeCall&) {
  return NativeResult::of(bearing_to_block(robot.gaze().state(robot.now()).angles.pan_rad) + 0.0);
}

}  // namespace

void add_looking_blocks(vm::NativeTable& table, const std::shared_ptr<const Link>& link) {
  table["looking_pan_to"] = with_robot(link, pan_to);
  table["looking_look_at"] = with_robot(link, look_at);
  table["looking_look_at_face"] = with_robot(link, look_at_face);
  table["looking_look_at_obstacle"] = with_robot(link, look_at_obstacle);
  table["looking_pan_angle"] = with_robot(link, pan_angle);
}

}  // namespace mirada::blocks
