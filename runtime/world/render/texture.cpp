#include "world/render/texture.h"

#include <opencv2/imgproc.hpp>

namespace mirada::world {
namespace {

Texture::Level padded_level(const cv::Mat& bgra, float full_width, float full_height) {
  Texture::Level out;
  out.stride = bgra.cols + 1;
  out.texels.resize(static_cast<std::size_t>(out.stride) * static_cast<std::size_t>(bgra.rows + 1));
  cv::Mat view(bgra.rows + 1, out.stride, CV_8UC4, out.texels.data());
  cv::copyMakeBorder(bgra, view, 0, 1, 0, 1, cv::BORDER_REPLICATE);
  out.scale_x = 16 * static_cast<float>(bgra.cols) / full_width;
  out.scale_y = 16 * static_cast<float>(bgra.rows) / full_height;
  out.most_x = static_cast<float>(bgra.cols - 1) * 16;
  out.most_y = static_cast<float>(bgra.rows - 1) * 16;
  return out;
}

}  // namespace

Texture::Texture(const cv::Mat& bgr8)
    : width_(static_cast<float>(bgr8.cols)), height_(static_cast<float>(bgr8.rows)) {
  CV_Assert(bgr8.type() == CV_8UC3 && !bgr8.empty());
  cv::Mat bgra;
  cv::cvtColor(bgr8, bgra, cv::COLOR_BGR2BGRA);
  levels_.push_back(padded_level(bgra, width_, height_));
  while (bgra.cols > 2 || bgra.rows > 2) {
    cv::Mat half;
    const cv::Size size((bgra.cols + 1) / 2, (bgra.rows + 1) / 2);
    cv::resize(bgra, half, size, 0, 0, cv::INTER_AREA);
    bgra = half;
    levels_.push_back(padded_level(bgra, width_, height_));
  }
}

}  // namespace mirada::world
