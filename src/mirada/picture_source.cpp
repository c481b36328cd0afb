#include "picture_source.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>

#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgcodecs.hpp>

#include "base/files.h"
#include "see_messages.h"

namespace mirada {
namespace {

constexpr std::uintmax_t kLargestPicture_bytes = 256u << 20;

/// By name: FFmpeg would make a video of nearly anything, of a text file too.
bool is_video_name(const std::string& file) {
  static const std::set<std::string> kVideos{".avi",  ".mp4", ".m4v", ".mov", ".mkv", ".webm",  ".mpg",
                                             ".mpeg", ".ogv", ".3gp", ".wmv", ".gif", ".mjpeg", ".mjpg"};
  std::string ending = std::filesystem::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return kVideos.count(ending) > 0;
}

/// OpenCV throws on pictures that are broken or beyond its limits: for us both are "no picture".
cv::Mat decoded(const std::string& bytes) {
  if (bytes.empty()) return {};
  try {
    const cv::Mat raw(1, static_cast<int>(bytes.size()), CV_8UC1, const_cast<char*>(bytes.data()));
    return cv::imdecode(raw, cv::IMREAD_COLOR);
  } catch (const cv::Exception&) {
    return {};
  }
}

bool fits(const cv::Mat& picture, const CameraModel& camera) {
  const double wanted = static_cast<double>(camera.width_px) / camera.height_px;
  return std::abs(static_cast<double>(picture.cols) / picture.rows / wanted - 1) < 0.01;
}

}  // namespace

Result<PictureSource> PictureSource::open(const std::string& file, const CameraModel& camera) {
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  PictureSource source;
  source.file_ = file;
  std::error_code error;
  if (is_video_name(file) && std::filesystem::is_regular_file(file, error)) {
    setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);
    try {
      source.video_.open(file, cv::CAP_FFMPEG);
      source.video_.read(source.first_);
    } catch (const cv::Exception&) {
      source.first_.release();
    }
  } else {
    const auto bytes = read_file(file, kLargestPicture_bytes);
    if (!bytes) return bytes.faults();
    source.first_ = decoded(*bytes);
  }
  if (source.first_.empty() || source.first_.type() != CV_8UC3) {
    return make_fault(file, messages::see_no_picture, {{"file", file}});
  }
  if (fits(source.first_, camera)) return source;
  return make_fault(file, messages::see_wrong_shape,
                    {{"file", file},
                     {"width", std::to_string(source.first_.cols)},
                     {"height", std::to_string(source.first_.rows)},
                     {"camera_width", std::to_string(camera.width_px)},
                     {"camera_height", std::to_string(camera.height_px)}});
}

cv::Mat PictureSource::next() {
  cv::Mat out = first_;
  first_.release();
  if (out.empty() && video_.isOpened()) video_.read(out);
  return out;
}

}  // namespace mirada
