#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/fault.h"

namespace mirada::session {

/// What the calibration wizard is told of the board and the camera, as people say it.
struct CalibrationPlan {
  bool charuco = false;
  std::string size = "9x6";  ///< inner corners; charuco: squares
  double square_mm = 25;
  double marker_mm = 0;  ///< charuco; 0 = three fifths of a square
  std::string dictionary = "4x4";
  std::string camera;  ///< id of a datasheet, "" = unknown
};

struct CalibrationStep {
  enum class Action { begin, take, finish, save, cancel };
  Action action = Action::cancel;
  CalibrationPlan plan;  ///< begin
};

/// Pixels; pixel centres at integers, top left origin.
using PicturePoint = std::array<float, 2>;
using Outline = std::vector<PicturePoint>;

/// What the calibration wizard shows at one moment. Immutable once published.
struct Calibration {
  enum class Phase {
    off,
    looking,
    working,  ///< solving
    ready,    ///< trusted, not yet saved
    poor,     ///< solved and not trusted (or not solvable); looking goes on when asked to
    saved
  };
  Phase phase = Phase::off;
  bool room_holds = false;  ///< the simulated room holds the board
  std::uint64_t frame = 0;
  int width_px = 0;
  int height_px = 0;
  Outline corners;             ///< of the board in `frame`; empty when it is not seen
  std::vector<Outline> taken;  ///< where the board has been
  Outline target;              ///< where to hold it next; empty when anywhere will do
  std::optional<Fault> next;   ///< the same in words
  std::optional<Fault> now;    ///< what is with the newest picture
  std::size_t views = 0;
  std::size_t views_needed = 0;  ///< below this no result
  std::size_t views_good = 0;    ///< asked for
  double coverage = 0;           ///< 0..1
  double tilt_deg = 0;           ///< largest angle between two boards

  double rms_px = 0;  ///< ready, poor, saved; 0 when there is no result
  double hfov_deg = 0;
  double vfov_deg = 0;
  std::vector<double> view_rms_px;
  Faults words;  ///< the result in sentences; poor: why it is not trusted
};

const char* to_string(Calibration::Phase phase);

}  // namespace mirada::session
