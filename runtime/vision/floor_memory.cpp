#include "vision/floor_memory.h"

#include <algorithm>
#include <cmath>

#include "vision/skirting.h"
#include "vision/upright.h"

namespace mirada::vision {
namespace {

constexpr double kMoved_m = 0.01;
constexpr double kMoved_rad = 0.02;
constexpr std::size_t kMostlyBlind = 4;  // tenths
constexpr std::size_t kNearlyBlind = 9;
constexpr int kLostPictures = 10;
constexpr double kLostMove_m = 0.15;
constexpr double kLostTurn_rad = 0.35;

bool moved(const Pose2& a, const Pose2& b, double by_m, double by_rad) {
  return std::hypot(a.x_m - b.x_m, a.y_m - b.y_m) > by_m ||
         std::abs(wrap_rad(a.heading_rad - b.heading_rad)) > by_rad;
}

/// A gap of one or two columns between nearer things is no way through; it is more often a column that was
/// misjudged.
void close_gaps(std::vector<ColumnResult>& results) {
  const auto nearer = [](const ColumnResult& a, const ColumnResult& b) {
    constexpr double kJump_rows = 5;
    const bool ends = a.end == ColumnResult::End::boundary || a.end == ColumnResult::End::not_floor_below;
    return ends && a.row > b.row + kJump_rows;
  };
  for (const std::size_t gap : {1u, 2u}) {
    for (std::size_t i = 1; i + gap < results.size(); ++i) {
      const ColumnResult& left = results[i - 1];
      const ColumnResult& right = results[i + gap];
      bool is_gap = true;
      for (std::size_t k = i; k < i + gap; ++k)
        is_gap = is_gap && nearer(left, results[k]) && nearer(right, results[k]);
      if (!is_gap) continue;
      const ColumnResult kept = left.row < right.row ? left : right;
      for (std::size_t k = i; k < i + gap; ++k) results[k] = kept;
    }
  }
}

/// In so many tenths of its columns the picture does not begin with floor.
bool is_blind(const std::vector<ColumnResult>& results, std::size_t tenths) {
  std::size_t blind = 0;
  for (const ColumnResult& result : results) blind += result.end == ColumnResult::End::not_floor_below;
  return blind * 10 >= results.size() * tenths;
}

/// A picture whose floor goes on above the horizon, or that shows hardly any floor, teaches nothing.
bool plausible(const std::vector<ColumnResult>& results) {
  using End = ColumnResult::End;
  std::size_t through = 0;
  std::size_t floor = 0;
  std::size_t usable = 0;
  for (const ColumnResult& result : results) {
    through += result.end == End::through_horizon;
    floor += result.end == End::boundary || result.end == End::floor_to_top;
    usable += result.end != End::nothing && result.end != End::above_horizon;
  }
  return usable > 0 && through * 3 < usable && floor * 5 > usable;
}

}  // namespace

void FloorMemory::forget() {
  looks_.clear();
  lights_.forget();
  exposure_.forget();
  seen_from_.reset();
  tones_.clear();
  trusted_ = false;
  lost_pictures_ = blind_pictures_ = 0;
}

/// Bit for bit the picture before although the robot or its neck has moved: the camera repeats itself.
bool FloorMemory::is_frozen(const PictureGrid& grid, const Place& place) {
  const std::uint64_t fingerprint = grid.fingerprint();
  const bool same = last_place_ && fingerprint == fingerprint_;
  if (!same) {
    fingerprint_ = fingerprint;
    last_place_ = place;
    return false;
  }
  return moved(place.X_OR, last_place_->X_OR, kMoved_m, kMoved_rad) ||
         std::abs(place.neck.pan_rad - last_place_->neck.pan_rad) > kMoved_rad ||
         std::abs(place.neck.tilt_rad - last_place_->neck.tilt_rad) > kMoved_rad;
}

void FloorMemory::scan_columns(const PictureGrid& grid, const std::vector<ColumnSpan>& spans,
                               const RowScale& scale, const Look& home, ColumnScan& scan,
                               std::vector<ColumnResult>& results) const {
  const int middle = grid.columns() / 2;
  const auto run = [&](int column, const Look& start) {
    const auto i = static_cast<std::size_t>(column);
    results[i] = scan.run(column, spans[i], start);
    return scan.foot();
  };
  const Look foot = run(middle, home);
  Look start = foot;
  for (int column = middle - 1; column >= 0; --column) start = run(column, start);
  start = foot;
  for (int column = middle + 1; column < grid.columns(); ++column) start = run(column, start);
  stop_at_upright(scan, spans, results);
  stop_at_skirting(grid, scale, spans, scan, results);
  close_gaps(results);
}

/// Another part of the room is seen than in the picture before.
bool FloorMemory::has_turned_away(const Place& place) const {
  constexpr double kTurn_rad = 0.15;
  return !seen_from_ || moved(place.X_OR, seen_from_->X_OR, kLostMove_m, kTurn_rad) ||
         std::abs(place.neck.pan_rad - seen_from_->neck.pan_rad) > kTurn_rad ||
         std::abs(place.neck.tilt_rad - seen_from_->neck.tilt_rad) > kTurn_rad;
}

/// From here on all looks are those of the exposure that the floor was learnt in.
void FloorMemory::expose(PictureGrid& grid) {
  study_.expose(exposure_.light() - grid.exposure());
  grid.expose(exposure_.light());
}

bool FloorMemory::scan(PictureGrid& grid, const std::vector<ColumnSpan>& spans, const RowScale& scale,
                       const ScanSettings& settings, const Pose2& X_OR, const NeckAngles& neck,
                       std::vector<ColumnResult>& results) {
  const Place place{X_OR, neck};
  can_learn_ = false;
  if (is_frozen(grid, place)) return false;
  const FloorStudy::Verdict verdict = study_.run(grid, spans, scale.depth_m);
  if (verdict == FloorStudy::Verdict::dark || verdict == FloorStudy::Verdict::glaring) return false;
  const bool shows_floor = verdict == FloorStudy::Verdict::floor;
  const bool first = !trusted_;
  if (first) {
    if (!shows_floor) return false;
    exposure_.forget();
    looks_.clear();
    tones_.clear();
    study_.teach(looks_);
    study_.teach(tones_);
    home_ = study_.main_look();
    lights_.start(home_);
    texture_ = study_.texture();
  }
  const bool compared = !first && shows_floor;
  if (compared) exposure_.see(grid, spans, looks_, home_, study_.main_look(), !has_turned_away(place));
  seen_from_ = place;
  expose(grid);
  ColumnScan column_scan(grid, looks_, lights_, tones_, scale);
  column_scan.prepare(texture_, home_, settings);
  scan_columns(grid, spans, scale, home_, column_scan, results);
  if (compared && exposure_.has_changed() && !plausible(results)) {
    exposure_.take_back();
    expose(grid);
    scan_columns(grid, spans, scale, home_, column_scan, results);
  }
  if (first) {
    // What this picture alone shows of a floor's other colours.
    if (learn_patches(grid, results)) scan_columns(grid, spans, scale, home_, column_scan, results);
    trusted_ = plausible(results);
    if (trusted_) see_crossed_lights(grid, results);
    return trusted_;
  }
  if (blind_all_round(results, place) && shows_floor && is_in_other_light()) {
    // The looks that are known are still compared with the old one: all have become so much brighter.
    blind_results_ = results;
    scan_columns(grid, spans, scale, study_.main_look(), column_scan, results);
    if (plausible(results)) {
      home_ = study_.main_look();
      blind_pictures_ = lost_pictures_ =
          0;  // known again; what it looks like now is learnt from the next picture on
      return true;
    }
    results = blind_results_;
  }
  if (is_lost(grid, spans, results, place)) {
    forget();
    return false;
  }
  can_learn_ = shows_floor && plausible(results);
  if (can_learn_) see_crossed_lights(grid, results);
  return true;
}

/// What lies before the robot has the floor's colour in another light. Grey is everything's colour in some
/// light: that is no sign.
bool FloorMemory::is_in_other_light() const {
  constexpr int kSameColour = 8;
  const Look& main = study_.main_look();
  return has_colour(home_) && std::abs(main.red - home_.red) <= kSameColour &&
         std::abs(main.blue - home_.blue) <= kSameColour;
}

/// Pictures before this one have begun without the floor in many columns, too, and the robot or its neck has
/// moved since: one thing that stands in the way would hardly have stayed there.
bool FloorMemory::blind_all_round(const std::vector<ColumnResult>& results, const Place& place) {
  constexpr int kBlindBefore = 1;
  if (!is_blind(results, kMostlyBlind)) {
    blind_pictures_ = 0;
    return false;
  }
  if (blind_pictures_++ == 0) blind_since_ = place;
  return blind_pictures_ > kBlindBefore &&
         (moved(place.X_OR, blind_since_.X_OR, kLostMove_m, kLostTurn_rad) ||
          std::abs(place.neck.pan_rad - blind_since_.neck.pan_rad) > kLostTurn_rad);
}

/// The floor that was learnt is nowhere to be seen, although the robot has looked round: it stands on another
/// floor, or the light has changed. One that is still seen anywhere is not lost: then something stands in the
/// way.
bool FloorMemory::is_lost(const PictureGrid& grid, const std::vector<ColumnSpan>& spans,
                          const std::vector<ColumnResult>& results, const Place& place) {
  int known = 0;
  int seen = 0;
  if (is_blind(results, kNearlyBlind)) {
    for (std::size_t i = 1; i < spans.size(); i += 4) {
      for (int row = spans[i].bottom_row; row > spans[i].horizon_row; row -= 8) {
        known += looks_.knows(grid.look(static_cast<int>(i), row));
        ++seen;
      }
    }
  }
  if (seen == 0 || known * 33 > seen) {
    lost_pictures_ = 0;
    return false;
  }
  if (lost_pictures_++ == 0) lost_since_ = place;
  return lost_pictures_ > kLostPictures && moved(place.X_OR, lost_since_.X_OR, kLostMove_m, kLostTurn_rad);
}

}  // namespace mirada::vision
