#include <algorithm>

#include "blocks/call_checks.h"
#include "model/angles.h"
#include "robot/sureness.h"

namespace mirada::blocks {
namespace {

constexpr double kNoObstacle_deg = 180;
constexpr double kPictureWidth = 320;  // Scratch's units, whatever the picture's size
constexpr double kPictureHeight = 240;

// What a child gets is rounded to what can be read off: a millimetre, a tenth of a degree.
double round_to_tenth(double value) { return std::round(value * 10) / 10 + 0.0; }

bool measured(Answer answer) { return answer == Answer::blocked || answer == Answer::clear; }

/// In view what is seen now, elsewhere what is remembered. In cm; what was never seen is 0, so that `< 30` is
/// true: safe.
NativeResult obstacle_distance(robot::Robot& robot, NativeCall& call) {
  const double right_deg = call.number(0);
  if (!std::isfinite(right_deg)) return NativeResult::of(0.0);
  const SonarReading reading = robot.obstacle_at(bearing_from_block(right_deg)).reading;
  return NativeResult::of(measured(reading.answer) ? round_to_tenth(reading.distance_m * 100) : 0.0);
}

/// In percent, whole.
NativeResult how_sure(robot::Robot& robot, NativeCall& call) {
  const double right_deg = call.number(0);
  if (!std::isfinite(right_deg)) return NativeResult::of(0.0);
  return NativeResult::of(std::round(100 * robot::sureness(robot.sonar().at(bearing_from_block(right_deg)))));
}

NativeResult way_clear(robot::Robot& robot, NativeCall& call) {
  const double ahead_cm = call.number(0);
  if (!std::isfinite(ahead_cm)) return NativeResult::of(false);
  const double ahead_m = std::max(ahead_cm, 0.0) / 100;
  return NativeResult::of(robot.sonar().way_clear(robot.config().width_m(), ahead_m));
}

NativeResult nearest_direction(robot::Robot& robot, NativeCall&) {
  const auto nearest = robot.sonar().nearest_obstacle();
  return NativeResult::of(nearest ? round_to_tenth(bearing_to_block(nearest->bearing_rad)) : kNoObstacle_deg);
}

NativeResult obstacle_seen(robot::Robot& robot, NativeCall&) {
  return NativeResult::of(robot.sonar().nearest_obstacle().has_value());
}

/// The largest face now, or null.
const FacePercept* largest_face(const FacesPercept* faces) {
  return faces == nullptr || faces->faces.empty() ? nullptr : &faces->faces.front();
}

void explain(robot::Robot& robot, const NativeCall& call) {
  if (const auto& trouble = robot.perception().faces_trouble()) robot.note(call.block(), *trouble);
}

NativeResult face_seen(robot::Robot& robot, NativeCall& call) {
  explain(robot, call);
  return NativeResult::of(largest_face(robot.faces()) != nullptr);
}

/// Scratch's picture: centre 0,0, x to the right -160..160, y up -120..120; size is the box's width in the
/// same units.
NativeResult face_value(robot::Robot& robot, NativeCall& call) {
  explain(robot, call);
  const FacesPercept* faces = robot.faces();
  const FacePercept* face = largest_face(faces);
  if (face == nullptr) return NativeResult::of(0.0);
  const double across = kPictureWidth / faces->picture_width_px;
  const double down = kPictureHeight / faces->picture_height_px;
  const std::string what = call.text(0);
  if (what == "size") return NativeResult::of(round_to_tenth(face->w_px * across));
  if (what == "y") {
    return NativeResult::of(round_to_tenth(kPictureHeight / 2 - (face->y_px + face->h_px / 2) * down));
  }
  return NativeResult::of(round_to_tenth((face->x_px + face->w_px / 2) * across - kPictureWidth / 2));
}

}  // namespace

void add_vision_blocks(vm::NativeTable& table, const std::shared_ptr<const Link>& link) {
  table["vision_obstacle_distance"] = with_robot(link, obstacle_distance);
  table["vision_how_sure"] = with_robot(link, how_sure);
  table["vision_way_clear"] = with_robot(link, way_clear);
  table["vision_nearest_direction"] = with_robot(link, nearest_direction);
  table["vision_obstacle_seen"] = with_robot(link, obstacle_seen);
  table["vision_face_seen"] = with_robot(link, face_seen);
  table["vision_face"] = with_robot(link, face_value);
}

}  // namespace mirada::blocks
