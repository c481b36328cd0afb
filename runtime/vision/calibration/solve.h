#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "model/camera_model.h"
#include "vision/calibration/board.h"
#include "vision/calibration/board_truth.h"

namespace mirada::vision {

enum class LensChoice { brown, fisheye, automatic };

/// One picture's share in a calibration.
struct SolvedView {
  std::string image;
  double rms_px = 0;
  double edge_width_px = 0;
  double tilt_rad = 0;      ///< between the board's normal and the optical axis
  double normal_C[3] = {};  ///< the board's normal in the camera's frame
  double distance_m = 0;    ///< from the lens to the board's first corner
};

struct Calibration {
  CameraModel camera;
  double rms_px = 0;
  double sigma_fx_px = 0;
  double sigma_fy_px = 0;
  double sigma_cx_px = 0;
  double sigma_cy_px = 0;
  double coverage = 0;                ///< share of the picture that the board was shown in
  std::vector<double> zone_coverage;  ///< the same of nine zones, row by row
  double largest_tilt_between_rad = 0;
  double seen_hfov_rad = 0;  ///< from edge to edge through the distortion
  double seen_vfov_rad = 0;
  double board_diagonal_m = 0;
  BoardTruth board;  ///< is the print flat, are its squares square?
  std::vector<SolvedView> views;
  Faults refused;  ///< pictures left out, and why
};

/// Lens and distortion from views of one size; views that repeat another or that fit no flat board are left
/// out and named in `refused`. Faults when there are not enough views, or no lens fits. Takes a second or so
/// for 13 views. Deterministic.
Result<Calibration> solve(std::vector<BoardView> views, LensChoice lens);

}  // namespace mirada::vision
