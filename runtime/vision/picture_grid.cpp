#include "vision/picture_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mirada::vision {
namespace {

constexpr int kColumns = 80;
constexpr int kRows = 240;
constexpr double kUnitsADoubling = 46;
constexpr double kDarkLevel = 12;  // below this, differences are mostly noise: the logarithm flattens there

}  // namespace

void PictureGrid::resize(const CameraModel& camera) {
  pixels_across_ = std::max(1, camera.width_px / kColumns);
  pixels_down_ = std::max(1, camera.height_px / kRows);
  columns_ = camera.width_px / pixels_across_;
  rows_ = camera.height_px / pixels_down_;
  for (int i = 0; i < 4; ++i) tap_offset_[i] = 3 * ((2 * i + 1) * pixels_across_ / 8);
  for (std::size_t sum = 0; sum < log_.size(); ++sum) {
    const double level = static_cast<double>(sum) / 4;
    log_[sum] = static_cast<std::uint8_t>(
        std::lround(kUnitsADoubling * std::log2((level + kDarkLevel) / kDarkLevel)));
  }
  rays_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  for (int column = 0; column < columns_; ++column) {
    for (int row = 0; row < rows_; ++row) {
      const auto ray = camera.unproject({u_px(column), v_px(row)});
      rays_[index(column, row)] =
          ray ? Eigen::Vector3f(ray->cast<float>()) : Eigen::Vector3f(kNan, kNan, kNan);
    }
  }
}

void PictureGrid::look_at(const cv::Mat& bgr) {
  bgr_ = bgr;
  pixels_ = bgr_.ptr(pixels_down_ / 2);
  row_bytes_ = static_cast<std::ptrdiff_t>(bgr_.step) * pixels_down_;
  cell_bytes_ = 3 * static_cast<std::ptrdiff_t>(pixels_across_);
  taps_touch_ = pixels_across_ == 4;
}

Eigen::Vector3d PictureGrid::ray_C(int column, double row) const {
  const int below = std::clamp(static_cast<int>(std::floor(row)), 0, rows_ - 2);
  const double share = row - below;
  return (1 - share) * rays_[index(column, below)].cast<double>() +
         share * rays_[index(column, below + 1)].cast<double>();
}

Eigen::Vector3d PictureGrid::colour_of(const Look& look) const {
  const double red = look.red - 128;
  const double blue = look.blue - 128;
  const double green = look.light - (red + blue) / 4;
  const auto level = [](double units) { return kDarkLevel * (std::exp2(units / kUnitsADoubling) - 1); };
  return {level(green + blue), level(green), level(green + red)};
}

std::uint64_t PictureGrid::fingerprint() const {
  std::uint64_t hash = 1469598103934665603ull;
  for (int row = 1; row < rows_; row += 8) {
    const std::uint8_t* bytes = bgr_.ptr(row * pixels_down_);
    const std::size_t size = static_cast<std::size_t>(bgr_.cols) * 3;
    for (std::size_t i = 0; i + 8 <= size; i += 24) {
      std::uint64_t word = 0;
      std::memcpy(&word, bytes + i, 8);
      hash = (hash ^ word) * 1099511628211ull;
    }
  }
  return hash;
}

}  // namespace mirada::vision
