#pragma once
#include <string>
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/dnn/dnn.hpp>

#include "base/result.h"

namespace mirada::vision {

/// A face in a picture's own pixels, top-left origin; score 0..1.
struct FaceBox {
  cv::Rect2d box_px;
  double score = 0;
};

/// A single-shot face network in the shape of UltraFace (outputs: corners and background/face scores), run on
/// one thread. Deterministic.
class FaceNet {
 public:
  /// Where scripts/run puts the network.
  static std::string default_file();
  /// Fault in words: no such file, or no network of this shape.
  static Result<FaceNet> open(const std::string& file);

  /// Faces, surest first. `bgr` is CV_8UC3 of any size and shape; it is looked at in the network's own size.
  std::vector<FaceBox> find(const cv::Mat& bgr);

 private:
  FaceNet(cv::dnn::Net net, cv::Size size) : net_(std::move(net)), size_(size) {}

  cv::dnn::Net net_;
  cv::Size size_;
  cv::Mat fitted_;
  cv::Mat blob_;
};

}  // namespace mirada::vision
