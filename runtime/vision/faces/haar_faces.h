#pragma once
#include <vector>

#include <opencv2/core.hpp>
#include <opencv2/objdetect.hpp>

#include "base/result.h"
#include "vision/faces/face_net.h"
#include "vision/faces/textured_areas.h"

namespace mirada::vision {

/// Debian's Haar cascade: the fallback. One thread.
class HaarFaces {
 public:
  /// Where: not in uniform areas, or everywhere (what the skipping saves is measured against that).
  enum class Search { textured, everywhere };
  /// Fault in words when the cascade's file is missing (package opencv-data) or broken.
  static Result<HaarFaces> open(Search search = Search::textured);

  /// Faces, surest first, in the picture's own pixels.
  std::vector<FaceBox> find(const cv::Mat& bgr);

 private:
  HaarFaces(cv::CascadeClassifier cascade, Search search) : cascade_(std::move(cascade)), search_(search) {}

  void search_all(int smallest_px);
  void search_textured(int smallest_px);
  void add(const cv::Rect& area, double scale_step, int neighbours, int from_px, int to_px);
  void look_again(const std::vector<cv::Rect>& all);

  cv::CascadeClassifier cascade_;
  Search search_;
  TexturedAreas areas_;
  cv::Mat gray_;
  std::vector<cv::Rect> boxes_, some_boxes_;
  std::vector<int> levels_, some_levels_;
  std::vector<double> weights_, some_weights_;
};

}  // namespace mirada::vision
