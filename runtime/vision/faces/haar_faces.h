#pragma once
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/objdetect.hpp>

#include "base/result.h"
#include "vision/faces/face_net.h"

namespace mirada::vision {

/// Debian's Haar cascade: the fallback. One thread.
class HaarFaces {
 public:
  /// Fault in words when the cascade's file is missing (package opencv-data) or broken.
  static Result<HaarFaces> open();

  /// Faces, surest first, in the picture's own pixels.
  std::vector<FaceBox> find(const cv::Mat& bgr);
  /// Whether uniform areas are left out (they are): only to measure what that saves.
  void skip_uniform(bool on) { skips_ = on; }

 private:
  explicit HaarFaces(cv::CascadeClassifier cascade) : cascade_(std::move(cascade)) {}

  void search(const cv::Rect& area, double scale, std::vector<FaceBox>& out);

  cv::CascadeClassifier cascade_;
  bool skips_ = true;
  cv::Mat gray_;
  std::vector<cv::Rect> boxes_;
  std::vector<int> levels_;
  std::vector<double> weights_;
};

}  // namespace mirada::vision
