#pragma once
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <vector>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "model/camera_model.h"

namespace mirada::vision {

/// A place's look: brightness and two colour ratios, all logarithmic (about 46 units a doubling), so that
/// light and shade move only the brightness. red and blue are against green and 128 means equal.
struct Look {
  int light = 0;
  int red = 128;
  int blue = 128;
};

/// Clearly not grey; or so many times as clearly.
inline bool has_colour(const Look& look, int times = 1) {
  constexpr int kGrey = 128;
  constexpr int kColourful = 12;
  return std::abs(look.red - kGrey) + std::abs(look.blue - kGrey) >= times * kColourful;
}

/// A picture seen as a fan of lines that stand upright in the room, each one bearing from the lens, and about
/// 240 rows, whatever the picture's size: what stands on a line hides just what lies farther along it. Each
/// cell is the mean of four pixels side by side. Looks are worked out when asked for; nothing is allocated
/// after the first picture of a size.
class PictureGrid {
 public:
  /// Prepares for pictures of this camera's size.
  void resize(const CameraModel& camera);
  /// Where up is, seen from the camera: lays the lines. After resize(), and when the camera tilts.
  void stand(const Eigen::Vector3d& up_C);
  /// The picture to look at; it must live until the next call, be CV_8UC3 and of the prepared size.
  void look_at(const cv::Mat& bgr);
  /// From here on looks are told as if the picture were exposed darker by so many units of light: as pictures
  /// were that it is compared with. look_at() sets it back to 0.
  void expose(int light) { exposure_ = light; }
  int exposure() const { return exposure_; }

  /// Lines, from left to right.
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  /// The bearing between neighbouring lines.
  double spacing_rad() const { return spacing_rad_; }
  /// Middle of a cell in source pixels; rows may be fractional.
  double u_px(int column, double row) const;
  double v_px(double row) const { return (row + 0.5) * pixels_down_ - 0.5; }
  double pixels_down() const { return pixels_down_; }
  /// The line nearest to a source pixel; -1 when that lies beside the picture.
  int column_at(double u_px, double v_px) const;

  /// The ray (camera frame) of a cell, rows interpolated.
  Eigen::Vector3d ray_C(int column, double row) const;
  /// The picture shows the line from its `bottom_row` (-1: nowhere) up to its `top_row`.
  int bottom_row(int column) const { return bottom_rows_[static_cast<std::size_t>(column)]; }
  int top_row(int column) const { return top_rows_[static_cast<std::size_t>(column)]; }
  bool sees(int column, int row) const { return row <= bottom_row(column) && row >= top_row(column); }

  Look look(int column, int row) const;
  /// Mean B, G, R of the cell, 0..255.
  std::array<int, 3> colour(int column, int row) const;
  /// B, G, R of one source pixel of a grid row.
  const std::uint8_t* pixel(int u_px, int row) const { return pixels_ + row_bytes_ * row + 3 * u_px; }
  int width_px() const { return bgr_.cols; }
  /// The B, G, R that colour() says where look() says this, 0..255.
  Eigen::Vector3d colour_shown(const Look& look) const {
    return colour_of({look.light + exposure_, look.red, look.blue});
  }
  /// The B, G, R that a look stands for, 0..255.
  static Eigen::Vector3d colour_of(const Look& look);
  /// Changes when any sampled pixel does: to notice a camera that repeats itself.
  std::uint64_t fingerprint() const;

 private:
  struct Sums {
    unsigned blue, green, red;  ///< of four pixels
  };
  struct Fan;
  Sums sums(int column, int row) const;
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(column) * static_cast<std::size_t>(rows_) + static_cast<std::size_t>(row);
  }
  Eigen::Vector3d ray_of_pixel(double u_px, double row) const;
  Fan fan(const Eigen::Vector3d& up_C) const;
  void lay_line(int column, const Fan& fan);
  void close_line(int column, int first, int last);

  CameraModel camera_;
  cv::Mat bgr_;
  int columns_ = 0;
  int rows_ = 0;
  int ray_columns_ = 0;
  double spacing_rad_ = 0.015;
  int pixels_across_ = 4;
  int pixels_down_ = 1;
  int exposure_ = 0;
  const std::uint8_t* pixels_ = nullptr;   ///< of bgr_, the first row that is sampled
  std::ptrdiff_t row_bytes_ = 0;           ///< from one grid row to the next
  bool taps_touch_ = true;                 ///< four neighbouring pixels
  int tap_offset_[4] = {0, 3, 6, 9};       ///< bytes from a cell's first pixel to its four samples
  std::vector<Eigen::Vector3f> rays_;      ///< of upright strips of the picture, side by side
  std::vector<float> u_px_;                ///< of every cell
  std::vector<std::uint16_t> first_byte_;  ///< of every cell, in its row
  std::vector<int> bottom_rows_, top_rows_;
  std::array<std::uint8_t, 1021> log_{};  ///< of a sum of four
};

inline PictureGrid::Sums PictureGrid::sums(int column, int row) const {
  const std::uint8_t* at = pixels_ + row_bytes_ * row + first_byte_[index(column, row)];
  if (taps_touch_) {
    return {0u + at[0] + at[3] + at[6] + at[9], 0u + at[1] + at[4] + at[7] + at[10],
            0u + at[2] + at[5] + at[8] + at[11]};
  }
  Sums sums{0, 0, 0};
  for (const int offset : tap_offset_) {
    sums.blue += at[offset];
    sums.green += at[offset + 1];
    sums.red += at[offset + 2];
  }
  return sums;
}

inline Look PictureGrid::look(int column, int row) const {
  const Sums s = sums(column, row);
  const int b = log_[s.blue];
  const int g = log_[s.green];
  const int r = log_[s.red];
  return {((r + 2 * g + b) >> 2) - exposure_, r - g + 128, b - g + 128};
}

inline std::array<int, 3> PictureGrid::colour(int column, int row) const {
  const Sums s = sums(column, row);
  return {static_cast<int>(s.blue >> 2), static_cast<int>(s.green >> 2), static_cast<int>(s.red >> 2)};
}

}  // namespace mirada::vision
