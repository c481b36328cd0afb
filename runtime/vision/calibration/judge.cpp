#include "vision/calibration/judge.h"

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "vision/calibration/messages.h"

namespace mirada::vision {
namespace {

constexpr double kLeastTiltBetween_rad = rad(20);
constexpr double kLeastCoverage = 0.35;
constexpr double kHighestRms_px = 0.6;  ///< for pictures up to 800 pixels wide
constexpr double kMostFocalSigma = 0.01;
constexpr double kMostOffCentre = 0.15;
constexpr double kLeastPixelRatio = 0.9;
constexpr double kMostPixelRatio = 1.1;
constexpr double kSigmasToSay = 5;
constexpr double kMostSquareStretch = 0.01;
constexpr double kBendToSay = 0.005;  ///< of the board's diagonal
constexpr double kMostBend = 0.02;
constexpr double kTellingTolerance = 0.1;  ///< a sheet vaguer than this fits nearly every camera

void check_views(const Calibration& c, Faults& faults) {
  if (c.views.size() < static_cast<std::size_t>(kFewestViews)) {
    faults.push_back(
        make_fault("set", messages::set_too_few,
                   {{"value", std::to_string(c.views.size())}, {"min", std::to_string(kFewestViews)}}));
  }
  if (c.largest_tilt_between_rad < kLeastTiltBetween_rad) {
    faults.push_back(make_fault("set", messages::set_not_tilted,
                                {{"value", number_text(deg(c.largest_tilt_between_rad), 0)},
                                 {"min", number_text(deg(kLeastTiltBetween_rad), 0)}}));
  }
}

/// The word for the emptiest side of the picture, in English and Spanish at once: a fault has one set of
/// arguments for both languages.
std::string emptiest_zone(const std::vector<double>& zones) {
  const auto sum = [&](std::initializer_list<std::size_t> of) {
    double total = 0;
    for (const std::size_t i : of) total += zones[i] / static_cast<double>(of.size());
    return total;
  };
  const std::pair<double, const Message*> sides[] = {{sum({0, 1, 2}), &messages::zone_top},
                                                     {sum({6, 7, 8}), &messages::zone_bottom},
                                                     {sum({0, 3, 6}), &messages::zone_left},
                                                     {sum({2, 5, 8}), &messages::zone_right},
                                                     {zones[4], &messages::zone_middle}};
  const auto* least = std::min_element(std::begin(sides), std::end(sides),
                                       [](const auto& a, const auto& b) { return a.first < b.first; });
  return std::string(least->second->en) + " / " + std::string(least->second->es);
}

void check_coverage(const Calibration& c, Faults& faults) {
  if (c.coverage >= kLeastCoverage) return;
  faults.push_back(make_fault("set", messages::set_covers_little,
                              {{"value", number_text(100 * c.coverage, 0)},
                               {"min", number_text(100 * kLeastCoverage, 0)},
                               {"where", emptiest_zone(c.zone_coverage)}}));
}

void check_errors(const Calibration& c, Faults& faults) {
  const double most_px = highest_rms_px(c.camera);
  if (c.rms_px > most_px) {
    faults.push_back(make_fault("set", messages::set_rms_high,
                                {{"value", number_text(c.rms_px, 2)}, {"max", number_text(most_px, 2)}}));
  }
  const double unsure = c.sigma_fx_px / c.camera.fx_px;
  if (!(unsure <= kMostFocalSigma)) {
    faults.push_back(make_fault(
        "set", messages::set_focal_unsure,
        {{"value", number_text(100 * unsure, 1)}, {"max", number_text(100 * kMostFocalSigma, 1)}}));
  }
}

void check_lens(const Calibration& c, Faults& faults) {
  const CameraModel& camera = c.camera;
  const double ratio = camera.fx_px / camera.fy_px;
  if (ratio < kLeastPixelRatio || ratio > kMostPixelRatio) {
    faults.push_back(make_fault("set", messages::set_pixels_not_square,
                                {{"value", number_text(ratio, 2)},
                                 {"min", number_text(kLeastPixelRatio, 2)},
                                 {"max", number_text(kMostPixelRatio, 2)}}));
  }
  const double off = std::max(std::abs(camera.cx_px / (camera.width_px - 1) - 0.5),
                              std::abs(camera.cy_px / (camera.height_px - 1) - 0.5));
  if (off > kMostOffCentre) {
    faults.push_back(
        make_fault("set", messages::set_centre_far,
                   {{"value", number_text(100 * off, 0)}, {"max", number_text(100 * kMostOffCentre, 0)}}));
  }
  if (c.seen_hfov_rad == 0 || c.seen_vfov_rad == 0) {
    faults.push_back(make_fault("set", messages::set_lens_folds));
  }
}

/// What the corners say of the print: a screen or a printer that stretches, paper that bends.
void check_board(const Calibration& c, Faults& faults) {
  const double off = std::abs(c.board.stretch - 1);
  if (off > kMostSquareStretch && off > kSigmasToSay * c.board.sigma_stretch) {
    faults.push_back(make_fault("set", messages::set_board_stretched,
                                {{"value", number_text(100 * (c.board.stretch - 1), 1)},
                                 {"max", number_text(100 * kMostSquareStretch, 0)}}));
  }
  const double bend = c.board.bend_m / std::max(1e-6, c.board_diagonal_m);
  if (bend > kBendToSay && c.board.bend_m > kSigmasToSay * c.board.sigma_bend_m) {
    faults.push_back(make_fault("set", messages::set_board_bent,
                                {{"value", number_text(1000 * c.board.bend_m, 1)}},
                                bend > kMostBend ? Severity::error : Severity::warning));
  }
}

/// What the sheet's angle is compared with: the pinhole's for ordinary lenses (sheets compute theirs so),
/// what is really seen for wide ones.
double comparable_view_rad(const Calibration& c) {
  return c.camera.lens == CameraModel::Lens::fisheye ? c.seen_hfov_rad : c.camera.hfov_rad();
}

std::string size_text(const CameraModel& camera) {
  return std::to_string(camera.width_px) + "x" + std::to_string(camera.height_px);
}

}  // namespace

double highest_rms_px(const CameraModel& camera) {
  return kHighestRms_px * std::max(1.0, camera.width_px / 800.0);
}

Faults distrust(const Calibration& calibration) {
  Faults faults;
  check_views(calibration, faults);
  check_coverage(calibration, faults);
  // What a lens comes to from a handful of pictures is worth no sentence.
  if (calibration.views.size() < static_cast<std::size_t>(kFewestViews)) return faults;
  check_errors(calibration, faults);
  check_lens(calibration, faults);
  check_board(calibration, faults);
  return faults;
}

Faults check_datasheet(const Calibration& calibration, const CameraPreset& preset,
                       const std::vector<CameraPreset>& others) {
  const CameraModel& camera = calibration.camera;
  const double hfov_rad = comparable_view_rad(calibration);
  const CameraMode* mode = preset.nearest_mode(camera.width_px, camera.height_px, hfov_rad);
  if (!mode) {
    return {make_fault("camera", messages::view_shape_unknown,
                       {{"camera", preset.name_en}, {"value", size_text(camera)}}, Severity::warning)};
  }
  if (preset.agrees(*mode, hfov_rad)) return {};
  Faults faults = {make_fault("camera", messages::view_unlike_datasheet,
                              {{"value", number_text(deg(hfov_rad), 1)},
                               {"camera", preset.name_en},
                               {"wanted", number_text(deg(mode->hfov_rad), 1)}})};
  for (const CameraPreset& other : others) {
    if (other.tolerance > kTellingTolerance) continue;
    const CameraMode* fitting = other.nearest_mode(camera.width_px, camera.height_px, hfov_rad);
    if (other.id == preset.id || !fitting || !other.agrees(*fitting, hfov_rad)) continue;
    faults.push_back(make_fault("camera", messages::view_fits_other, {{"camera", other.name_en}}));
  }
  if (faults.size() == 1) faults.push_back(make_fault("camera", messages::view_fits_none));
  return faults;
}

}  // namespace mirada::vision
