#include "vision/faces/face_tracker.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "vision/faces/face_place.h"

namespace mirada::vision {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr Micros kForgetAfter = 4 * kSecond;
constexpr Micros kForgetClothesAfter = 40 * kSecond;  // which tell them again when the face does not
constexpr Micros kLost = 500 * kMillisecond;
constexpr Micros kForgetNewAfter = 250 * kMillisecond;  // seen once only
constexpr int kSureLooks = 2;
constexpr double kBearing_rad = 0.012;  // how far a box's middle may be off
constexpr double kRangeShare = 0.05;
constexpr double kOldSize = 3;            // times as unsure, of a box that was only moved along
constexpr double kElevation_rad = 0.012;  // the box's middle and the neck
constexpr double kNearestBody_m = 0.3;    // nearer, the trunk fills the picture and anything passes for it
constexpr double kBodyBearing_rad = 0.03;
constexpr double kBodyRangeShare = 0.2;  // looks that follow each other err alike
constexpr double kTopElevation_rad = 0.015;
constexpr double kNoRange_m = 3;
constexpr double kUnsureSpeedFades = 0.85;
constexpr double kGate_rad = 0.06;  // beyond the face's own size
constexpr double kGateSpeed_mps = 0.8;
constexpr double kMostSizeRatio = 2.0;
constexpr double kCutOff_px = 3;

double cross_range(const Vector3d& from_lens) { return std::max(from_lens.norm(), FaceTrack::kNearest_m); }

Vector3d to_O(const Vector3d& p_R, const Pose2& X_OR) {
  const double c = std::cos(X_OR.heading_rad);
  const double s = std::sin(X_OR.heading_rad);
  return {X_OR.x_m + c * p_R.x() - s * p_R.y(), X_OR.y_m + s * p_R.x() + c * p_R.y(), p_R.z()};
}

Vector3d to_R(const Vector3d& p_O, const Pose2& X_OR) {
  const double c = std::cos(X_OR.heading_rad);
  const double s = std::sin(X_OR.heading_rad);
  const double x = p_O.x() - X_OR.x_m;
  const double y = p_O.y() - X_OR.y_m;
  return {c * x + s * y, -s * x + c * y, p_O.z()};
}

double size_px(const FacePercept& face) { return std::sqrt(face.w_px * face.h_px); }

}  // namespace

FaceTracker::View FaceTracker::view(const FacesPercept& picture, const NeckAngles& neck,
                                    const Pose2& X_OR) const {
  return {robot_.camera.scaled_to(picture.picture_width_px, picture.picture_height_px), robot_.X_RC(neck),
          X_OR};
}

std::optional<FacePercept> FaceTracker::as_seen(const Track& track, const View& view) {
  const Vector3d p_R = to_R({track.state[0], track.state[1], track.state[4]}, view.X_OR);
  const Vector3d p_C = view.X_RC.inverse() * p_R;
  if (p_C.z() < FaceTrack::kNearest_m) return std::nullopt;
  const auto pixel = view.camera.project(p_C);
  if (!pixel) return std::nullopt;
  FacePercept face;
  const double size = track.size_px_m / cross_range(p_C);
  face.w_px = size / std::sqrt(track.shape);
  face.h_px = size * std::sqrt(track.shape);
  face.x_px = pixel->x() + 0.5 - face.w_px / 2;
  face.y_px = pixel->y() + 0.5 - face.h_px / 2;
  set_face_point_R(face, p_R, view.X_RC);
  const Vector2d away = Vector2d(track.state[0] - view.X_OR.x_m, track.state[1] - view.X_OR.y_m).normalized();
  const double along = std::sqrt(std::max(0.0, away.dot(track.cov.topLeftCorner<2, 2>() * away)));
  face.sigma_m = std::hypot(along, kFaceSizeShare * face.distance_m);
  face.id = track.id;
  face.score = track.score;
  face.p_O_m = track.state.head<2>();
  face.v_O_mps = track.state.segment<2>(2);
  face.age = track.t - track.last_seen;
  return face;
}

/// A face that the picture's upper or lower edge cuts off is as high as its width says.
FacePercept FaceTracker::made_whole(const FacePercept& face, const Track& track, const View& view) {
  const bool above = face.y_px < kCutOff_px;
  const bool below = face.y_px + face.h_px > view.camera.height_px - kCutOff_px;
  const double height_px = face.w_px * track.shape;
  if (above == below || face.h_px >= height_px) return face;
  const double top_px = above ? face.y_px + face.h_px - height_px : face.y_px;
  return place_face({{face.x_px, top_px, face.w_px, height_px}, face.score}, view.camera, view.X_RC);
}

void FaceTracker::correct(Track& track, const FacePercept& seen, const View& view, bool sized) const {
  const FacePercept face = made_whole(seen, track, view);
  const Vector3d p_O = to_O(face_point_R(face, view.X_RC), view.X_OR);
  const Vector2d away = Vector2d(p_O.x() - view.X_OR.x_m, p_O.y() - view.X_OR.y_m).normalized();
  const double edge = std::hypot(kRangeShare, 0.8 / size_px(face)) * face.distance_m;
  const double across = kBearing_rad * face.distance_m;
  track.observe(p_O.head<2>(), away, sized ? edge : kOldSize * edge, across);
  track.observe_elevation(face.elevation_rad, kElevation_rad, 0, to_O(view.X_RC.translation(), view.X_OR));
  track.score = seen.score;
  track.last_seen = track.t;
  if (!sized) return;
  const double apart = cross_range(face_point_R(face, view.X_RC) - view.X_RC.translation());
  track.size_px_m += 0.3 * (size_px(face) * apart - track.size_px_m);
  track.shape += 0.3 * (face.h_px / face.w_px - track.shape);
  ++track.looks;
}

FaceTracker::Track FaceTracker::begin(const FacePercept& face, const View& view, Micros t) {
  Track track;
  track.id = next_id_++;
  const Vector3d p_R = face_point_R(face, view.X_RC);
  const Vector3d p_O = to_O(p_R, view.X_OR);
  track.state << p_O.x(), p_O.y(), 0, 0, p_O.z();
  const double spread = kFaceSizeShare * face.distance_m;
  const double speed = FaceTrack::kStartSpeed_mps * FaceTrack::kStartSpeed_mps;
  track.cov.setZero();
  track.cov.diagonal() << spread * spread, spread * spread, speed, speed, 0;
  // The height is told by the distance and as unsure.
  const double rise = std::tan(face.elevation_rad);
  const Vector2d away = Vector2d(p_R.x(), p_R.y()).normalized();
  const Vector2d away_O = Eigen::Rotation2Dd(view.X_OR.heading_rad) * away;
  track.cov.topRightCorner<2, 1>() = rise * spread * spread * away_O;
  track.cov.bottomLeftCorner<1, 2>() = track.cov.topRightCorner<2, 1>().transpose();
  track.cov(4, 4) = rise * rise * spread * spread + kElevation_rad * kElevation_rad;
  track.size_px_m = size_px(face) * cross_range(p_R - view.X_RC.translation());
  track.shape = face.h_px / face.w_px;
  track.score = face.score;
  track.t = track.last_seen = t;
  track.looks = 1;
  return track;
}

std::vector<FacePercept> FaceTracker::expected(const FacesPercept& picture, const NeckAngles& neck,
                                               const Pose2& X_OR) const {
  const View here = view(picture, neck, X_OR);
  std::vector<FacePercept> out;
  for (Track track : tracks_) {
    track.predict(picture.t_exposure);
    const auto face = as_seen(track, here);
    if (!face) continue;
    out.push_back(*face);
  }
  return out;
}

std::vector<FacePercept> FaceTracker::lost_ahead(const FacesPercept& picture, const NeckAngles& neck,
                                                 const Pose2& X_OR) const {
  const View here = view(picture, neck, X_OR);
  const Vector3d axis_R = here.X_RC.linear().col(2);
  const double angle = X_OR.heading_rad + std::atan2(axis_R.y(), axis_R.x());
  std::vector<FacePercept> out;
  for (Track track : tracks_) {
    if (track.unseen(picture.t_exposure) < kLost) continue;
    const Vector2d from(X_OR.x_m, X_OR.y_m);
    const double away_m = (track.state.head<2>() - from).norm();
    track.state.head<2>() = from + away_m * Vector2d(std::cos(angle), std::sin(angle));
    if (auto face = as_seen(track, here)) {
      face->age = track.unseen(picture.t_exposure);
      out.push_back(*face);
    }
  }
  return out;
}

std::vector<int> FaceTracker::ids() const {
  std::vector<int> out;
  for (const Track& track : tracks_) out.push_back(track.id);
  return out;
}

void FaceTracker::learn_top(const BodySeen& body, const NeckAngles& neck, const Pose2& X_OR) {
  constexpr double kLearns = 0.2;
  constexpr double kLeast_m = 0.05, kMost_m = 0.4;  // a neck's length and more
  const auto track =
      std::find_if(tracks_.begin(), tracks_.end(), [&](const Track& t) { return t.id == body.id; });
  if (track == tracks_.end() || !body.top_elevation_rad) return;
  const Vector3d lens = to_O(robot_.X_RC(neck).translation(), X_OR);
  const double away_m = (track->state.head<2>() - lens.head<2>()).norm();
  const double below_m = track->state[4] - lens.z() - away_m * std::tan(*body.top_elevation_rad);
  if (below_m < kLeast_m || below_m > kMost_m) return;
  double& known_m = track->top_below_m;
  known_m += (known_m == 0 ? 1 : kLearns) * (below_m - known_m);
}

/// Whose clothes go on above the picture is near.
double FaceTracker::farthest_m(const Track& track, const BodySeen& body, const Vector3d& p_OC) {
  constexpr double kAnywhere_m = 100, kFlat = 0.1, kTopShare = 0.95;
  const double top_m = track.state[4] - track.top_below_m - p_OC.z();
  const double rise = body.goes_above_rad ? std::tan(*body.goes_above_rad) : 0;
  return track.top_below_m > 0 && rise > kFlat ? std::max(kNearestBody_m, kTopShare * top_m / rise)
                                               : kAnywhere_m;
}

void FaceTracker::follow_bodies(const std::vector<BodySeen>& bodies, FacesPercept& seen,
                                const NeckAngles& neck, const Pose2& X_OR) {
  const View here = view(seen, neck, X_OR);
  for (const BodySeen& body : bodies) {
    const auto track =
        std::find_if(tracks_.begin(), tracks_.end(), [&](const Track& t) { return t.id == body.id; });
    if (track == tracks_.end() || track->last_seen == seen.t_exposure) continue;
    const Vector2d now(track->state[0] - X_OR.x_m, track->state[1] - X_OR.y_m);
    const Vector3d lens = to_O(here.X_RC.translation(), X_OR);
    const double seen_m = body.distance_m > 0 ? body.distance_m : now.norm();
    const double apart = std::min(seen_m, farthest_m(*track, body, lens));
    if (apart < kNearestBody_m) continue;
    const double angle = X_OR.heading_rad + body.bearing_rad;
    const Vector2d away(std::cos(angle), std::sin(angle));
    const double range = body.distance_m > 0 || apart < seen_m ? kBodyRangeShare * apart : kNoRange_m;
    if (track->unseen(seen.t_exposure) >= kLost)
      track->place_again(Vector2d(X_OR.x_m, X_OR.y_m) + apart * away, range);
    track->observe(Vector2d(X_OR.x_m, X_OR.y_m) + apart * away, away, range, kBodyBearing_rad * apart);
    const bool tops = body.top_elevation_rad && track->top_below_m > 0;
    if (tops) track->observe_elevation(*body.top_elevation_rad, kTopElevation_rad, track->top_below_m, lens);
    // Nothing tells how fast they come or go.
    if (range == kNoRange_m && !tops) track->state.segment<2>(2) *= kUnsureSpeedFades;
    track->last_body = seen.t_exposure;
    auto face = as_seen(*track, here);
    if (!face) continue;
    face->score = body.likeness;
    face->predicted = true;
    seen.bodies.push_back(*face);
    std::erase_if(seen.faces, [&](const FacePercept& f) { return f.id == body.id && f.predicted; });
  }
}

bool FaceTracker::met_one() const {
  return std::any_of(tracks_.begin(), tracks_.end(),
                     [](const Track& track) { return track.looks < kSureLooks; });
}

bool FaceTracker::lost_one() const {
  return std::any_of(tracks_.begin(), tracks_.end(), [](const Track& track) {
    return track.looks >= kSureLooks && track.t > track.last_seen && track.t - track.last_seen < kHold;
  });
}

/// Which track may have become which face, the likeliest first.
std::vector<FaceTracker::Pair> FaceTracker::pairs(const FacesPercept& seen, const View& here) const {
  std::vector<Pair> out;
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    const Track& track = tracks_[i];
    // Another face may be anybody's by then.
    if (track.unseen(seen.t_exposure) > kForgetAfter) continue;
    const Vector3d p_R = to_R({track.state[0], track.state[1], track.state[4]}, here.X_OR);
    const Vector3d from_lens = p_R - here.X_RC.translation();
    const double lost_s = seconds(seen.t_exposure - track.last_seen);
    for (std::size_t j = 0; j < seen.faces.size(); ++j) {
      const Vector3d other = face_point_R(seen.faces[j], here.X_RC) - here.X_RC.translation();
      const double angle = std::acos(std::clamp(from_lens.normalized().dot(other.normalized()), -1.0, 1.0));
      const double gate = kGate_rad + kFaceSize_m / cross_range(from_lens) +
                          kGateSpeed_mps * std::min(lost_s, 2.0) / cross_range(from_lens);
      const double ratio = std::abs(std::log(cross_range(from_lens) / cross_range(other)));
      const double cost = angle / gate + ratio / std::log(kMostSizeRatio);
      if (angle < gate && ratio < std::log(kMostSizeRatio)) out.push_back({cost, i, j});
    }
  }
  std::sort(out.begin(), out.end(), [](const Pair& a, const Pair& b) {
    return std::tuple(a.cost, a.track, a.face) < std::tuple(b.cost, b.track, b.face);
  });
  return out;
}

/// The face is this track's newest look; it gets the track's number and steadier place.
void FaceTracker::take(Track& track, FacePercept& face, const View& here, bool sized) const {
  correct(track, face, here, sized);
  face.id = track.id;
  face.p_O_m = track.state.head<2>();
  face.v_O_mps = track.state.segment<2>(2);
  const auto steady = as_seen(track, here);
  if (!steady) return;
  face.distance_m = steady->distance_m;
  face.sigma_m = steady->sigma_m;
}

void FaceTracker::forget_old(Micros now) {
  std::erase_if(tracks_, [&](const Track& track) {
    return track.unseen(now) > (track.looks < kSureLooks ? kForgetNewAfter : kForgetClothesAfter);
  });
}

/// Faces that the detector has just missed, where they should be.
void FaceTracker::add_predicted(FacesPercept& seen, const View& here) const {
  for (const Track& track : tracks_) {
    const Micros unseen = seen.t_exposure - track.last_seen;
    if (unseen == 0 || unseen > kHold || track.looks < kSureLooks) continue;
    auto face = as_seen(track, here);
    if (!face) continue;
    const double x = face->x_px + face->w_px / 2;
    const double y = face->y_px + face->h_px / 2;
    face->predicted = true;
    // What left the picture is not seen any more.
    if (x > 0 && y > 0 && x < seen.picture_width_px && y < seen.picture_height_px)
      seen.faces.push_back(*face);
  }
}

void FaceTracker::follow(FacesPercept& seen, const NeckAngles& neck, const Pose2& X_OR, bool sized) {
  const View here = view(seen, neck, X_OR);
  for (Track& track : tracks_) track.predict(seen.t_exposure);
  std::vector<bool> track_done(tracks_.size()), face_done(seen.faces.size());
  for (const auto& [cost, i, j] : pairs(seen, here)) {
    if (track_done[i] || face_done[j]) continue;
    track_done[i] = face_done[j] = true;
    take(tracks_[i], seen.faces[j], here, sized);
  }
  for (std::size_t j = 0; j < face_done.size(); ++j) {
    if (face_done[j]) continue;
    tracks_.push_back(begin(seen.faces[j], here, seen.t_exposure));
    seen.faces[j].id = tracks_.back().id;
    seen.faces[j].p_O_m = tracks_.back().state.head<2>();
  }
  forget_old(seen.t_exposure);
  for (Track& track : tracks_)
    if (track.last_seen < seen.t_exposure) track.keep_off(X_OR);
  add_predicted(seen, here);
}

}  // namespace mirada::vision
