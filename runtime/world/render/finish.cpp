#include "world/render/finish.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "base/random.h"

namespace mirada::world {
namespace {

constexpr int kOffsets_x = 67;
constexpr int kOffsets_y = 61;

std::uint64_t mixed(std::uint64_t x) {  // SplitMix64's last step
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31);
}

}  // namespace

Finish::Finish(const RayTable& rays, const NoiseConfig& noise, std::uint64_t seed)
    : width_(rays.width), height_(rays.height), stride_(rays.stride) {
  const double half2 = (width_ * width_ + height_ * height_) / 4.0;
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const double r2 = (std::pow(x - width_ / 2.0, 2) + std::pow(y - height_ / 2.0, 2)) / half2;
      const bool sees = rays.sees[static_cast<std::size_t>(y * stride_ + x)] != 0;
      const double share = sees ? 256 * (1 - noise.vignette * r2 * std::sqrt(r2)) : 0;
      bright_.insert(bright_.end(), 3, static_cast<std::uint16_t>(share));
    }
  }
  Random random(seed, "sensor noise");
  noise_.create(height_ + kOffsets_y, width_ + kOffsets_x, CV_8SC3);
  for (int y = 0; y < noise_.rows; ++y) {
    for (int x = 0; x < noise_.cols; ++x) {
      const double grey = random.gaussian();
      cv::Vec3b& pixel = noise_.at<cv::Vec3b>(y, x);
      for (int c = 0; c < 3; ++c) {
        const double value = noise.sensor * (0.8 * grey + 0.6 * random.gaussian());
        pixel[c] =
            static_cast<std::uint8_t>(static_cast<std::int8_t>(std::clamp(std::round(value), -127.0, 127.0)));
      }
    }
  }
}

cv::Mat Finish::develop(const std::vector<std::uint32_t>& bgra, std::uint64_t chance) const {
  cv::Mat out(height_, width_, CV_8UC3);
  const std::uint64_t offset = mixed(chance + 0x9E3779B97F4A7C15ULL);
  const int left = static_cast<int>(offset % kOffsets_x);
  const int top = static_cast<int>((offset >> 20) % kOffsets_y);
  const cv::Mat painted(height_, width_, CV_8UC4, const_cast<std::uint32_t*>(bgra.data()),
                        static_cast<std::size_t>(stride_) * sizeof(std::uint32_t));
  cv::cvtColor(painted, out, cv::COLOR_BGRA2BGR);
  const int channels = width_ * 3;
  for (int y = 0; y < height_; ++y) {
    const std::uint16_t* bright = bright_.data() + static_cast<std::ptrdiff_t>(y) * channels;
    const std::int8_t* noise = noise_.ptr<std::int8_t>(y + top) + static_cast<std::ptrdiff_t>(3) * left;
    std::uint8_t* value = out.ptr<std::uint8_t>(y);
    for (int i = 0; i < channels; ++i) {
      const auto lit = static_cast<std::uint16_t>(static_cast<std::uint16_t>(value[i]) * bright[i]);
      const auto sum = static_cast<std::int16_t>((lit >> 8) + noise[i]);
      const std::int16_t floored = sum < 0 ? std::int16_t{0} : sum;
      value[i] = static_cast<std::uint8_t>(floored > 255 ? std::int16_t{255} : floored);
    }
  }
  return out;
}

}  // namespace mirada::world
