#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "world/render/paint.h"

namespace mirada::world::paint {
namespace {

// The face is painted on a canvas of this size; positions below are in its pixels.
constexpr int kWidth = 256;
constexpr int kHeight = 320;
constexpr int kMiddle = kWidth / 2;

/// Lightens or darkens an elliptic patch with soft edges.
void soft_patch(cv::Mat& out, cv::Point middle, cv::Size axes, double share, double blur_px) {
  cv::Mat mask = cv::Mat::zeros(out.size(), CV_32F);
  cv::ellipse(mask, middle, axes, 0, 0, 360, cv::Scalar(1), cv::FILLED, cv::LINE_AA);
  cv::GaussianBlur(mask, mask, {0, 0}, blur_px);
  modulate(out, mask, share - 1);
}

void both_sides(int dx, const auto& draw) {
  draw(kMiddle - dx, -1);
  draw(kMiddle + dx, 1);
}

void eye(cv::Mat& out, int x, const PersonConfig& person) {
  const cv::Point at(x, 150);
  soft_patch(out, {x, 146}, {34, 20}, 0.62, 9);
  cv::ellipse(out, at, {19, 9}, 0, 0, 360, bgr({238, 234, 228}), cv::FILLED, cv::LINE_AA);
  cv::circle(out, at, 9, bgr({70, 50, 34}), cv::FILLED, cv::LINE_AA);
  cv::circle(out, at, 5, bgr({14, 12, 12}), cv::FILLED, cv::LINE_AA);
  cv::circle(out, at + cv::Point(3, -3), 2, bgr({250, 250, 250}), cv::FILLED, cv::LINE_AA);
  cv::ellipse(out, at, {20, 11}, 0, 185, 355, bgr({46, 30, 24}), 4, cv::LINE_AA);
  cv::ellipse(out, at, {20, 10}, 0, 15, 165, bgr(shade(person.skin, 0.62)), 2, cv::LINE_AA);
}

void brow(cv::Mat& out, int x, int side, const PersonConfig& person) {
  const Colour dark = shade(person.hair, 0.8);
  cv::ellipse(out, {x + side * 2, 134}, {29, 14}, side * 4.0, 205, 335, bgr(dark), 8, cv::LINE_AA);
}

void nose(cv::Mat& out, const PersonConfig& person) {
  soft_patch(out, {kMiddle, 165}, {8, 38}, 1.16, 5);
  both_sides(16, [&](int x, int) { soft_patch(out, {x, 172}, {6, 28}, 0.85, 5); });
  soft_patch(out, {kMiddle, 208}, {24, 7}, 0.72, 4);
  both_sides(10, [&](int x, int) {
    cv::ellipse(out, {x, 205}, {6, 3}, 0, 0, 360, bgr(shade(person.skin, 0.42)), cv::FILLED, cv::LINE_AA);
  });
}

void mouth(cv::Mat& out, const PersonConfig& person) {
  const Colour lip = mix(person.skin, {170, 62, 62}, 0.7);
  soft_patch(out, {kMiddle, 258}, {34, 6}, 0.78, 5);
  cv::ellipse(out, {kMiddle, 236}, {36, 13}, 0, 0, 180, bgr(lip), cv::FILLED, cv::LINE_AA);
  cv::ellipse(out, {kMiddle, 238}, {36, 7}, 0, 180, 360, bgr(shade(lip, 0.85)), cv::FILLED, cv::LINE_AA);
  cv::ellipse(out, {kMiddle, 233}, {38, 8}, 0, 8, 172, bgr({84, 30, 30}), 3, cv::LINE_AA);
}

void hair_strands(cv::Mat& out, const cv::Mat& mask, const PersonConfig& person, Random& random) {
  cv::Mat hair = plain(out.size(), person.hair);
  modulate(hair, grain_noise(out.size(), 50, 0.08, 3, random), 0.35);
  hair.copyTo(out, mask);
}

cv::Mat fringe(cv::Size size) {
  cv::Mat mask(size, CV_8U, cv::Scalar(255));
  // The face is cut out of the hair: an oval with a parting.
  cv::ellipse(mask, {kMiddle, 190}, {96, 112}, 0, 0, 360, cv::Scalar(0), cv::FILLED, cv::LINE_AA);
  cv::ellipse(mask, {kMiddle, 196}, {100, 140}, 0, 0, 180, cv::Scalar(0), cv::FILLED, cv::LINE_AA);
  return mask;
}

}  // namespace

cv::Mat face(const PersonConfig& person, Random& random) {
  cv::Mat out = plain({kWidth, kHeight}, person.skin);
  soft_patch(out, {kMiddle, 110}, {62, 26}, 1.09, 18);
  both_sides(54, [&](int x, int) { soft_patch(out, {x, 200}, {26, 22}, 1.08, 12); });
  both_sides(118, [&](int x, int) { soft_patch(out, {x, 190}, {34, 110}, 0.72, 18); });
  soft_patch(out, {kMiddle, 318}, {80, 22}, 0.68, 14);
  both_sides(44, [&](int x, int side) {
    eye(out, x, person);
    brow(out, x, side, person);
  });
  nose(out, person);
  mouth(out, person);
  hair_strands(out, fringe(out.size()), person, random);
  cv::GaussianBlur(out, out, {0, 0}, 1.0);
  return out;
}

void poster(cv::Mat& out, double px_per_m, Random& random) {
  constexpr double kWidth_m = 0.19;
  constexpr double kHeight_m = 0.24;
  constexpr double kBorder_m = 0.02;
  const cv::Rect all({}, out.size());
  const int w = cvRound(kWidth_m * px_per_m);
  const int h = cvRound(kHeight_m * px_per_m);
  const int border = cvRound(kBorder_m * px_per_m);
  const cv::Rect print((out.cols - w) / 2, 2 * border, w, h);
  const cv::Rect paper(print.x - border, print.y - border, w + 2 * border, h + 2 * border);
  if ((paper & all) != paper) return;
  PersonConfig printed;
  printed.skin = mix({224, 180, 150}, {150, 100, 70}, random.uniform());
  printed.hair = mix({70, 48, 32}, {25, 20, 18}, random.uniform());
  out(paper).setTo(bgr({244, 244, 240}));
  cv::resize(face(printed, random), out(print), print.size(), 0, 0, cv::INTER_AREA);
}

cv::Mat head_back(const PersonConfig& person, Random& random) {
  cv::Mat out = plain({kWidth, kHeight}, person.skin);
  cv::Mat mask(out.size(), CV_8U, cv::Scalar(255));
  mask.rowRange(280, kHeight).setTo(0);
  hair_strands(out, mask, person, random);
  return out;
}

cv::Mat clothes(const PersonConfig& person, double low, double high, Random& random) {
  cv::Mat out = plain({256, 128}, person.shirt);
  if (low <= 0) {
    const Colour trousers = mix(shade(person.shirt, 0.45), {48, 52, 70}, 0.5);
    const int waist = cvRound(out.rows * 0.25 / std::max(high, 0.25));
    out.rowRange(std::min(waist, out.rows - 8), out.rows).setTo(bgr(trousers));
    out.rowRange(out.rows - 12, out.rows).setTo(bgr({58, 46, 42}));
    cv::line(out, {128, waist}, {128, out.rows - 12}, bgr(shade(trousers, 0.6)), 3, cv::LINE_AA);
  }
  modulate(out, grain_noise(out.size(), 30, 0.3, 4, random), 0.10);
  return out;
}

}  // namespace mirada::world::paint
