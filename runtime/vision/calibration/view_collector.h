#pragma once
#include <optional>
#include <vector>

#include "base/fault.h"
#include "vision/calibration/board_hold.h"
#include "vision/calibration/coverage.h"

namespace mirada::vision {

/// Where the board is to be held next.
struct NextHold {
  const Message* words = nullptr;  ///< never null
  Eigen::Isometry3d X_CB = Eigen::Isometry3d::Identity();
};

/// Collects a calibration's views live: takes a board that is held still somewhere new, and says where it is
/// missing. One thread.
class ViewCollector {
 public:
  static constexpr std::size_t kGood = 12;  ///< views that are asked for
  static constexpr std::size_t kFew = 8;    ///< views that will do when there are no more places to hold it
  static constexpr std::size_t kMost = 24;

  /// `guess` has the pictures' size; its lens need only be roughly right.
  ViewCollector(const BoardSpec& board, const CameraModel& guess);

  enum class Verdict {
    taken,
    moving,   ///< not held still since the picture before
    known,    ///< as in a view that was taken already
    unclear,  ///< no pose fits what was seen
    full
  };
  /// A board was seen. `now`: a person asks to take it, moving or not.
  Verdict look(const BoardView& view, bool now);
  /// A picture without a usable board.
  void look_in_vain() { last_.reset(); }

  const std::vector<BoardView>& views() const { return views_; }
  const Coverage& coverage() const { return coverage_; }
  double tilt_spread_rad() const { return tilt_spread_rad_; }
  /// Whether a trustworthy calibration can be expected of these views.
  bool enough() const;
  /// Nothing when every place asked for has been shown (or tried in vain).
  std::optional<NextHold> next() const;

 private:
  struct Stop {
    const Message* words;
    BoardHold hold;
    bool done;
  };

  bool is_new(const BoardHold& hold) const;
  void take(const BoardView& view, const BoardHold& hold);

  BoardSpec board_;
  CameraModel camera_;
  std::vector<Stop> tour_;
  int tries_ = 0;  ///< pictures with a board since the tour's present stop came up
  std::optional<BoardHold> last_;
  std::vector<BoardView> views_;
  std::vector<BoardHold> holds_;
  Coverage coverage_;
  double tilt_spread_rad_ = 0;
};

}  // namespace mirada::vision
