#pragma once
#include <array>
#include <memory>
#include <vector>

#include <opencv2/core.hpp>

namespace mirada::vision {

/// Which printed marks to look for. The ArUco kinds are the marks of ChArUco boards (OpenCV's DICT_4X4_250
/// and its sisters; the first 50 and 100 of each are OpenCV's smaller dictionaries).
enum class TagFamily { april_36h11, aruco_4x4, aruco_5x5, aruco_6x6 };

/// One mark seen in a picture. Corners of its black square in pixels (pixel centres at integers): top left,
/// top right, bottom right, bottom left as it is printed.
struct TagSighting {
  int id = 0;
  std::array<cv::Point2d, 4> corners_px;
  int bits_corrected = 0;
  double margin = 0;  ///< how clearly black and white were told apart, in grey levels
};

/// Finds square marks with libapriltag. One thread calls find(); `threads` of its own work for it.
class TagFinder {
 public:
  explicit TagFinder(TagFamily family = TagFamily::april_36h11, int threads = 1);
  ~TagFinder();
  TagFinder(TagFinder&&) noexcept;
  TagFinder& operator=(TagFinder&&) noexcept;

  /// `gray` is CV_8UC1. Sorted by id; a mark seen twice is given twice. Pictures under 16 pixels show none.
  std::vector<TagSighting> find(const cv::Mat& gray);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// How many marks a family has.
int family_size(TagFamily family);

}  // namespace mirada::vision
