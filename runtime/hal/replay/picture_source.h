#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>

#include <opencv2/core.hpp>

#include "base/result.h"

namespace mirada::hal {

/// Numbered pictures from files. One thread.
class PictureSource {
 public:
  virtual ~PictureSource() = default;
  /// Picture number `index` (from 0) as CV_8UC3; empty where it cannot be decoded.
  virtual cv::Mat read(std::int64_t index) = 0;
  /// How many there are; for a video at most that many.
  virtual std::int64_t count() const = 0;
  /// 0 when the files do not say.
  virtual double own_fps() const = 0;
};

/// A picture file, a folder of pictures or a video.
Result<std::unique_ptr<PictureSource>> open_pictures(const std::filesystem::path& path);

}  // namespace mirada::hal
