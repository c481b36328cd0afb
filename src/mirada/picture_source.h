#pragma once
#include <string>

#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>

#include "base/result.h"
#include "model/camera_model.h"

namespace mirada {

/// A picture file, or a video file frame by frame.
class PictureSource {
 public:
  /// Opens the file and reads its first picture. Faults: no such file, no picture, a shape that is not the
  /// camera's.
  static Result<PictureSource> open(const std::string& file, const CameraModel& camera);

  bool is_video() const { return video_.isOpened(); }
  const std::string& file() const { return file_; }
  /// The next picture, BGR; empty at the end.
  cv::Mat next();

 private:
  std::string file_;
  cv::Mat first_;
  cv::VideoCapture video_;
};

}  // namespace mirada
