#pragma once
#include <vector>

#include <opencv2/core.hpp>

namespace mirada::vision {

/// Where in a grey picture a face may be. Vega and Cañas (2019, section 5.4) skip uniform regions; one rule
/// for all regions keeps nearly everything, for every edge lies in one. Here each square in which a face
/// would just fit is asked by itself: in a face nearly every part varies, at an edge or a pattern of edges
/// few do. What counts is how much a part varies beside how bright the square is, so that dim light changes
/// nothing.
class TexturedAreas {
 public:
  /// Reads the picture once; keeps nothing of it but its sums.
  void look(const cv::Mat& gray);
  /// Areas of the picture, in pixels, which together hold each square of this side that may be a face. They
  /// may overlap. Empty when there is none.
  const std::vector<cv::Rect>& of_side(int side_px);

 private:
  bool may_be_face(int x, int y, int side_px) const;
  void cover(cv::Rect cells, int step_px, int side_px);
  cv::Rect trimmed(cv::Rect cells) const;

  cv::Size size_;
  cv::Mat sums_, squares_;  // integrals of the picture
  cv::Mat cells_, counts_;  // squares of one side, by where they begin; and the integral of that
  std::vector<cv::Rect> areas_;
};

}  // namespace mirada::vision
