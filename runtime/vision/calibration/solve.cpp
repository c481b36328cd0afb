#include "vision/calibration/solve.h"

#include <algorithm>
#include <cmath>

#include <opencv2/calib3d.hpp>

#include "base/units.h"
#include "vision/calibration/coverage.h"
#include "vision/calibration/lens_fit.h"
#include "vision/calibration/messages.h"

namespace mirada::vision {
namespace {

constexpr std::size_t kFewestToSolve = 3;
constexpr double kSameView = 0.004;  ///< of the picture's width, mean over the corners
constexpr double kWorstView = 3;     ///< times the median view's error
/// Brown bends too little for a view this wide; and only a clear gain is worth the fisheye otherwise.
constexpr double kBrownWidest_rad = rad(105);
constexpr double kClearGain = 1.5;

double mean_shift_px(const BoardView& a, const BoardView& b) {
  if (a.corners_px.size() != b.corners_px.size()) return 1e9;
  double sum = 0;
  for (std::size_t i = 0; i < a.corners_px.size(); ++i) sum += cv::norm(a.corners_px[i] - b.corners_px[i]);
  return sum / static_cast<double>(a.corners_px.size());
}

void leave_out_repeats(std::vector<BoardView>& views, Faults& refused) {
  std::vector<BoardView> kept;
  for (BoardView& view : views) {
    const auto same = std::find_if(kept.begin(), kept.end(), [&](const BoardView& other) {
      return mean_shift_px(view, other) < kSameView * view.size_px.width;
    });
    if (same == kept.end()) {
      kept.push_back(std::move(view));
    } else {
      refused.push_back(make_fault(view.image, messages::view_repeated, {{"other", same->image}}));
    }
  }
  views = std::move(kept);
}

double edge_to_edge_rad(const CameraModel& camera, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const auto a = camera.unproject(from);
  const auto b = camera.unproject(to);
  return a && b ? std::acos(std::clamp(a->normalized().dot(b->normalized()), -1.0, 1.0)) : 0;
}

double seen_across_rad(const CameraModel& camera) {
  return edge_to_edge_rad(camera, {-0.5, camera.cy_px}, {camera.width_px - 0.5, camera.cy_px});
}

LensFit fit_lens(const std::vector<BoardView>& views, LensChoice choice) {
  if (choice == LensChoice::fisheye) return fit_fisheye(views);
  LensFit brown = fit_brown(views);
  if (choice == LensChoice::brown) return brown;
  const double across_rad = brown.solved ? seen_across_rad(brown.camera) : 0;
  const bool brown_will_do = brown.solved && across_rad > 0 && across_rad < kBrownWidest_rad;
  LensFit fisheye = fit_fisheye(views);
  if (!fisheye.solved) return brown;
  const bool much_better = fisheye.rms_px * kClearGain < brown.rms_px;
  return brown_will_do && !much_better ? brown : fisheye;
}

/// Leaves out the worst view when it stands far out; false when all fit.
bool leave_out_worst(std::vector<BoardView>& views, const LensFit& fit, Faults& refused) {
  std::vector<double> sorted = fit.view_rms_px;
  std::sort(sorted.begin(), sorted.end());
  const double most_px = std::max(kWorstView * sorted[sorted.size() / 2], 0.3);
  const auto worst = std::max_element(fit.view_rms_px.begin(), fit.view_rms_px.end());
  if (*worst <= most_px || views.size() <= kFewestToSolve) return false;
  const auto at = worst - fit.view_rms_px.begin();
  refused.push_back(make_fault(views[static_cast<std::size_t>(at)].image, messages::view_does_not_fit,
                               {{"value", number_text(*worst, 2)}, {"max", number_text(most_px, 2)}}));
  views.erase(views.begin() + at);
  return true;
}

double diagonal_m(const std::vector<BoardView>& views) {
  double out = 0;
  for (const BoardView& view : views) {
    if (!view.corners_B_m.empty())
      out = std::max(out, cv::norm(view.corners_B_m.back() - view.corners_B_m.front()));
  }
  return out;
}

void describe_views(const std::vector<BoardView>& views, const LensFit& fit, Calibration& out) {
  std::vector<cv::Vec3d> normals;
  for (std::size_t i = 0; i < views.size(); ++i) {
    cv::Mat R;
    cv::Rodrigues(fit.rotations[i], R);
    const cv::Vec3d normal(R.at<double>(0, 2), R.at<double>(1, 2), R.at<double>(2, 2));
    SolvedView view{views[i].image, fit.view_rms_px[i], views[i].edge_width_px, 0, {}, 0};
    view.tilt_rad = std::acos(std::clamp(std::abs(normal[2]), 0.0, 1.0));
    std::copy_n(normal.val, 3, view.normal_C);
    view.distance_m = cv::norm(fit.translations[i]);
    out.views.push_back(view);
    for (const cv::Vec3d& other : normals) {
      const double apart_rad = std::acos(std::clamp(normal.dot(other), -1.0, 1.0));
      out.largest_tilt_between_rad = std::max(out.largest_tilt_between_rad, apart_rad);
    }
    normals.push_back(normal);
  }
}

}  // namespace

Result<Calibration> solve(std::vector<BoardView> views, LensChoice lens) {
  Calibration out;
  leave_out_repeats(views, out.refused);
  if (views.size() < kFewestToSolve) {
    Faults faults = out.refused;
    faults.push_back(
        make_fault("set", messages::set_too_few, {{"value", std::to_string(views.size())}, {"min", "6"}}));
    return faults;
  }
  LensFit fit = fit_lens(views, lens);
  while (fit.solved && leave_out_worst(views, fit, out.refused)) fit = fit_lens(views, lens);
  if (!fit.solved) {
    Faults faults = out.refused;
    faults.push_back(make_fault("set", messages::set_not_solved));
    return faults;
  }
  out.camera = fit.camera;
  out.rms_px = fit.rms_px;
  out.sigma_fx_px = fit.sigma_fx_px;
  out.sigma_fy_px = fit.sigma_fy_px;
  out.sigma_cx_px = fit.sigma_cx_px;
  out.sigma_cy_px = fit.sigma_cy_px;
  out.seen_hfov_rad = seen_across_rad(out.camera);
  out.seen_vfov_rad =
      edge_to_edge_rad(out.camera, {out.camera.cx_px, -0.5}, {out.camera.cx_px, out.camera.height_px - 0.5});
  Coverage coverage = coverage_of(views);
  out.coverage = coverage.share;
  out.zone_coverage = std::move(coverage.zones);
  describe_views(views, fit, out);
  out.board = examine_board(views, fit);
  out.board_diagonal_m = diagonal_m(views);
  return out;
}

}  // namespace mirada::vision
