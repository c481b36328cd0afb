#include "world/render/paint.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace mirada::world::paint {
namespace {

constexpr int kPatch_px = 1024;

cv::Mat random_grid(int cols, int rows, Random& random) {
  cv::Mat out(rows, cols, CV_32F);
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < cols; ++x) {
      const std::uint32_t bits = random.next();
      out.at<float>(y, x) = static_cast<float>(bits >> 8) * (2.0F / 16777216.0F) - 1;
    }
  }
  return out;
}

void add_layer(cv::Mat& sum, double cell_x, double cell_y, double weight, Random& random) {
  const int cols = std::max(2, static_cast<int>(std::ceil(sum.cols / cell_x)) + 1);
  const int rows = std::max(2, static_cast<int>(std::ceil(sum.rows / cell_y)) + 1);
  cv::Mat layer;
  cv::resize(random_grid(std::min(cols, sum.cols), std::min(rows, sum.rows), random), layer, sum.size(), 0, 0,
             cell_x < 4 ? cv::INTER_LINEAR : cv::INTER_CUBIC);
  cv::scaleAdd(layer, weight, sum, sum);
}

}  // namespace

cv::Mat grain_noise(cv::Size size, double cell_px, double stretch, int octaves, Random& random) {
  // What has no detail finer than a few pixels is made small and enlarged.
  const double finest = cell_px * std::min(stretch, 1.0) / (1 << (octaves - 1));
  const int shrink = std::clamp(static_cast<int>(finest / 2), 1, 32);
  if (shrink > 1) {
    const cv::Size small((size.width + shrink - 1) / shrink, (size.height + shrink - 1) / shrink);
    cv::Mat out;
    cv::resize(grain_noise(small, cell_px / shrink, stretch, octaves, random), out, size, 0, 0,
               cv::INTER_LINEAR);
    return out;
  }
  const cv::Size patch(std::min(size.width, kPatch_px), std::min(size.height, kPatch_px));
  cv::Mat sum = cv::Mat::zeros(patch, CV_32F);
  double weight = 1, total = 0;
  for (int i = 0; i < octaves && cell_px >= 1; ++i) {
    add_layer(sum, std::max(cell_px * stretch, 1.0), cell_px, weight, random);
    total += weight;
    weight /= 2;
    cell_px /= 2;
  }
  if (total > 0) sum *= 1.6 / total;
  return sum;
}

cv::Mat soft_noise(cv::Size size, double cell_px, int octaves, Random& random) {
  return grain_noise(size, cell_px, 1, octaves, random);
}

cv::Scalar bgr(Colour colour) { return {double(colour.b), double(colour.g), double(colour.r)}; }

cv::Mat plain(cv::Size size, Colour colour) {
  // Sizes that halve well make halving fast.
  const auto rounded = [](int px) { return std::max(16, (px + 15) / 16 * 16); };
  return {rounded(size.height), rounded(size.width), CV_8UC3, bgr(colour)};
}

Colour shade(Colour colour, double share) {
  const auto channel = [&](std::uint8_t value) {
    return static_cast<std::uint8_t>(std::clamp(value * share, 0.0, 255.0));
  };
  return {channel(colour.r), channel(colour.g), channel(colour.b)};
}

Colour mix(Colour a, Colour b, double share) {
  const auto channel = [&](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(std::clamp(from + (to - from) * share, 0.0, 255.0));
  };
  return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b)};
}

void scale_row(cv::Mat& bgr8, int y, const std::vector<float>& share) {
  std::vector<float> of_channel(share.size() * 3);
  for (std::size_t x = 0; x < share.size(); ++x)
    std::fill_n(of_channel.begin() + static_cast<std::ptrdiff_t>(3 * x), 3, share[x]);
  std::uint8_t* value = bgr8.ptr<std::uint8_t>(y);
  for (std::size_t i = 0; i < of_channel.size(); ++i) {
    const float lit = static_cast<float>(value[i]) * of_channel[i] + 0.5F;
    const float floored = lit < 0 ? 0 : lit;
    value[i] = static_cast<std::uint8_t>(static_cast<int>(floored > 255 ? 255 : floored));
  }
}

void modulate(cv::Mat& bgr8, const cv::Mat& noise, double amount) {
  CV_Assert(noise.type() == CV_32F);
  const auto mirrored = [](int at, int size) {
    const int turn = at % (2 * size);
    return turn < size ? turn : 2 * size - 1 - turn;
  };
  const auto strength = static_cast<float>(amount);
  std::vector<int> column(static_cast<std::size_t>(bgr8.cols));
  for (int x = 0; x < bgr8.cols; ++x) column[static_cast<std::size_t>(x)] = mirrored(x, noise.cols);
  std::vector<float> share(column.size());
  for (int y = 0; y < bgr8.rows; ++y) {
    const float* n = noise.ptr<float>(mirrored(y, noise.rows));
    for (std::size_t x = 0; x < share.size(); ++x) share[x] = 1 + strength * n[column[x]];
    scale_row(bgr8, y, share);
  }
}

void light(cv::Mat& bgr8, double share, const cv::Vec3f& tint_bgr) {
  cv::multiply(bgr8, cv::Scalar(share * tint_bgr[0], share * tint_bgr[1], share * tint_bgr[2]), bgr8);
}

}  // namespace mirada::world::paint
