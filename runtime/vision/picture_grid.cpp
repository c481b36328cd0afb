#include "vision/picture_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace mirada::vision {
namespace {

constexpr int kColumns = 80;  // that a picture's width is parted into
constexpr int kMostColumns = 200;
constexpr double kSteepest_rad = 1.48;  // from straight ahead, and from level
constexpr double kMargin_rad = 0.02;
constexpr int kRows = 240;
constexpr double kUnitsADoubling = 46;
constexpr double kDarkLevel = 12;  // below this, differences are mostly noise: the logarithm flattens there

}  // namespace

/// The directions that the picture shows: sideways and down from level, from `ahead`.
struct PictureGrid::Fan {
  Eigen::Vector3d ahead, right, down;
  double sideways_rad = 0;
  double up_rad = 0;  ///< the highest and the lowest that is seen, positive down
  double down_rad = 0;

  Eigen::Vector3d ray(double side_rad, double drop_rad) const {
    return std::cos(drop_rad) * (std::cos(side_rad) * ahead + std::sin(side_rad) * right) +
           std::sin(drop_rad) * down;
  }
};

void PictureGrid::resize(const CameraModel& camera) {
  camera_ = camera;
  pixels_across_ = std::max(1, camera.width_px / kColumns);
  pixels_down_ = std::max(1, camera.height_px / kRows);
  ray_columns_ = camera.width_px / pixels_across_;
  rows_ = camera.height_px / pixels_down_;
  for (int i = 0; i < 4; ++i) tap_offset_[i] = 3 * ((2 * i + 1) * pixels_across_ / 8);
  for (std::size_t sum = 0; sum < log_.size(); ++sum) {
    const double level = static_cast<double>(sum) / 4;
    log_[sum] = static_cast<std::uint8_t>(
        std::lround(kUnitsADoubling * std::log2((level + kDarkLevel) / kDarkLevel)));
  }
  rays_.resize(static_cast<std::size_t>(ray_columns_) * static_cast<std::size_t>(rows_));
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  for (int column = 0; column < ray_columns_; ++column) {
    const double u_px = (column + 0.5) * pixels_across_ - 0.5;
    for (int row = 0; row < rows_; ++row) {
      const auto ray = camera.unproject({u_px, v_px(row)});
      rays_[index(column, row)] =
          ray ? Eigen::Vector3f(ray->cast<float>()) : Eigen::Vector3f(kNan, kNan, kNan);
    }
  }
  constexpr auto kMost = static_cast<std::size_t>(kMostColumns);
  u_px_.reserve(kMost * static_cast<std::size_t>(rows_));
  first_byte_.reserve(kMost * static_cast<std::size_t>(rows_));
  bottom_rows_.reserve(kMost);
  top_rows_.reserve(kMost);
}

PictureGrid::Fan PictureGrid::fan(const Eigen::Vector3d& up_C) const {
  Fan out;
  out.down = -up_C.normalized();
  Eigen::Vector3d ahead(0, 0, 1);
  if (std::abs(out.down.z()) > 0.99) ahead = {0, out.down.z() > 0 ? -1.0 : 1.0, 0};
  out.ahead = (ahead - ahead.dot(out.down) * out.down).normalized();
  out.right = out.down.cross(out.ahead);
  out.up_rad = kSteepest_rad;
  out.down_rad = -kSteepest_rad;
  const auto see = [&](int column, int row) {
    const Eigen::Vector3d ray = rays_[index(column, row)].cast<double>();
    if (!(ray.z() > 0)) return;
    const double ahead_m = ray.dot(out.ahead);
    const double side_m = ray.dot(out.right);
    const double drop_rad = std::atan2(ray.dot(out.down), std::hypot(ahead_m, side_m));
    out.up_rad = std::min(out.up_rad, drop_rad);
    out.down_rad = std::max(out.down_rad, drop_rad);
    out.sideways_rad = std::max(out.sideways_rad, std::abs(std::atan2(side_m, ahead_m)));
  };
  for (int row = 0; row < rows_; row += 4) see(0, row), see(ray_columns_ - 1, row);
  for (int column = 0; column < ray_columns_; ++column) see(column, 0), see(column, rows_ - 1);
  out.sideways_rad = std::min(out.sideways_rad, kSteepest_rad);
  out.up_rad = std::max(out.up_rad - kMargin_rad, -kSteepest_rad);
  out.down_rad = std::min(out.down_rad + kMargin_rad, kSteepest_rad);
  return out;
}

void PictureGrid::stand(const Eigen::Vector3d& up_C) {
  const Fan lines = fan(up_C);
  spacing_rad_ = std::max(pixels_across_ / camera_.fx_px, 2 * lines.sideways_rad / (kMostColumns - 1));
  columns_ = 2 * static_cast<int>(lines.sideways_rad / spacing_rad_) + 1;
  const auto cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  u_px_.assign(cells, std::numeric_limits<float>::quiet_NaN());
  first_byte_.assign(cells, 0);
  bottom_rows_.assign(static_cast<std::size_t>(columns_), -1);
  top_rows_.assign(static_cast<std::size_t>(columns_), 0);
  for (int column = 0; column < columns_; ++column) lay_line(column, lines);
}

void PictureGrid::lay_line(int column, const Fan& lines) {
  constexpr int kSteps = 32;
  const double side_rad = (column - columns_ / 2) * spacing_rad_;
  std::optional<Eigen::Vector2d> before;
  for (int i = 0; i <= kSteps; ++i) {
    const double drop_rad = lines.up_rad + i * (lines.down_rad - lines.up_rad) / kSteps;
    const auto now = camera_.project(lines.ray(side_rad, drop_rad));
    if (before && now && now->y() > before->y()) {
      const double slope = (now->x() - before->x()) / (now->y() - before->y());
      const int from = std::max(0, static_cast<int>(std::ceil((before->y() + 0.5) / pixels_down_ - 0.5)));
      const int to = std::min(rows_ - 1, static_cast<int>(std::floor((now->y() + 0.5) / pixels_down_ - 0.5)));
      for (int row = from; row <= to; ++row)
        u_px_[index(column, row)] = static_cast<float>(before->x() + slope * (v_px(row) - before->y()));
    }
    before = now;
  }
  int last = rows_ - 1;
  const auto shown = [&](int row) {
    const float u = u_px_[index(column, row)];
    return u >= 0 && u <= static_cast<float>(camera_.width_px - 1) && ray_of_pixel(u, row).z() > 0;
  };
  while (last >= 0 && !shown(last)) --last;
  int first = last;
  while (first > 0 && shown(first - 1)) --first;
  close_line(column, first, last);
}

/// Rows that the picture does not show get the nearest that it shows: nothing is read beside the picture.
void PictureGrid::close_line(int column, int first, int last) {
  bottom_rows_[static_cast<std::size_t>(column)] = last;
  top_rows_[static_cast<std::size_t>(column)] = std::max(first, 0);
  if (last < 0) return;
  const int reach = tap_offset_[3] / 3 + 1;
  for (int row = 0; row < rows_; ++row) {
    float& u = u_px_[index(column, row)];
    if (row < first || row > last) u = u_px_[index(column, std::clamp(row, first, last))];
    const auto left = std::lround(u - static_cast<float>(pixels_across_ - 1) / 2);
    first_byte_[index(column, row)] =
        static_cast<std::uint16_t>(3 * std::clamp<long>(left, 0, camera_.width_px - reach));
  }
}

void PictureGrid::look_at(const cv::Mat& bgr) {
  bgr_ = bgr;
  exposure_ = 0;
  pixels_ = bgr_.ptr(pixels_down_ / 2);
  row_bytes_ = static_cast<std::ptrdiff_t>(bgr_.step) * pixels_down_;
  taps_touch_ = pixels_across_ == 4;
}

Eigen::Vector3d PictureGrid::ray_of_pixel(double u_px, double row) const {
  const double across = (u_px + 0.5) / pixels_across_ - 0.5;
  const int left = std::clamp(static_cast<int>(std::floor(across)), 0, ray_columns_ - 2);
  const int above = std::clamp(static_cast<int>(std::floor(row)), 0, rows_ - 2);
  const double right_share = across - left;
  const double below_share = row - above;
  const auto at = [&](int column) -> Eigen::Vector3d {
    return (1 - below_share) * rays_[index(column, above)].cast<double>() +
           below_share * rays_[index(column, above + 1)].cast<double>();
  };
  return (1 - right_share) * at(left) + right_share * at(left + 1);
}

double PictureGrid::u_px(int column, double row) const {
  const int last = std::max(top_row(column), bottom_row(column) - 1);
  const int above = std::clamp(static_cast<int>(std::floor(row)), top_row(column), last);
  const int below = std::min(above + 1, rows_ - 1);
  const double u = static_cast<double>(u_px_[index(column, above)]);
  return u + (row - above) * (static_cast<double>(u_px_[index(column, below)]) - u);
}

Eigen::Vector3d PictureGrid::ray_C(int column, double row) const {
  return ray_of_pixel(u_px(column, row), row);
}

int PictureGrid::column_at(double u, double v) const {
  const double row = (v + 0.5) / pixels_down_ - 0.5;
  if (columns_ < 2 || u < -0.5 || u > camera_.width_px - 0.5) return -1;
  const auto shown = std::clamp(static_cast<int>(std::lround(row)), 0, rows_ - 1);
  const auto middle = [&](int column) { return static_cast<double>(u_px_[index(column, shown)]); };
  int low = 0;
  int high = columns_ - 1;
  while (high - low > 1) {
    const int half = (low + high) / 2;
    // Where a line is not shown its cells lie at the picture's side, so the order holds.
    (middle(half) <= u ? low : high) = half;
  }
  return u - middle(low) <= middle(high) - u ? low : high;
}

Eigen::Vector3d PictureGrid::colour_of(const Look& look) {
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
