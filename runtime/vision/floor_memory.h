#pragma once
#include <optional>
#include <vector>

#include "model/geometry.h"
#include "vision/column_scan.h"
#include "vision/exposure_watch.h"
#include "vision/floor_looks.h"
#include "vision/floor_study.h"
#include "vision/picture_grid.h"

namespace mirada::vision {

/// What is known of the floor's look from one picture to the next, when it may be learnt and when it is lost.
class FloorMemory {
 public:
  void forget();
  /// A floor has been learnt.
  bool knows_floor() const { return trusted_; }

  /// Scans every column of a picture. False: this picture cannot be used or no floor is known that could be
  /// trusted; `results` mean nothing then.
  bool scan(PictureGrid& grid, const std::vector<ColumnSpan>& spans, const RowScale& scale,
            const ScanSettings& settings, const Pose2& X_OR, const NeckAngles& neck,
            std::vector<ColumnResult>& results);
  /// Learns from the floor that scan() found in this picture, as far as `results` still call it floor.
  void learn(const PictureGrid& grid, const std::vector<ColumnSpan>& spans, const RowScale& scale,
             const std::vector<ColumnResult>& results);

 private:
  struct Place {
    Pose2 X_OR;
    NeckAngles neck;
  };
  bool is_frozen(const PictureGrid& grid, const Place& place);
  bool has_turned_away(const Place& place) const;
  void expose(PictureGrid& grid);
  void scan_columns(const PictureGrid& grid, const std::vector<ColumnSpan>& spans, const RowScale& scale,
                    const Look& home, ColumnScan& scan, std::vector<ColumnResult>& results) const;
  bool learn_patches(const PictureGrid& grid, const std::vector<ColumnResult>& results);
  bool blind_all_round(const std::vector<ColumnResult>& results, const Place& place);
  void see_crossed_lights(const PictureGrid& grid, const std::vector<ColumnResult>& results);
  void learn_tones(const PictureGrid& grid, const std::vector<ColumnSpan>& spans, const RowScale& scale,
                   const std::vector<ColumnResult>& results);
  bool is_in_other_light() const;
  bool is_lost(const PictureGrid& grid, const std::vector<ColumnSpan>& spans,
               const std::vector<ColumnResult>& results, const Place& place);

  FloorLooks looks_;
  FloorLights lights_;
  FloorTones tones_;
  ExposureWatch exposure_;
  FloorStudy study_;
  FloorTexture texture_;
  Look home_;  ///< the look at the picture's foot, followed
  bool trusted_ = false;
  bool can_learn_ = false;  ///< from the picture scanned last
  int pictures_since_fade_ = 0;
  int lost_pictures_ = 0;
  Place lost_since_;
  int blind_pictures_ = 0;
  Place blind_since_;
  std::vector<ColumnResult> blind_results_;
  std::uint64_t fingerprint_ = 0;
  std::optional<Place> last_place_;  ///< of the picture that differs from the one before
  std::optional<Place> seen_from_;   ///< the picture scanned last
};

}  // namespace mirada::vision
