#include "vision/faces/face_watch.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <opencv2/imgproc.hpp>

namespace mirada::vision {
namespace {

constexpr double kPatchSide_px = 24;  // patches are compared in this size
constexpr double kReachShare = 0.5;   // of the face's size, to each side
constexpr double kReach_px = 8;
constexpr double kPatchLike = 0.6;  // normalised correlation

}  // namespace

void FaceWatch::forget() {
  tracker_.forget();
  bodies_.forget();
  namer_.forget();
  patches_.clear();
  searched_ = false;
}

FacesPercept FaceWatch::look(const Frame& frame, const NeckAngles& neck, const Pose2& X_OR) {
  const Micros since = frame.t_exposure - searched_at_;
  const bool usable = !frame.bgr.empty() && frame.bgr.type() == CV_8UC3;
  if (usable) cv::cvtColor(frame.bgr, gray_, cv::COLOR_BGR2GRAY);
  const bool soon = tracker_.lost_one() || tracker_.met_one();
  const bool search = !searched_ || since < 0 || since >= (soon ? kSearchSoon : kSearchEvery);
  FacesPercept seen = search || !usable ? finder_->find(frame, neck) : follow_patches(frame, neck, X_OR);
  if (search) {
    searched_ = true;
    searched_at_ = frame.t_exposure;
  }
  tracker_.follow(seen, neck, X_OR, search || !usable);
  if (search && usable) keep_patches(seen);
  if (usable) follow_bodies(frame, neck, X_OR, seen);
  namer_.look(frame.bgr, seen, search && usable);
  std::sort(seen.faces.begin(), seen.faces.end(), [](const FacePercept& a, const FacePercept& b) {
    return std::tuple(-a.w_px, a.x_px, a.y_px) < std::tuple(-b.w_px, b.x_px, b.y_px);
  });
  return seen;
}

void FaceWatch::follow_bodies(const Frame& frame, const NeckAngles& neck, const Pose2& X_OR,
                              FacesPercept& seen) {
  if (tracker_.ids().empty()) return;
  bodies_.look(frame.bgr);
  bodies_.keep_only(tracker_.ids());
  const auto placed = [&](int id, const BodyTracker::Body& body) {
    const FacePercept trunk = finder_->place({body.box_px, body.likeness}, frame, neck);
    FaceTracker::BodySeen out{id, trunk.bearing_rad, 0, body.likeness, std::nullopt};
    const auto elevation_rad = [&](double y_px) {
      const cv::Rect2d edge(body.box_px.x, y_px - 1, body.box_px.width, 2);
      return finder_->place({edge, body.likeness}, frame, neck).elevation_rad;
    };
    if (body.top_px) out.top_elevation_rad = elevation_rad(*body.top_px);
    if (body.goes_above) out.goes_above_rad = elevation_rad(1);
    return out;
  };
  std::vector<FaceTracker::BodySeen> found;
  for (const FacePercept& face : tracker_.expected(seen, neck, X_OR)) {
    const auto shown = std::find_if(seen.faces.begin(), seen.faces.end(), [&](const FacePercept& other) {
      return other.id == face.id && !other.predicted;
    });
    const auto body = shown == seen.faces.end() ? bodies_.find(face) : bodies_.learn(*shown);
    if (!body) continue;
    const FaceTracker::BodySeen here = placed(face.id, *body);
    if (shown != seen.faces.end()) {
      tracker_.learn_top(here, neck, X_OR);
      continue;
    }
    found.push_back(here);
    found.back().distance_m = bodies_.distance_m(face.id, *body, face.distance_m);
  }
  for (const FacePercept& face : tracker_.lost_ahead(seen, neck, X_OR)) {
    const bool there =
        std::any_of(found.begin(), found.end(), [&](const auto& f) { return f.id == face.id; });
    const auto body = there ? std::nullopt : bodies_.find_again(face);
    if (!body) continue;
    found.push_back(placed(face.id, *body));
    found.back().distance_m = bodies_.distance_m(face.id, *body);
  }
  tracker_.follow_bodies(found, seen, neck, X_OR);
}

void FaceWatch::keep_patches(const FacesPercept& seen) {
  patches_.clear();
  for (const FacePercept& face : seen.faces) {
    const cv::Rect box =
        cv::Rect(cvRound(face.x_px), cvRound(face.y_px), cvRound(face.w_px), cvRound(face.h_px)) &
        cv::Rect({}, gray_.size());
    if (face.predicted || box.width < 8 || box.height < 8) continue;
    Patch patch{face.id, std::min(1.0, kPatchSide_px / box.width), face.w_px, face.h_px, face.score, {}};
    cv::resize(gray_(box), patch.gray, {}, patch.scale, patch.scale, cv::INTER_AREA);
    patches_.push_back(std::move(patch));
  }
}

FacesPercept FaceWatch::follow_patches(const Frame& frame, const NeckAngles& neck, const Pose2& X_OR) {
  FacesPercept out = finder_->none(frame);
  for (const FacePercept& guess : tracker_.expected(out, neck, X_OR)) {
    const auto patch =
        std::find_if(patches_.begin(), patches_.end(), [&](const Patch& p) { return p.id == guess.id; });
    if (patch == patches_.end()) continue;
    const double reach = kReach_px + kReachShare * patch->w_px;
    const double x = guess.x_px + (guess.w_px - patch->w_px) / 2 - reach;
    const double y = guess.y_px + (guess.h_px - patch->h_px) / 2 - reach;
    const cv::Rect around =
        cv::Rect(cvFloor(x), cvFloor(y), cvCeil(patch->w_px + 2 * reach), cvCeil(patch->h_px + 2 * reach)) &
        cv::Rect({}, gray_.size());
    cv::Mat field;
    if (around.width < 8 || around.height < 8) continue;
    cv::resize(gray_(around), field, {}, patch->scale, patch->scale, cv::INTER_AREA);
    if (field.cols < patch->gray.cols || field.rows < patch->gray.rows) continue;
    cv::Mat likeness;
    cv::matchTemplate(field, patch->gray, likeness, cv::TM_CCOEFF_NORMED);
    double best = 0;
    cv::Point at;
    cv::minMaxLoc(likeness, nullptr, &best, nullptr, &at);
    if (!(best >= kPatchLike)) continue;
    const cv::Rect2d box(around.x + at.x / patch->scale, around.y + at.y / patch->scale, patch->w_px,
                         patch->h_px);
    out.faces.push_back(finder_->place({box, best * patch->score}, frame, neck));
  }
  return out;
}

}  // namespace mirada::vision
