#include <algorithm>

#include "blocks/call_checks.h"
#include "memory/ways.h"
#include "model/angles.h"

namespace mirada::blocks {
namespace {

constexpr double kNothing_deg = 180;
constexpr double kClearWay_m = 0.4;
constexpr double kFarthestGap_m = 1.5;
constexpr double kMostTag = 1e6;

double round_to_tenth(double value) { return std::round(value * 10) / 10 + 0.0; }

bool measured(Answer answer) { return answer == Answer::blocked || answer == Answer::clear; }

/// The nearest obstacle, in view or remembered.
std::optional<SonarReading> nearest(const robot::Robot& robot) {
  std::optional<SonarReading> best;
  for (int i = 0; i < memory::Surroundings::kDirections; ++i) {
    const SonarReading reading = robot.obstacle_at(memory::Surroundings::bearing_rad(i)).reading;
    if (reading.answer != Answer::blocked) continue;
    if (!best || reading.distance_m < best->distance_m) best = reading;
  }
  return best;
}

/// With none: 180° and 0 cm.
NativeResult nearest_obstacle(robot::Robot& robot, NativeCall& call) {
  const auto found = nearest(robot);
  if (call.text(0) == "distance") {
    return NativeResult::of(found ? round_to_tenth(found->distance_m * 100) : 0.0);
  }
  return NativeResult::of(found ? round_to_tenth(bearing_to_block(found->bearing_rad)) : kNothing_deg);
}

/// Age in s, or how sure in cm (two sigma); 0 where nothing is known.
NativeResult known(robot::Robot& robot, NativeCall& call) {
  const double right_deg = call.number(1);
  if (!std::isfinite(right_deg)) return NativeResult::of(0.0);
  const robot::Recall recall = robot.obstacle_at(bearing_from_block(right_deg));
  if (!measured(recall.reading.answer)) return NativeResult::of(0.0);
  if (call.text(0) == "age") return NativeResult::of(round_to_tenth(seconds(recall.age)));
  return NativeResult::of(round_to_tenth(2 * recall.reading.sigma_m * 100));
}

NativeResult way_clear(robot::Robot& robot, NativeCall& call) {
  const double right_deg = call.number(0);
  if (!std::isfinite(right_deg)) return NativeResult::of(false);
  const double bearing_rad = bearing_from_block(right_deg);
  return NativeResult::of(robot.memory().way_clear(bearing_rad, robot.config().width_m(), kClearWay_m));
}

NativeResult widest_way(robot::Robot& robot, NativeCall&) {
  const auto way = memory::widest_way(robot.memory(), robot.config().width_m(), kFarthestGap_m);
  return NativeResult::of(way ? round_to_tenth(bearing_to_block(*way)) : kNothing_deg);
}

struct Looking final : vm::NativeState {};

/// Until all round has been looked at, or a look block has taken the neck.
NativeResult look_around(robot::Robot& robot, NativeCall& call) {
  if (call.state()) {
    return robot.watch().looking_around() ? NativeResult::again_at() : NativeResult::finished();
  }
  if (!robot.gaze().can_pan()) return NativeResult::failed(messages::no_neck);
  if (!robot.motion().may_move()) return NativeResult::failed(messages::not_running);
  robot.watch().look_around();
  call.state() = std::make_unique<Looking>();
  return NativeResult::again_at();
}

NativeResult keep_eye(robot::Robot& robot, NativeCall& call) {
  if (!robot.gaze().can_pan()) return NativeResult::failed(messages::no_neck);
  if (!robot.motion().may_move()) return NativeResult::failed(messages::not_running);
  const std::string what = call.text(0);
  robot.watch().keep(what == "around"  ? memory::Watching::around
                     : what == "face"  ? memory::Watching::face
                     : what == "zones" ? memory::Watching::zones
                     : what == "ranks" ? memory::Watching::ranked_zones
                                       : memory::Watching::ahead);
  return NativeResult::finished();
}

/// The direction from where the robot is now; 180° when it was never seen.
NativeResult direction_of(const robot::Robot& robot, ThingKind kind, int id) {
  const memory::Thing* thing = robot.memory().things().find(kind, id);
  if (thing == nullptr) return NativeResult::of(kNothing_deg);
  const Pose2& X_OR = robot.memory().X_OR();
  const double angle = std::atan2(thing->p_O_m.y() - X_OR.y_m, thing->p_O_m.x() - X_OR.x_m);
  return NativeResult::of(round_to_tenth(bearing_to_block(wrap_rad(angle - X_OR.heading_rad))));
}

NativeResult where_was(robot::Robot& robot, NativeCall& call) {
  return direction_of(robot, call.text(0) == "ball" ? ThingKind::red_ball : ThingKind::face, 0);
}

NativeResult where_was_tag(robot::Robot& robot, NativeCall& call) {
  const double number = call.number(0);
  if (!(std::abs(number) < kMostTag)) return NativeResult::of(kNothing_deg);
  return direction_of(robot, ThingKind::tag, static_cast<int>(std::lround(number)));
}

NativeResult forget(robot::Robot& robot, NativeCall&) {
  robot.memory().forget();
  return NativeResult::finished();
}

}  // namespace

void add_memory_blocks(vm::NativeTable& table, const std::shared_ptr<const Link>& link) {
  table["memory_nearest"] = with_robot(link, nearest_obstacle);
  table["memory_known"] = with_robot(link, known);
  table["memory_way_clear"] = with_robot(link, way_clear);
  table["memory_widest_way"] = with_robot(link, widest_way);
  table["memory_look_around"] = with_robot(link, look_around);
  table["memory_keep_eye"] = with_robot(link, keep_eye);
  table["memory_where_was"] = with_robot(link, where_was);
  table["memory_where_was_tag"] = with_robot(link, where_was_tag);
  table["memory_forget"] = with_robot(link, forget);
}

}  // namespace mirada::blocks
