#include "world/render/texture.h"

#include <opencv2/imgproc.hpp>

namespace mirada::world {
namespace {

/// The sizes of all levels, down to 2 x 2 or less.
std::vector<cv::Size> halvings_of(cv::Size size) {
  std::vector<cv::Size> out{size};
  while (size.width > 2 || size.height > 2) {
    size = {(size.width + 1) / 2, (size.height + 1) / 2};
    out.push_back(size);
  }
  return out;
}

/// One row and column larger than the picture.
int texels_of(cv::Size size) { return (size.width + 1) * (size.height + 1); }

Texture::Level level_at(const std::uint32_t* texels, cv::Size size, float full_width, float full_height) {
  Texture::Level out;
  out.texels = texels;
  out.stride = size.width + 1;
  out.scale_x = 16 * static_cast<float>(size.width) / full_width;
  out.scale_y = 16 * static_cast<float>(size.height) / full_height;
  out.most_x = static_cast<float>(size.width - 1) * 16;
  out.most_y = static_cast<float>(size.height - 1) * 16;
  return out;
}

/// The last row and column stand twice, so that filtering may read one texel too far.
void double_edges(cv::Mat& memory) {
  const int last_x = memory.cols - 1;
  for (int y = 0; y < memory.rows - 1; ++y) {
    auto* row = memory.ptr<std::uint32_t>(y);
    row[last_x] = row[last_x - 1];
  }
  memory.row(memory.rows - 2).copyTo(memory.row(memory.rows - 1));
}

}  // namespace

Texture::Texture(const cv::Mat& bgr8)
    : width_(static_cast<float>(bgr8.cols)), height_(static_cast<float>(bgr8.rows)) {
  CV_Assert(bgr8.type() == CV_8UC3 && !bgr8.empty());
  const std::vector<cv::Size> sizes = halvings_of(bgr8.size());
  int texels = 0;
  for (const cv::Size& size : sizes) texels += texels_of(size);
  memory_.create(1, texels, CV_8UC4);
  auto* at = memory_.ptr<std::uint32_t>();
  cv::Mat larger;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    cv::Mat whole(sizes[i].height + 1, sizes[i].width + 1, CV_8UC4, at);
    cv::Mat picture = whole(cv::Rect({}, sizes[i]));
    if (i == 0) {
      cv::cvtColor(bgr8, picture, cv::COLOR_BGR2BGRA);
    } else {
      cv::resize(larger, picture, sizes[i], 0, 0, cv::INTER_AREA);
    }
    double_edges(whole);
    levels_.push_back(level_at(at, sizes[i], width_, height_));
    if (i < halvings_.size()) halvings_[i] = static_cast<std::int32_t>(at - memory_.ptr<std::uint32_t>());
    at += texels_of(sizes[i]);
    larger = picture;
  }
}

}  // namespace mirada::world
