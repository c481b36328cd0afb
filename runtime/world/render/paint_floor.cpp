#include <algorithm>
#include <cmath>
#include <numbers>

#include <opencv2/imgproc.hpp>

#include "world/render/paint.h"
#include "world/shapes.h"

namespace mirada::world::paint {
namespace {

struct Pattern {
  cv::Mat& out;
  const FloorConfig& floor;
  double px_per_m;
  Random& random;

  double px(double metres) const { return metres * floor.scale * px_per_m; }
  void noise(double cell_m, int octaves, double amount) const {
    modulate(out, soft_noise(out.size(), std::max(px(cell_m), 1.0), octaves, random),
             amount * floor.contrast);
  }
  Colour own_shade(double spread) const {
    return shade(floor.colour, 1 + random.uniform(-spread, spread) * floor.contrast);
  }
};

void carpet(const Pattern& p) {
  p.noise(0.35, 3, 0.06);
  p.noise(0.012, 3, 0.20);
}

void wood(const Pattern& p) {
  const double plank = std::max(p.px(0.095), 3.0);
  const double length = std::max(p.px(0.9), 8.0);
  const Colour seam = shade(p.floor.colour, 1 - 0.45 * std::min(p.floor.contrast, 2.0));
  int row = 0;
  for (double y = 0; y < p.out.rows; y += plank, ++row) {
    for (double x = -p.random.uniform(0, length); x < p.out.cols; x += length) {
      const cv::Rect board(cvRound(x), cvRound(y), cvRound(length), cvRound(plank));
      cv::rectangle(p.out, board, bgr(p.own_shade(0.11)), cv::FILLED);
      cv::line(p.out, {cvRound(x), cvRound(y)}, {cvRound(x), cvRound(y + plank)}, bgr(seam), 1);
    }
  }
  modulate(p.out, grain_noise(p.out.size(), std::max(p.px(0.022), 2.0), 14, 4, p.random),
           0.13 * p.floor.contrast);
  for (double y = 0; y < p.out.rows; y += plank) {
    cv::line(p.out, {0, cvRound(y)}, {p.out.cols, cvRound(y)}, bgr(seam), 1);
  }
}

void tiles(const Pattern& p) {
  const double side = std::max(p.px(0.30), 6.0);
  const int grout = std::max(1, cvRound(p.px(0.005)));
  const Colour joint = shade(p.floor.colour, 1 - 0.28 * std::min(p.floor.contrast, 2.5));
  for (double y = 0; y < p.out.rows; y += side) {
    for (double x = 0; x < p.out.cols; x += side) {
      cv::rectangle(p.out, cv::Rect(cvRound(x), cvRound(y), cvRound(side), cvRound(side)),
                    bgr(p.own_shade(0.05)), cv::FILLED);
    }
  }
  p.noise(0.12, 4, 0.06);
  for (double y = 0; y < p.out.rows; y += side) {
    cv::line(p.out, {0, cvRound(y)}, {p.out.cols, cvRound(y)}, bgr(joint), grout);
  }
  for (double x = 0; x < p.out.cols; x += side) {
    cv::line(p.out, {cvRound(x), 0}, {cvRound(x), p.out.rows}, bgr(joint), grout);
  }
  p.noise(0.006, 1, 0.03);
}

void concrete(const Pattern& p) {
  p.noise(0.6, 5, 0.12);
  p.noise(0.02, 3, 0.08);
  const int stains = static_cast<int>(p.out.total() / (p.px_per_m * p.px_per_m));
  for (int i = 0; i < stains * 12; ++i) {
    const cv::Point at(static_cast<int>(p.random.integer(0, p.out.cols - 1)),
                       static_cast<int>(p.random.integer(0, p.out.rows - 1)));
    cv::circle(p.out, at, std::max(1, cvRound(p.px(p.random.uniform(0.001, 0.004)))), bgr(p.own_shade(0.25)),
               cv::FILLED, cv::LINE_AA);
  }
}

void grass(const Pattern& p) {
  const double stripe = std::max(p.px(0.8), 4.0);
  for (double x = 0; x < p.out.cols; x += 2 * stripe) {
    cv::rectangle(p.out, cv::Rect(cvRound(x), 0, cvRound(stripe), p.out.rows),
                  bgr(shade(p.floor.colour, 1 + 0.07 * p.floor.contrast)), cv::FILLED);
  }
  p.noise(0.25, 3, 0.07);
  modulate(p.out, grain_noise(p.out.size(), std::max(p.px(0.02), 2.0), 0.4, 3, p.random),
           0.18 * p.floor.contrast);
}

std::vector<cv::Point> fixed_point(const std::vector<cv::Point2d>& points, int shift) {
  std::vector<cv::Point> out;
  const double one = 1 << shift;
  for (const cv::Point2d& p : points)
    out.emplace_back(cvRound((p.x - 0.5) * one), cvRound((p.y - 0.5) * one));
  return out;
}

void fill(cv::Mat& mask, const std::vector<cv::Point2d>& convex) {
  constexpr int kShift = 6;
  cv::fillConvexPoly(mask, fixed_point(convex, kShift), cv::Scalar(255), cv::LINE_AA, kShift);
}

/// Puts a colour on where the mask is; `wear` thins it here and there.
void blend(cv::Mat& out, const cv::Mat& mask, const cv::Rect& region, Colour colour, const cv::Mat& wear) {
  const float c[3] = {float(colour.b), float(colour.g), float(colour.r)};
  for (int y = region.y; y < region.br().y; ++y) {
    const std::uint8_t* m = mask.ptr<std::uint8_t>(y);
    const float* w = wear.ptr<float>(y % wear.rows);
    std::uint8_t* pixel = out.ptr<std::uint8_t>(y) + static_cast<std::ptrdiff_t>(3) * region.x;
    for (int x = region.x; x < region.br().x; ++x, pixel += 3) {
      if (m[x] == 0) continue;
      const float share =
          static_cast<float>(m[x]) / 255 * std::clamp(0.93F + 0.10F * w[x % wear.cols], 0.0F, 1.0F);
      for (int k = 0; k < 3; ++k) {
        const auto under = static_cast<float>(pixel[k]);
        pixel[k] = static_cast<std::uint8_t>(under + (c[k] - under) * share + 0.5F);
      }
    }
  }
}

/// Where a line may have put paint.
cv::Rect region_of(const LineConfig& line, const FloorFrame& frame, cv::Size size) {
  std::vector<cv::Point2f> points;
  for (const Eigen::Vector2d& p : line.points_m) points.emplace_back(frame.at(p));
  const cv::Rect bounds = cv::boundingRect(points);
  const int margin = cvCeil(line.width_m * frame.px_per_m) + 2;
  const cv::Rect grown(bounds.x - margin, bounds.y - margin, bounds.width + 2 * margin,
                       bounds.height + 2 * margin);
  return grown & cv::Rect({}, size);
}

void line_mask(cv::Mat& mask, const FloorFrame& frame, const LineConfig& line) {
  for (std::size_t i = 0; i + 1 < line.points_m.size(); ++i) {
    const Eigen::Vector2d a = line.points_m[i];
    const Eigen::Vector2d b = line.points_m[i + 1];
    if ((b - a).norm() <= 0) continue;
    const Eigen::Vector2d along = (b - a).normalized() * line.width_m / 2;
    const Eigen::Vector2d left(-along.y(), along.x());
    // Square ends close the corners of a polyline.
    fill(mask, {frame.at(a - along - left), frame.at(b + along - left), frame.at(b + along + left),
                frame.at(a - along + left)});
  }
}

std::vector<cv::Point2d> shadow_of(const Shape& shape, const Eigen::Vector2d& offset_m,
                                   const FloorFrame& frame) {
  std::vector<cv::Point2f> points;
  constexpr int kSides = 24;
  for (const Eigen::Vector2d& core : shape.core_m) {
    for (int i = 0; i < (shape.radius_m > 0 ? kSides : 1); ++i) {
      const double angle = 2 * std::numbers::pi * i / kSides;
      const Eigen::Vector2d rim = core + shape.radius_m * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      points.emplace_back(frame.at(rim));
      points.emplace_back(frame.at(rim + offset_m));
    }
  }
  std::vector<cv::Point2f> hull;
  cv::convexHull(points, hull);
  return {hull.begin(), hull.end()};
}

}  // namespace

cv::Mat floor_pattern(const FloorConfig& floor, cv::Size size, double px_per_m, Random& random) {
  const auto rounded = [](int px) { return (px + 63) / 64 * 64; };
  cv::Mat out = plain({rounded(size.width), rounded(size.height)}, floor.colour);
  const Pattern p{out, floor, px_per_m, random};
  switch (floor.kind) {
    case FloorKind::plain:
      p.noise(0.4, 3, 0.03);
      break;
    case FloorKind::carpet:
      carpet(p);
      break;
    case FloorKind::wood:
      wood(p);
      break;
    case FloorKind::tiles:
      tiles(p);
      break;
    case FloorKind::concrete:
      concrete(p);
      break;
    case FloorKind::grass:
      grass(p);
      break;
  }
  return out;
}

void paint_lines(cv::Mat& floor, const FloorFrame& frame, const std::vector<LineConfig>& lines,
                 Random& random) {
  if (lines.empty()) return;
  const cv::Mat wear = soft_noise({512, 512}, 0.05 * frame.px_per_m, 3, random);
  cv::Mat mask = cv::Mat::zeros(floor.size(), CV_8U);
  for (const LineConfig& line : lines) {
    const cv::Rect region = region_of(line, frame, floor.size());
    if (region.empty()) continue;
    line_mask(mask, frame, line);
    blend(floor, mask, region, line.colour, wear);
    mask(region).setTo(0);
  }
}

void cast_shadows(cv::Mat& floor, const FloorFrame& frame, const WorldConfig& world) {
  const LightConfig& light = world.light;
  if (light.shadow <= 0) return;
  cv::Mat mask = cv::Mat::zeros(floor.size(), CV_8U);
  const Eigen::Vector2d away = -Eigen::Vector2d(std::cos(light.from_rad), std::sin(light.from_rad));
  const double per_height = 1 / std::tan(light.elevation_rad);
  const auto cast = [&](const Shape& shape, double height_m) {
    fill(mask, shadow_of(shape, away * (height_m * per_height), frame));
  };
  for (const BoxConfig& box : world.boxes) cast(shape_of(box), box.height_m);
  for (const CylinderConfig& cylinder : world.cylinders) cast(shape_of(cylinder), cylinder.height_m);
  for (const PersonConfig& person : world.people) {
    if (person.path_m.empty()) cast(shape_of(person), person.height_m * 0.9);
  }
  cv::GaussianBlur(mask, mask, {0, 0}, std::max(0.004 * frame.px_per_m, 0.6));
  for (int y = 0; y < floor.rows; ++y) {
    const std::uint8_t* m = mask.ptr<std::uint8_t>(y);
    std::uint8_t* pixel = floor.ptr<std::uint8_t>(y);
    for (int x = 0; x < floor.cols; ++x, pixel += 3) {
      if (m[x] == 0) continue;
      const double share = 1 - light.shadow * m[x] / 255.0;
      for (int k = 0; k < 3; ++k) pixel[k] = static_cast<std::uint8_t>(pixel[k] * share + 0.5);
    }
  }
}

void light_gradient(cv::Mat& floor, const LightConfig& light) {
  if (light.gradient <= 0) return;
  const double gx = std::cos(light.from_rad) * light.gradient / floor.cols;
  const double gy = -std::sin(light.from_rad) * light.gradient / floor.rows;
  std::vector<float> share(static_cast<std::size_t>(floor.cols));
  for (int y = 0; y < floor.rows; ++y) {
    const double row = 1 + gy * (y - floor.rows / 2.0) - gx * floor.cols / 2.0;
    for (std::size_t x = 0; x < share.size(); ++x)
      share[x] = static_cast<float>(row + gx * static_cast<double>(x));
    scale_row(floor, y, share);
  }
}

}  // namespace mirada::world::paint
