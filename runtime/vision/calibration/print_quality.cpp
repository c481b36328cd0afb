#include "vision/calibration/print_quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <opencv2/imgproc.hpp>

namespace mirada::vision {
namespace {

constexpr int kProfile = 41;
constexpr int kLargestHalfWindow_px = 20;
constexpr double kFaintestStep = 12;  ///< grey levels

bool seen(const cv::Point2f& p) { return !std::isnan(p.x); }

/// Grey level between pixels; nothing outside the picture.
std::optional<double> grey_at(const cv::Mat& gray, const cv::Point2f& p) {
  const int x = static_cast<int>(std::floor(p.x));
  const int y = static_cast<int>(std::floor(p.y));
  if (x < 0 || y < 0 || x + 1 >= gray.cols || y + 1 >= gray.rows) return std::nullopt;
  const double fx = p.x - static_cast<float>(x);
  const double fy = p.y - static_cast<float>(y);
  const auto* top = gray.ptr(y) + x;
  const auto* bottom = gray.ptr(y + 1) + x;
  return (1 - fy) * ((1 - fx) * top[0] + fx * top[1]) + fy * ((1 - fx) * bottom[0] + fx * bottom[1]);
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Where a profile from dark to bright first reaches a level, in samples.
double crossing(const std::array<double, kProfile>& profile, double level) {
  for (std::size_t i = 1; i < profile.size(); ++i) {
    if (profile[i - 1] < level && profile[i] >= level) {
      return static_cast<double>(i) - (profile[i] - level) / (profile[i] - profile[i - 1]);
    }
  }
  return 0;
}

/// Width of the step across the edge between two neighbouring corners; nothing where there is no step.
std::optional<double> step_width_px(const cv::Mat& gray, const cv::Point2f& a, const cv::Point2f& b) {
  const cv::Point2f along = b - a;
  const cv::Point2f across(-along.y, along.x);
  constexpr float kReach = 0.42F;  // of a square, to each side
  std::array<double, kProfile> profile{};
  for (const float t : {0.3F, 0.4F, 0.5F, 0.6F, 0.7F}) {
    for (int i = 0; i < kProfile; ++i) {
      const float side = kReach * (2 * static_cast<float>(i) / (kProfile - 1) - 1);
      const auto grey = grey_at(gray, a + t * along + side * across);
      if (!grey) return std::nullopt;
      profile[static_cast<std::size_t>(i)] += *grey / 5;
    }
  }
  if (profile.front() > profile.back()) std::reverse(profile.begin(), profile.end());
  const double low = (profile[0] + profile[1] + profile[2]) / 3;
  const double high = (profile[kProfile - 1] + profile[kProfile - 2] + profile[kProfile - 3]) / 3;
  if (high - low < kFaintestStep) return std::nullopt;
  const double samples =
      crossing(profile, low + 0.9 * (high - low)) - crossing(profile, low + 0.1 * (high - low));
  return samples * 2 * kReach / (kProfile - 1) * std::hypot(along.x, along.y);
}

struct Patch {
  double mean = 0;
  double grain = 0;
};

/// The middle of a square: its grey level, and what is left of it when a plane is taken away.
std::optional<Patch> patch_of(const cv::Mat& gray, const std::array<cv::Point2f, 4>& corners) {
  constexpr int kSide = 13;
  double sum = 0, sum_x = 0, sum_y = 0, squares = 0;
  double spread = 0;
  for (int j = 0; j < kSide; ++j) {
    for (int i = 0; i < kSide; ++i) {
      const float x = static_cast<float>(i) / (kSide - 1) - 0.5F;
      const float y = static_cast<float>(j) / (kSide - 1) - 0.5F;
      const float s = 0.5F + 0.5F * x;
      const float t = 0.5F + 0.5F * y;
      const auto grey = grey_at(gray, (1 - t) * ((1 - s) * corners[0] + s * corners[1]) +
                                          t * ((1 - s) * corners[2] + s * corners[3]));
      if (!grey) return std::nullopt;
      sum += *grey;
      sum_x += x * *grey;
      sum_y += y * *grey;
      squares += *grey * *grey;
      spread += static_cast<double>(x) * x;
    }
  }
  constexpr double n = kSide * kSide;
  Patch out;
  out.mean = sum / n;
  const double left = squares - sum * sum / n - (sum_x * sum_x + sum_y * sum_y) / spread;
  out.grain = std::sqrt(std::max(0.0, left / n));
  return out;
}

double roughness(const cv::Mat& sharp, const std::vector<cv::Point2f>& corners, std::size_t columns) {
  // Stripes are wider than a pixel; the sensor's noise, which is no fault of the board, is not.
  cv::Mat gray;
  cv::GaussianBlur(sharp, gray, {}, 1.2);
  std::vector<Patch> patches;
  for (std::size_t i = 0; i + columns + 1 < corners.size(); ++i) {
    if (i % columns + 1 == columns) continue;
    const std::array<cv::Point2f, 4> square = {corners[i], corners[i + 1], corners[i + columns],
                                               corners[i + columns + 1]};
    if (!std::all_of(square.begin(), square.end(), seen)) continue;
    if (const auto patch = patch_of(gray, square)) patches.push_back(*patch);
  }
  if (patches.size() < 4) return 0;
  std::sort(patches.begin(), patches.end(), [](const Patch& a, const Patch& b) { return a.mean < b.mean; });
  const double step = patches[patches.size() * 4 / 5].mean - patches[patches.size() / 5].mean;
  std::vector<double> grains;
  for (std::size_t i = 0; i < (patches.size() + 1) / 2; ++i) grains.push_back(patches[i].grain);
  return step > 1 ? median(grains) / step : 0;
}

}  // namespace

PrintQuality print_quality(const cv::Mat& gray, const std::vector<cv::Point2f>& corners_px, int columns) {
  const auto wide = static_cast<std::size_t>(columns);
  std::vector<double> along_rows;
  std::vector<double> along_columns;
  const auto measure = [&](std::size_t i, std::size_t j, std::vector<double>& out) {
    if (!seen(corners_px[i]) || !seen(corners_px[j])) return;
    if (const auto width = step_width_px(gray, corners_px[i], corners_px[j])) out.push_back(*width);
  };
  for (std::size_t i = 0; i < corners_px.size(); ++i) {
    if (i % wide + 1 < wide) measure(i, i + 1, along_rows);
    if (i + wide < corners_px.size()) measure(i, i + wide, along_columns);
  }
  return {std::max(median(along_rows), median(along_columns)), roughness(gray, corners_px, wide)};
}

int refining_half_window_px(const std::vector<cv::Point2f>& corners_px, int columns, int picture_width_px,
                            double share) {
  const auto wide = static_cast<std::size_t>(columns);
  double smallest = 1e9;
  const auto compare = [&](std::size_t i, std::size_t j) {
    if (!seen(corners_px[i]) || !seen(corners_px[j])) return;
    smallest = std::min(smallest, static_cast<double>(std::hypot(corners_px[i].x - corners_px[j].x,
                                                                 corners_px[i].y - corners_px[j].y)));
  };
  for (std::size_t i = 0; i < corners_px.size(); ++i) {
    if (i % wide + 1 < wide) compare(i, i + 1);
    if (i + wide < corners_px.size()) compare(i, i + wide);
  }
  return std::clamp(static_cast<int>(std::lround(share * smallest)), 2,
                    std::max(kLargestHalfWindow_px, picture_width_px / 160));
}

}  // namespace mirada::vision
