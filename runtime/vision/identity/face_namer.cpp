#include "vision/identity/face_namer.h"

#include <algorithm>
#include <utility>

#include "vision/messages.h"

namespace mirada::vision {
namespace {

constexpr Micros kAskSoon = 150 * kMillisecond;  // while it is not decided
constexpr Micros kAskAgain = 1'500 * kMillisecond;
constexpr std::size_t kVotes = 4;
constexpr int kSameNames = 2;    // votes for a name
constexpr int kNobodies = 3;     // votes for a stranger
constexpr double kAhead = 0.05;  // of the next in likeness
constexpr double kNameable_px = 20;
constexpr double kTeachable_px = 24;  // a lesson wants more
constexpr Micros kBetweenLooks = 280 * kMillisecond;
constexpr Micros kMissed = 800 * kMillisecond;

bool is_shown(const FacePercept& face) { return !face.predicted && face.id > 0; }

}  // namespace

void FaceNamer::forget() { tracks_.clear(); }

/// Whoever was learnt, renamed or forgotten is asked for anew.
void FaceNamer::follow_book() {
  const std::uint64_t now = book_->revision();
  if (now == revision_) return;
  revision_ = now;
  tracks_.clear();
}

void FaceNamer::decide(Track& track) {
  std::map<std::string, int> count;
  for (const std::string& vote : track.votes) ++count[vote];
  const int nobodies = std::exchange(count[""], 0);
  const auto most = std::max_element(count.begin(), count.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  if (most->second >= kSameNames) {
    track.who = most->first;
  } else if (nobodies >= kNobodies) {
    track.who = "";
  }
}

std::optional<FaceFeature> FaceNamer::describe(const cv::Mat& bgr, FacesPercept& seen,
                                               const FacePercept& face) {
  if (!describer_) describer_ = FaceDescriber::open();
  ++seen.described;
  return describer_->describe(bgr, {face.x_px, face.y_px, face.w_px, face.h_px});
}

std::string FaceNamer::name_by(const FaceBook::Match& match, double same_from) {
  const bool sure = match.likeness >= same_from && match.likeness - match.next_likeness >= kAhead;
  return sure ? match.name : "";
}

/// A name, or "" for nobody known.
std::string FaceNamer::who(const FaceFeature& feature) const {
  return name_by(book_->match(feature, describer_->kind()), describer_->same_from());
}

void FaceNamer::name_at_once(const cv::Mat& bgr, FacesPercept& seen) {
  if (!book_->allowed() || book_->people().empty()) return;
  for (FacePercept& face : seen.faces) {
    const auto feature = face.predicted ? std::nullopt : describe(bgr, seen, face);
    if (!feature) continue;
    face.name = who(*feature);
    face.familiar = face.name.empty() ? Familiar::stranger : Familiar::known;
  }
}

/// The face that has waited longest, of those whose turn it is.
FacePercept* FaceNamer::most_wanted(FacesPercept& seen) {
  FacePercept* out = nullptr;
  Micros longest = 0;
  for (FacePercept& face : seen.faces) {
    if (!is_shown(face) || face.w_px < kNameable_px) continue;
    const Track& track = tracks_[face.id];
    const Micros waited = seen.t_exposure - track.asked_at;
    const bool due = track.asked_at == 0 || waited >= (track.who ? kAskAgain : kAskSoon);
    if (due && (out == nullptr || waited > longest)) {
      out = &face;
      longest = waited;
    }
  }
  return out;
}

void FaceNamer::ask(const cv::Mat& bgr, FacesPercept& seen) {
  FacePercept* face = most_wanted(seen);
  if (face == nullptr) return;
  Track& track = tracks_[face->id];
  track.asked_at = seen.t_exposure;
  const auto feature = describe(bgr, seen, *face);
  if (!feature) return;
  track.votes.push_back(who(*feature));
  if (track.votes.size() > kVotes) track.votes.pop_front();
  decide(track);
}

void FaceNamer::learn(const cv::Mat& bgr, FacesPercept& seen, std::uint64_t lesson) {
  if (lesson != lesson_) {
    lesson_ = lesson;
    pupil_ = 0;
    taught_at_ = 0;
    shown_at_ = 0;
  }
  const auto say = [&](const Message& hint) { book_->teach(lesson, "", std::nullopt, &hint); };
  const auto shown = std::count_if(seen.faces.begin(), seen.faces.end(), is_shown);
  if (shown > 0) shown_at_ = seen.t_exposure;
  // Missed in a picture or two: what was said before still holds.
  if (shown == 0 && shown_at_ != 0 && seen.t_exposure - shown_at_ < kMissed) return;
  if (shown == 0) return say(messages::lesson_show_face);
  const FacePercept& face = *std::find_if(seen.faces.begin(), seen.faces.end(), is_shown);
  if (face.w_px < kTeachable_px) return say(messages::lesson_closer);
  const bool another = std::any_of(seen.faces.begin(), seen.faces.end(), [&](const FacePercept& other) {
    return is_shown(other) && other.id != face.id && other.w_px > 0.6 * face.w_px;
  });
  if (another) return say(messages::lesson_one_only);
  if (taught_at_ != 0 && seen.t_exposure - taught_at_ < kBetweenLooks) return;
  taught_at_ = seen.t_exposure;
  auto feature = describe(bgr, seen, face);
  if (!feature) return say(messages::lesson_look_here);
  const std::vector<FaceFeature> looks = book_->lesson_looks();
  double most = 0;
  for (const FaceFeature& look : looks) most = std::max(most, likeness(look, *feature));
  // Somebody else stepped in.
  if (!looks.empty() && pupil_ != face.id && most < describer_->same_from())
    return say(messages::lesson_one_only);
  pupil_ = face.id;
  book_->teach(lesson, describer_->kind(), std::move(feature), &messages::lesson_move);
}

void FaceNamer::look(const cv::Mat& bgr, FacesPercept& seen, bool may_describe) {
  follow_book();
  if (!book_->allowed()) return;
  const auto is_gone = [&](const auto& track) {
    const auto is_it = [&](const FacePercept& face) { return face.id == track.first; };
    return std::none_of(seen.faces.begin(), seen.faces.end(), is_it) &&
           std::none_of(seen.bodies.begin(), seen.bodies.end(), is_it);
  };
  std::erase_if(tracks_, is_gone);
  if (may_describe) {
    if (const std::uint64_t lesson = book_->lesson_number()) {
      learn(bgr, seen, lesson);
    } else if (!book_->people().empty()) {
      ask(bgr, seen);
    }
  }
  seen.lesson = book_->lesson();
  for (std::vector<FacePercept>* all : {&seen.faces, &seen.bodies}) {
    for (FacePercept& face : *all) {
      const auto track = tracks_.find(face.id);
      if (track == tracks_.end() || !track->second.who) continue;
      face.name = *track->second.who;
      face.familiar = face.name.empty() ? Familiar::stranger : Familiar::known;
    }
  }
}

}  // namespace mirada::vision
