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

 private:
  explicit HaarFaces(cv::CascadeClassifier cascade) : cascade_(std::move(cascade)) {}

  cv::CascadeClassifier cascade_;
  cv::Mat gray_;
  std::vector<cv::Rect> boxes_;
  std::vector<int> levels_;
  std::vector<double> weights_;
};

}  // namespace mirada::vision
