#include "blocks/motion/moving.h"
#include "memory/ways.h"
#include "model/angles.h"
#include "robot/messages.h"

namespace mirada::blocks {
namespace {

constexpr double kMostAway_cm = 10'000;
constexpr double kMostGap_deg = 360;
constexpr double kBeyondGap_m = 0.35;
constexpr double kFarthestGap_m = 1.5;
constexpr double kNearGap_rad = rad(60);

/// A child's place in O: on the map where the robot has one (x right, y up), else x to the right and y ahead
/// of where the run began. Nothing when it has a map and does not know where on it.
std::optional<Eigen::Vector2d> place_in_O(const robot::Robot& robot, double right_m, double ahead_m) {
  Pose2 p = compose(robot.start_pose(), {ahead_m, -right_m, 0});
  if (robot.localizer().place()) {
    const robot::Localizer::Estimate at = robot.localizer().estimate();
    if (!at.known) return std::nullopt;
    p = compose(compose(robot.odometry().X_OR, inverse(at.X_PR)), {right_m, ahead_m, 0});
  }
  return Eigen::Vector2d(p.x_m, p.y_m);
}

NativeResult begun(NativeCall& call, robot::MotionTicket ticket) {
  call.state() = std::make_unique<MotionInHand>(ticket);
  return NativeResult::again_at();
}

NativeResult drive_and_avoid(robot::Robot& robot, NativeCall& call) {
  if (auto why = cannot_move(robot)) return *why;
  robot.pilot().roam(owner_of(call));
  return NativeResult::finished();
}

NativeResult follow_wall(robot::Robot& robot, NativeCall& call) {
  if (auto why = cannot_move(robot)) return *why;
  robot.pilot().follow_wall(owner_of(call));
  return NativeResult::finished();
}

NativeResult drive_to(robot::Robot& robot, NativeCall& call) {
  if (call.state()) return follow_motion(robot, call);
  if (auto why = cannot_move(robot)) return *why;
  for (const std::size_t arg : {0u, 1u}) {
    if (auto why = refused(call.number(arg), -kMostAway_cm, kMostAway_cm, "cm")) return *why;
  }
  const auto goal_O_m = place_in_O(robot, call.number(0) / 100, call.number(1) / 100);
  if (!goal_O_m) {
    robot.note(call.block(), make_fault(call.block(), messages::place_lost));
    return NativeResult::finished();
  }
  return begun(call, robot.pilot().go_to(*goal_O_m, owner_of(call)));
}

NativeResult go_back(robot::Robot& robot, NativeCall& call) {
  if (call.state()) return follow_motion(robot, call);
  if (auto why = cannot_move(robot)) return *why;
  return begun(call, robot.pilot().go_to({robot.start_pose().x_m, robot.start_pose().y_m}, owner_of(call)));
}

NativeResult through_gap(robot::Robot& robot, NativeCall& call) {
  if (call.state()) return follow_motion(robot, call);
  if (auto why = cannot_move(robot)) return *why;
  const double right_deg = call.number(0);
  if (auto why = refused(right_deg, -kMostGap_deg, kMostGap_deg, "°")) return *why;
  const double asked_rad = wrap_rad(bearing_from_block(right_deg));
  const auto gap =
      memory::gap_near(robot.memory(), asked_rad, 2 * robot.pilot().radius_m(), kFarthestGap_m, kNearGap_rad);
  if (!gap) {
    robot.note(call.block(), make_fault(call.block(), messages::no_gap_there));
    return NativeResult::finished();
  }
  const Pose2& X_OR = robot.memory().X_OR();
  const double angle = X_OR.heading_rad + gap->bearing_rad;
  const double way_m = gap->edge_m + kBeyondGap_m;
  const Eigen::Vector2d goal(X_OR.x_m + way_m * std::cos(angle), X_OR.y_m + way_m * std::sin(angle));
  return begun(call, robot.pilot().go_to(goal, owner_of(call)));
}

NativeResult tenths(double value) { return NativeResult::of(std::round(value * 10) / 10 + 0.0); }

/// In a place whose map it has: x to the right and y up on the map in cm; heading 0 up, to the right. Zeros
/// where it does not know.
NativeResult my_place_on_map(const robot::Localizer::Estimate& at, const std::string& what) {
  constexpr double kNoIdea_cm = 999;
  if (what == "error") return tenths(at.known ? 2 * at.sigma_m * 100 : kNoIdea_cm);
  if (!at.known) return tenths(0);
  if (what == "x") return tenths(at.X_PR.x_m * 100);
  if (what == "y") return tenths(at.X_PR.y_m * 100);
  return tenths(deg(wrap_rad(rad(90) - at.X_PR.heading_rad)));
}

/// Without a map: from where the run began, by the wheels alone; x to the right and y ahead.
NativeResult my_place_from_start(const robot::Robot& robot, const std::string& what) {
  const Pose2 X_SR = compose(inverse(robot.start_pose()), robot.odometry().X_OR);
  if (what == "error") return tenths(2 * 100 * robot.drift_since_start_m());
  if (what == "x") return tenths(-X_SR.y_m * 100);
  if (what == "y") return tenths(X_SR.x_m * 100);
  return tenths(bearing_to_block(wrap_rad(X_SR.heading_rad)));
}

NativeResult my_place(robot::Robot& robot, NativeCall& call) {
  const robot::Localizer& localizer = robot.localizer();
  if (localizer.place()) return my_place_on_map(localizer.estimate(), call.text(0));
  return my_place_from_start(robot, call.text(0));
}

/// By a map, its tags and its lines; without a map, never.
NativeResult know_place(robot::Robot& robot, NativeCall&) {
  return NativeResult::of(robot.localizer().estimate().known);
}

}  // namespace

void add_driving_blocks(vm::NativeTable& table, const std::shared_ptr<const Link>& link) {
  table["motion_drive_and_avoid"] = with_robot(link, drive_and_avoid);
  table["motion_follow_wall"] = with_robot(link, follow_wall);
  table["motion_drive_to"] = with_robot(link, drive_to);
  table["motion_go_back"] = with_robot(link, go_back);
  table["motion_through_gap"] = with_robot(link, through_gap);
  table["motion_my_place"] = with_robot(link, my_place);
  table["motion_know_place"] = with_robot(link, know_place);
}

}  // namespace mirada::blocks
