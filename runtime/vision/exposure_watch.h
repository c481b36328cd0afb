#pragma once
#include <optional>
#include <vector>

#include "vision/column_scan.h"
#include "vision/floor_looks.h"
#include "vision/picture_grid.h"

namespace mirada::vision {

/// How much lighter pictures are than those that the floor was learnt from: a camera sets its exposure anew
/// whenever what it sees changes, for the whole picture at once.
class ExposureWatch {
 public:
  void forget();
  /// In units of light, as far as the pictures seen tell.
  int light() const { return light_; }
  /// Compares a picture, whose main look before the robot is `main`, with the floor that is known.
  /// `same_view`: it shows what the picture before it showed.
  void see(const PictureGrid& grid, const std::vector<ColumnSpan>& spans, const FloorLooks& looks,
           const Look& home, const Look& main, bool same_view);
  /// Whether the last see() found another exposure than before.
  bool has_changed() const { return light_ != before_; }
  void take_back() { light_ = before_; }

 private:
  int light_ = 0;
  int before_ = 0;
  std::optional<int> above_;  ///< mean light above the horizon in the picture before
};

}  // namespace mirada::vision
