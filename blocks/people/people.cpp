#include <algorithm>
#include <chrono>
#include <future>
#include <memory>
#include <utility>

#include "blocks/call_checks.h"
#include "blocks/motion/moving.h"
#include "model/angles.h"

namespace mirada::blocks {
namespace {

constexpr double kPictureWidth = 320;  // Scratch's units, whatever the picture's size
constexpr double kPictureHeight = 240;
constexpr double kNearest_cm = 40;
constexpr double kFarthest_cm = 300;

double round_to_tenth(double value) { return std::round(value * 10) / 10 + 0.0; }

/// Why no faces can be looked for, as a warning on the block.
void explain(robot::Robot& robot, const NativeCall& call) {
  if (const auto& trouble = robot.perception().faces_trouble()) robot.note(call.block(), *trouble);
}

NativeResult count(robot::Robot& robot, NativeCall& call) {
  explain(robot, call);
  const FacesPercept* faces = robot.faces();
  return NativeResult::of(faces == nullptr ? 0.0 : static_cast<double>(faces->faces.size()));
}

/// The n-th face now, the largest first, or null.
const FacePercept* nth_face(const FacesPercept* faces, double n) {
  if (faces == nullptr || !(n >= 1) || n > static_cast<double>(faces->faces.size())) return nullptr;
  return &faces->faces[static_cast<std::size_t>(n) - 1];
}

/// Why nobody can be recognised, as a warning on the block.
void explain_names(robot::Robot& robot, const NativeCall& call) {
  explain(robot, call);
  if (robot.known_faces() == nullptr || !robot.known_faces()->allowed())
    robot.note(call.block(), make_fault(call.block(), messages::faces_not_allowed));
}

NativeResult face_value(robot::Robot& robot, NativeCall& call) {
  explain(robot, call);
  const FacesPercept* faces = robot.faces();
  const FacePercept* face = nth_face(faces, call.number(0));
  const std::string what = call.text(1);
  if (what == "name") explain_names(robot, call);
  if (what == "name") return NativeResult::of(face == nullptr ? std::string() : face->name);
  if (face == nullptr) return NativeResult::of(0.0);
  const double across = kPictureWidth / faces->picture_width_px;
  const double down = kPictureHeight / faces->picture_height_px;
  const auto tenth = [](double value) { return NativeResult::of(round_to_tenth(value)); };
  if (what == "x") return tenth((face->x_px + face->w_px / 2) * across - kPictureWidth / 2);
  if (what == "y") return tenth(kPictureHeight / 2 - (face->y_px + face->h_px / 2) * down);
  if (what == "size") return tenth(face->w_px * across);
  if (what == "direction") return tenth(bearing_to_block(face->bearing_rad));
  if (what == "distance") return tenth(face->distance_m * 100);
  if (what == "error") return tenth(2 * face->sigma_m * 100);
  return NativeResult::of(static_cast<double>(face->id));
}

/// The name of the first face; the child's own words for somebody it does not know; "" with no face, and
/// while it is not sure.
NativeResult who_is_it(robot::Robot& robot, NativeCall& call) {
  explain_names(robot, call);
  const FacePercept* face = nth_face(robot.faces(), 1);
  if (face == nullptr || face->familiar == Familiar::unsure) return NativeResult::of(std::string());
  return NativeResult::of(face->familiar == Familiar::known ? face->name : call.text(0));
}

/// A lesson that goes on; ends it without learning when the script is stopped.
struct LessonInHand final : vm::NativeState {
  LessonInHand(std::shared_ptr<vision::FaceBook> of, const std::string& name, Micros now)
      : book(std::move(of)), number(book->begin_lesson(name)), since(now) {}
  ~LessonInHand() override { (void)book->end_lesson(number, false); }
  std::shared_ptr<vision::FaceBook> book;
  std::uint64_t number;
  Micros since;
  std::future<Status> kept;
};

NativeResult learn_face(robot::Robot& robot, NativeCall& call) {
  constexpr Micros kLongestLesson = 20 * kSecond;
  explain(robot, call);
  const std::shared_ptr<vision::FaceBook> book = robot.known_faces();
  const auto say = [&](Fault why) { robot.note(call.block(), std::move(why)); };
  if (!call.state() && (book == nullptr || !book->allowed())) {
    say(make_fault(call.block(), messages::faces_not_allowed));
    return NativeResult::finished();
  }
  if (!call.state()) {
    if (const Status fine = vision::check_face_name(call.text(0)); !fine) {
      say(fine.faults().front());
      return NativeResult::finished();
    }
    call.state() = std::make_unique<LessonInHand>(book, call.text(0), call.now());
    return NativeResult::again_at();
  }
  auto& lesson = static_cast<LessonInHand&>(*call.state());
  if (!lesson.kept.valid()) {
    const auto looks = lesson.book->looks_of(lesson.number);
    if (!looks) {  // the teacher's no ends a lesson
      if (!lesson.book->allowed()) say(make_fault(call.block(), messages::faces_not_allowed));
      return NativeResult::finished();
    }
    const bool time_up = call.now() - lesson.since > kLongestLesson;
    if (*looks < vision::FaceBook::kLessonLooks && !time_up) return NativeResult::again_at();
    if (*looks < vision::FaceBook::kFewestLooks) {
      say(make_fault(call.block(), messages::face_not_learnt, {{"name", call.text(0)}}));
      return NativeResult::finished();
    }
    // A file is written beside the motor loop, which must not wait for a slow card.
    lesson.kept = lesson.book->keep_lesson(lesson.number);
  }
  if (lesson.kept.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
    return NativeResult::again_at();
  if (const Status kept = lesson.kept.get(); !kept) say(kept.faults().front());
  if (!lesson.book->allowed()) say(make_fault(call.block(), messages::faces_not_allowed));
  return NativeResult::finished();
}

NativeResult appears(robot::Robot& robot, NativeCall&) {
  const FacesPercept* faces = robot.faces();
  return NativeResult::of(faces != nullptr && !faces->faces.empty());
}

NativeResult goes(robot::Robot& robot, NativeCall&) {
  const FacesPercept* faces = robot.faces();
  return NativeResult::of(robot.met_face() && (faces == nullptr || faces->faces.empty()));
}

NativeResult follow_face(robot::Robot& robot, NativeCall& call) {
  explain(robot, call);
  if (auto why = cannot_move(robot)) return *why;
  robot.follower().face(owner_of(call));
  return NativeResult::finished();
}

NativeResult follow_person(robot::Robot& robot, NativeCall& call) {
  explain(robot, call);
  if (auto why = cannot_move(robot)) return *why;
  const double distance_cm = call.number(0);
  if (auto why = refused(distance_cm, kNearest_cm, kFarthest_cm, "cm")) return *why;
  robot.follower().person(distance_cm / 100, owner_of(call));
  return NativeResult::finished();
}

NativeResult stop_following(robot::Robot& robot, NativeCall&) {
  robot.follower().stop();
  return NativeResult::finished();
}

NativeResult following(robot::Robot& robot, NativeCall&) {
  const robot::FollowState state = robot.follower().state();
  return NativeResult::of(state == robot::FollowState::following || state == robot::FollowState::predicted);
}

}  // namespace

void add_people_blocks(vm::NativeTable& table, const std::shared_ptr<const Link>& link) {
  table["people_count"] = with_robot(link, count);
  table["people_face"] = with_robot(link, face_value);
  table["people_learn"] = with_robot(link, learn_face);
  table["people_who"] = with_robot(link, who_is_it);
  table["people_when_appears"] = with_robot(link, appears);
  table["people_when_goes"] = with_robot(link, goes);
  table["people_follow_face"] = with_robot(link, follow_face);
  table["people_follow_person"] = with_robot(link, follow_person);
  table["people_stop_following"] = with_robot(link, stop_following);
  table["people_following"] = with_robot(link, following);
}

}  // namespace mirada::blocks
