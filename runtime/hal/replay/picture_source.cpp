#include "hal/replay/picture_source.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "base/messages.h"
#include "hal/messages.h"

namespace mirada::hal {
namespace {

namespace fs = std::filesystem;

cv::Mat decoded(const fs::path& file) {
  try {
    return cv::imread(file.string(), cv::IMREAD_COLOR);
  } catch (const cv::Exception&) {  // a picture larger than OpenCV's limits
    return {};
  }
}

bool named_like_a_picture(const fs::path& file) {
  constexpr std::array kEndings = {".png", ".jpg", ".jpeg", ".bmp", ".ppm", ".pgm", ".tif", ".tiff", ".webp"};
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

class PictureFiles final : public PictureSource {
 public:
  explicit PictureFiles(std::vector<fs::path> files) : files_(std::move(files)) {}

  cv::Mat read(std::int64_t index) override {
    if (index != newest_) {
      picture_ = decoded(files_[static_cast<std::size_t>(index)]);
      newest_ = index;
    }
    return picture_;
  }
  std::int64_t count() const override { return static_cast<std::int64_t>(files_.size()); }
  double own_fps() const override { return 0; }

 private:
  std::vector<fs::path> files_;
  std::int64_t newest_ = -1;
  cv::Mat picture_;  ///< of `newest_`: one still shown again and again is decoded once
};

class VideoFile final : public PictureSource {
 public:
  VideoFile(std::string file, cv::VideoCapture capture)
      : file_(std::move(file)), capture_(std::move(capture)) {
    count_ = static_cast<std::int64_t>(capture_.get(cv::CAP_PROP_FRAME_COUNT));
    fps_ = capture_.get(cv::CAP_PROP_FPS);
  }

  cv::Mat read(std::int64_t index) override {
    if (index < next_) rewind();
    while (next_ < index && capture_.grab()) ++next_;
    cv::Mat out;
    if (next_ == index && capture_.read(out)) ++next_;
    return out.channels() == 3 ? out.clone() : cv::Mat();
  }
  std::int64_t count() const override { return std::max<std::int64_t>(count_, 1); }
  double own_fps() const override { return fps_ > 0.1 && fps_ < 1000 ? fps_ : 0; }

 private:
  void rewind() {
    capture_.open(file_);
    next_ = 0;
  }

  std::string file_;
  cv::VideoCapture capture_;
  std::int64_t next_ = 0;
  std::int64_t count_ = 0;
  double fps_ = 0;
};

Result<std::unique_ptr<PictureSource>> open_folder(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (named_like_a_picture(entry.path())) files.push_back(entry.path());
  }
  if (error) {
    return make_fault(folder.string(), mirada::messages::file_unreadable, {{"file", folder.string()}});
  }
  if (files.empty())
    return make_fault(folder.string(), messages::pictures_missing, {{"file", folder.string()}});
  std::sort(files.begin(), files.end());
  Faults faults;
  const bool any = std::any_of(files.begin(), files.end(), [&](const fs::path& file) {
    if (!decoded(file).empty()) return true;
    faults.push_back(make_fault(file.string(), messages::picture_broken, {{"file", file.string()}}));
    return false;
  });
  if (!any) return faults;
  return std::unique_ptr<PictureSource>(std::make_unique<PictureFiles>(std::move(files)));
}

}  // namespace

Result<std::unique_ptr<PictureSource>> open_pictures(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) {
    return make_fault(path.string(), mirada::messages::file_missing, {{"file", path.string()}});
  }
  if (fs::is_directory(status)) return open_folder(path);
  if (!decoded(path).empty()) {
    return std::unique_ptr<PictureSource>(std::make_unique<PictureFiles>(std::vector<fs::path>{path}));
  }
  try {
    cv::VideoCapture capture(path.string());
    if (capture.isOpened() && capture.grab()) {
      capture.open(path.string());
      return std::unique_ptr<PictureSource>(std::make_unique<VideoFile>(path.string(), std::move(capture)));
    }
  } catch (const cv::Exception&) {  // told below, like any other file that is no video
  }
  return make_fault(path.string(), messages::picture_broken, {{"file", path.string()}});
}

}  // namespace mirada::hal
