#pragma once
#include <vector>

#include "model/camera_model.h"
#include "vision/calibration/board.h"

namespace mirada::vision {

/// What OpenCV's bundle adjustment makes of a set of views.
struct LensFit {
  bool solved = false;
  CameraModel camera;
  double rms_px = 0;
  double sigma_fx_px = 0, sigma_fy_px = 0, sigma_cx_px = 0, sigma_cy_px = 0;
  std::vector<double> view_rms_px;
  std::vector<cv::Mat> rotations;  ///< Rodrigues vectors, board to camera
  std::vector<cv::Mat> translations;
};
LensFit fit_brown(const std::vector<BoardView>& views);
LensFit fit_fisheye(const std::vector<BoardView>& views);

}  // namespace mirada::vision
