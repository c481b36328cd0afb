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
  /// The squares that are asked.
  struct Sizes {
    double step = 0;  ///< the factor from one size to the next
    int from_px = 0, to_px = 0;
  };

  HaarFaces(cv::CascadeClassifier cascade, Search search) : cascade_(std::move(cascade)), search_(search) {}

  void search_all(int smallest_px);
  void search_textured(int smallest_px);
  void search_area(const cv::Rect& area, const Sizes& sizes, int neighbours, bool apart);
  void look_again(const std::vector<cv::Rect>& all, int smallest_px);

  cv::CascadeClassifier cascade_;
  Search search_;
  TexturedAreas areas_;
  cv::Mat gray_;
  std::vector<cv::Rect> boxes_, some_boxes_;
  std::vector<int> levels_, some_levels_;
  std::vector<double> weights_, some_weights_;
};

}  // namespace mirada::vision
