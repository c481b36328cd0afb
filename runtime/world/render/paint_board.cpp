#include "world/render/paint_board.h"

#include <algorithm>
#include <cmath>

namespace mirada::world {
namespace {

constexpr int kTaps = 4;         ///< each way
constexpr float kPaper = 0.86F;  ///< white paper in a room's light
constexpr float kNearest_m = 0.01F;

/// From a ray (x, y, 1) to the print's pixels: three dot products.
class Plane {
 public:
  explicit Plane(const HeldBoard& board) {
    const Eigen::Matrix3d R_BC = board.X_CB.linear().transpose();
    const Eigen::Vector3d p_BC = R_BC * -board.X_CB.translation();
    right_ = R_BC.row(0).cast<float>();
    down_ = R_BC.row(1).cast<float>();
    into_ = R_BC.row(2).cast<float>();
    from_ = p_BC.cast<float>();
    scale_ = static_cast<float>(board.px_per_m);
    u0_ = static_cast<float>(board.origin_px.x);
    v0_ = static_cast<float>(board.origin_px.y);
  }

  /// False when the ray does not meet the front of the print's plane.
  bool meets(float x, float y, float& u, float& v) const {
    const float toward = into_.x() * x + into_.y() * y + into_.z();
    const float t = -from_.z() / toward;
    if (!(toward > 0) || !(t > kNearest_m)) return false;
    u = u0_ + scale_ * (from_.x() + t * (right_.x() * x + right_.y() * y + right_.z()));
    v = v0_ + scale_ * (from_.y() + t * (down_.x() * x + down_.y() * y + down_.z()));
    return true;
  }

 private:
  Eigen::Vector3f right_, down_, into_, from_;
  float scale_, u0_, v0_;
};

/// Between the print's pixels; negative outside it.
float grey_at(const cv::Mat& gray, float u, float v) {
  if (u < 0 || v < 0 || u >= static_cast<float>(gray.cols) || v >= static_cast<float>(gray.rows)) return -1;
  const float x = std::clamp(u - 0.5F, 0.0F, static_cast<float>(gray.cols - 1));
  const float y = std::clamp(v - 0.5F, 0.0F, static_cast<float>(gray.rows - 1));
  const int left = std::min(static_cast<int>(x), gray.cols - 2);
  const int top = std::min(static_cast<int>(y), gray.rows - 2);
  const float fx = x - static_cast<float>(left);
  const float fy = y - static_cast<float>(top);
  const auto* a = gray.ptr(top) + left;
  const auto* b = gray.ptr(top + 1) + left;
  const auto g = [](unsigned char value) { return static_cast<float>(value); };
  return (1 - fy) * ((1 - fx) * g(a[0]) + fx * g(a[1])) + fy * ((1 - fx) * g(b[0]) + fx * g(b[1]));
}

std::uint32_t blended(std::uint32_t behind, float grey_sum, int hits, int taps) {
  std::uint32_t out = behind & 0xFF000000U;
  for (int shift = 0; shift < 24; shift += 8) {
    const auto old = static_cast<float>(behind >> shift & 255U);
    const float mean = (grey_sum * kPaper + old * static_cast<float>(taps - hits)) / static_cast<float>(taps);
    out |= static_cast<std::uint32_t>(std::clamp(mean + 0.5F, 0.0F, 255.0F)) << shift;
  }
  return out;
}

class Painter {
 public:
  Painter(const RayTable& rays, const HeldBoard& board) : rays_(rays), gray_(board.gray), plane_(board) {}

  /// Whether the pixel's middle comes within a pixel or two of the print.
  bool near(std::size_t i, float margin) const {
    float u = 0;
    float v = 0;
    return rays_.sees[i] != 0 && plane_.meets(rays_.x[i], rays_.y[i], u, v) && u > -margin && v > -margin &&
           u < static_cast<float>(gray_.cols) + margin && v < static_cast<float>(gray_.rows) + margin;
  }

  void pixel(int x, int y, std::uint32_t& out) const {
    const std::size_t i = at(x, y);
    const std::size_t right = at(std::min(x + 1, rays_.stride - 1), y);
    const std::size_t down = at(x, std::min(y + 1, rays_.tiles_y * RayTable::kTile_px - 1));
    float sum = 0;
    int hits = 0;
    for (int k = 0; k < kTaps * kTaps; ++k) {
      const float sx = (static_cast<float>(k % kTaps) + 0.5F) / kTaps - 0.5F;
      const float sy = (static_cast<float>(k / kTaps) + 0.5F) / kTaps - 0.5F;
      float u = 0;
      float v = 0;
      if (!plane_.meets(mixed(rays_.x, i, right, down, sx, sy), mixed(rays_.y, i, right, down, sx, sy), u, v))
        continue;
      const float grey = grey_at(gray_, u, v);
      if (grey < 0) continue;
      sum += grey;
      ++hits;
    }
    if (hits > 0) out = blended(out, sum, hits, kTaps * kTaps);
  }

 private:
  std::size_t at(int x, int y) const { return static_cast<std::size_t>(y * rays_.stride + x); }
  static float mixed(const std::vector<float>& of, std::size_t i, std::size_t right, std::size_t down,
                     float sx, float sy) {
    return of[i] + sx * (of[right] - of[i]) + sy * (of[down] - of[i]);
  }

  const RayTable& rays_;
  const cv::Mat& gray_;
  Plane plane_;
};

}  // namespace

void paint_board(const RayTable& rays, const HeldBoard& board, std::vector<std::uint32_t>& bgra) {
  if (board.gray.cols < 2 || board.gray.rows < 2) return;
  const Painter painter(rays, board);
  // A pixel is so many of the print's pixels wide, where the print is.
  const auto distance = static_cast<float>(std::max(0.05, board.X_CB.translation().norm()));
  const float margin = 3 * distance * static_cast<float>(board.px_per_m) / rays.fx_px;
  for (int y = 0; y < rays.height; ++y) {
    for (int x = 0; x < rays.width; ++x) {
      const auto i = static_cast<std::size_t>(y * rays.stride + x);
      if (painter.near(i, margin)) painter.pixel(x, y, bgra[i]);
    }
  }
}

}  // namespace mirada::world
