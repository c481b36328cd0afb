#include <algorithm>

#include "blocks/call_checks.h"
#include "model/angles.h"

namespace mirada::blocks {
namespace {

constexpr Micros kMovePatience = 2 * kSecond;
constexpr Micros kSeePatience = 400 * kMillisecond;
constexpr double kMostPan_deg = 360;
constexpr double kMostTilt_deg = 90;
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

/// Says which end of its range a joint stopped at; angles as blocks give them.
void say_if_clamped(robot::Robot& robot, NativeCall& call, const Message& message, double asked_deg,
                    double given_deg) {
  if (std::abs(asked_deg - given_deg) <= kEndSlack_deg) return;
  robot.note(call.block(),
             make_fault(call.block(), message,
                        {{"limit", number_text(given_deg, 0)}, {"value", number_text(asked_deg, 0)}}));
}

/// Where to look; an angle that is not given stays as it is.
struct Aim {
  std::optional<double> pan_rad;
  std::optional<double> tilt_rad;
};

NativeResult begin(robot::Robot& robot, NativeCall& call, const Aim& aim) {
  if (!robot.motion().may_move()) return NativeResult::failed(messages::not_running);
  robot.watch().rest();
  robot.follower().stop();
  robot::Gaze& gaze = robot.gaze();
  if (aim.pan_rad) {
    say_if_clamped(robot, call, messages::pan_clamped, bearing_to_block(*aim.pan_rad),
                   bearing_to_block(gaze.pan_to(*aim.pan_rad)));
  }
  if (aim.tilt_rad) {
    say_if_clamped(robot, call, messages::tilt_clamped, tilt_to_block(*aim.tilt_rad),
                   tilt_to_block(gaze.tilt_to(*aim.tilt_rad)));
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
  return begin(robot, call, {bearing_from_block(right_deg), std::nullopt});
}

NativeResult tilt_to(robot::Robot& robot, NativeCall& call) {
  if (call.state()) return follow(robot, call);
  if (!robot.gaze().can_tilt()) return NativeResult::failed(messages::no_tilt);
  const double up_deg = call.number(0);
  if (auto why = refused(up_deg, -kMostTilt_deg, kMostTilt_deg, "°")) return *why;
  return begin(robot, call, {std::nullopt, tilt_from_block(up_deg)});
}

/// As far as the neck goes: what stands farther round is looked at as well as can be, without a complaint.
/// Nothing to look at: the neck stays.
NativeResult look_toward(robot::Robot& robot, NativeCall& call, Aim aim) {
  const robot::Gaze& gaze = robot.gaze();
  if (!gaze.can_pan()) return NativeResult::failed(messages::no_neck);
  if (!aim.pan_rad) return NativeResult::finished();
  aim.pan_rad = std::clamp(*aim.pan_rad, gaze.pan_joint().min_rad, gaze.pan_joint().max_rad);
  if (aim.tilt_rad)
    aim.tilt_rad = std::clamp(*aim.tilt_rad, gaze.tilt_joint().min_rad, gaze.tilt_joint().max_rad);
  return begin(robot, call, aim);
}

NativeResult look_at(robot::Robot& robot, NativeCall& call) {
  if (call.state()) return follow(robot, call);
  const std::string where = call.text(0);
  return look_toward(robot, call, {where == "left" ? kSide_rad : where == "right" ? -kSide_rad : 0.0, 0.0});
}

NativeResult look_at_face(robot::Robot& robot, NativeCall& call) {
  if (call.state()) return follow(robot, call);
  const FacesPercept* faces = robot.faces();
  if (faces == nullptr || faces->faces.empty()) return look_toward(robot, call, {});
  const FacePercept& face = faces->faces.front();
  // The fixed tilt of the mount is part of where the lens points.
  return look_toward(robot, call, {face.bearing_rad, -face.elevation_rad - robot.config().mount.tilt_rad});
}

NativeResult look_at_obstacle(robot::Robot& robot, NativeCall& call) {
  if (call.state()) return follow(robot, call);
  const auto nearest = robot.sonar().nearest_obstacle();
  if (!nearest) return look_toward(robot, call, {});
  // Its foot is on the floor, which the level camera sees.
  return look_toward(robot, call, {nearest->bearing_rad, 0.0});
}

NativeResult pan_angle(robot::Robot& robot, NativeCall&) {
  return NativeResult::of(bearing_to_block(robot.gaze().state(robot.now()).angles.pan_rad) + 0.0);
}

NativeResult tilt_angle(robot::Robot& robot, NativeCall&) {
  return NativeResult::of(tilt_to_block(robot.gaze().state(robot.now()).angles.tilt_rad) + 0.0);
}

}  // namespace

void add_looking_blocks(vm::NativeTable& table, const std::shared_ptr<const Link>& link) {
  table["looking_pan_to"] = with_robot(link, pan_to);
  table["looking_tilt_to"] = with_robot(link, tilt_to);
  table["looking_look_at"] = with_robot(link, look_at);
  table["looking_look_at_face"] = with_robot(link, look_at_face);
  table["looking_look_at_obstacle"] = with_robot(link, look_at_obstacle);
  table["looking_pan_angle"] = with_robot(link, pan_angle);
  table["looking_tilt_angle"] = with_robot(link, tilt_angle);
}

}  // namespace mirada::blocks
