#include "world/render/texture.h"

#include <opencv2/imgproc.hpp>

namespace mirada::world {
namespace {

/// A level's memory, one row and column larger than the picture; `inside` is where the picture goes.
Texture::Level empty_level(cv::Size size, float full_width, float full_height, cv::Mat& inside) {
  Texture::Level out;
  out.memory.create(size.height + 1, size.width + 1, CV_8UC4);
  inside = out.memory(cv::Rect({}, size));
  out.texels = out.memory.ptr<std::uint32_t>();
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
  cv::Mat picture;
  levels_.push_back(empty_level(bgr8.size(), width_, height_, picture));
  cv::cvtColor(bgr8, picture, cv::COLOR_BGR2BGRA);
  double_edges(levels_.back().memory);
  while (picture.cols > 2 || picture.rows > 2) {
    cv::Mat half;
    levels_.push_back(empty_level({(picture.cols + 1) / 2, (picture.rows + 1) / 2}, width_, height_, half));
    cv::resize(picture, half, half.size(), 0, 0, cv::INTER_AREA);
    double_edges(levels_.back().memory);
    picture = half;
  }
  for (std::size_t i = 0; i < halved_.size() && i < levels_.size(); ++i) halved_[i] = levels_[i].texels;
}

}  // namespace mirada::world
