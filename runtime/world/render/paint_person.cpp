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

/// What makes a face somebody's, in the canvas' pixels. The first face is the plain one.
struct Features {
  int eye_dx = 44, eye_y = 150;
  double eye_size = 1;
  double eye_open = 1;
  double eye_slant = 0;
  Colour iris{70, 50, 34};
  int brow_y = 134, brow_thick = 8;
  double brow_tilt = 4;
  int nose_low = 208, nose_half = 16;
  int mouth_y = 236, mouth_half = 36, lip = 13;
  int chin_half = 100;
  double cheeks = 1.08, cheeks_low = 1;
  int fringe_y = 190, fringe_half = 96;
  bool glasses = false, beard = false, moustache = false;
};

/// Faces 1 to 11 are chosen so that a face network takes none of them for another; the first seven are
/// found from below, too.
std::uint64_t chosen_seed(int face) {
  constexpr std::uint64_t kChosen[] = {3928, 1111, 2579, 3848, 3186, 2009, 2396, 2623, 3123, 1233, 3359};
  constexpr auto kCount = static_cast<int>(std::size(kChosen));
  const auto number = static_cast<std::uint64_t>(face);
  return face <= kCount ? kChosen[face - 1] : number + 10'000;
}

Features features_of(const PersonConfig& person) {
  Features out;
  if (person.face == 0) return out;
  Random chance(chosen_seed(person.face), "face");
  const auto whole = [&](int low, int high) { return static_cast<int>(chance.integer(low, high)); };
  out.eye_dx = whole(36, 54);
  out.eye_y = whole(138, 160);
  out.eye_size = chance.uniform(0.75, 1.3);
  out.eye_open = chance.uniform(0.6, 1.35);
  out.eye_slant = chance.uniform(-14, 14);
  const Colour irises[] = {{70, 50, 34}, {92, 128, 160}, {96, 122, 84}, {40, 30, 26}};
  out.iris = irises[whole(0, 3)];
  out.brow_y = out.eye_y - whole(13, 24);
  out.brow_thick = whole(4, 13);
  out.brow_tilt = chance.uniform(-9, 12);
  out.nose_low = whole(196, 220);
  out.nose_half = whole(9, 27);
  out.mouth_y = out.nose_low + whole(24, 38);
  out.mouth_half = whole(24, 52);
  out.lip = whole(5, 20);
  out.chin_half = whole(78, 114);
  out.cheeks = chance.uniform(0.8, 1.2);
  out.cheeks_low = chance.uniform(0.75, 1.1);
  out.fringe_y = whole(178, 204);
  out.fringe_half = whole(86, 108);
  out.glasses = chance.uniform() < 0.3;
  out.beard = chance.uniform() < 0.25;
  out.moustache = chance.uniform() < 0.25;
  return out;
}

void both_sides(int dx, const auto& draw) {
  draw(kMiddle - dx, -1);
  draw(kMiddle + dx, 1);
}

void eye(cv::Mat& out, int x, int side, const PersonConfig& person, const Features& own) {
  const cv::Point at(x, own.eye_y);
  const auto sized = [&](int px) { return cvRound(px * own.eye_size); };
  soft_patch(out, {x, own.eye_y - 4}, {sized(34), sized(20)}, 0.62, 9);
  const auto tall = [&](int px) { return cvRound(px * own.eye_size * own.eye_open); };
  const double slant = side * own.eye_slant;
  cv::ellipse(out, at, {sized(19), tall(9)}, slant, 0, 360, bgr({238, 234, 228}), cv::FILLED, cv::LINE_AA);
  cv::circle(out, at, std::min(sized(9), tall(9)), bgr(own.iris), cv::FILLED, cv::LINE_AA);
  cv::circle(out, at, sized(5), bgr({14, 12, 12}), cv::FILLED, cv::LINE_AA);
  cv::circle(out, at + cv::Point(3, -3), 2, bgr({250, 250, 250}), cv::FILLED, cv::LINE_AA);
  cv::ellipse(out, at, {sized(20), tall(11)}, slant, 185, 355, bgr({46, 30, 24}), 4, cv::LINE_AA);
  cv::ellipse(out, at, {sized(20), tall(10)}, slant, 15, 165, bgr(shade(person.skin, 0.62)), 2, cv::LINE_AA);
}

void brow(cv::Mat& out, int x, int side, const PersonConfig& person, const Features& own) {
  const Colour dark = shade(person.hair, 0.8);
  cv::ellipse(out, {x + side * 2, own.brow_y}, {29, 14}, side * own.brow_tilt, 205, 335, bgr(dark),
              own.brow_thick, cv::LINE_AA);
}

void nose(cv::Mat& out, const PersonConfig& person, const Features& own) {
  const int low = own.nose_low;
  soft_patch(out, {kMiddle, low - 43}, {8, 38}, 1.16, 5);
  both_sides(own.nose_half, [&](int x, int) { soft_patch(out, {x, low - 36}, {6, 28}, 0.85, 5); });
  soft_patch(out, {kMiddle, low}, {own.nose_half + 8, 7}, 0.72, 4);
  both_sides(own.nose_half - 6, [&](int x, int) {
    cv::ellipse(out, {x, low - 3}, {6, 3}, 0, 0, 360, bgr(shade(person.skin, 0.42)), cv::FILLED, cv::LINE_AA);
  });
}

void mouth(cv::Mat& out, const PersonConfig& person, const Features& own) {
  const Colour lip = mix(person.skin, {170, 62, 62}, 0.7);
  const int y = own.mouth_y;
  const int half = own.mouth_half;
  soft_patch(out, {kMiddle, y + 22}, {half - 2, 6}, 0.78, 5);
  cv::ellipse(out, {kMiddle, y}, {half, own.lip}, 0, 0, 180, bgr(lip), cv::FILLED, cv::LINE_AA);
  cv::ellipse(out, {kMiddle, y + 2}, {half, 7}, 0, 180, 360, bgr(shade(lip, 0.85)), cv::FILLED, cv::LINE_AA);
  cv::ellipse(out, {kMiddle, y - 3}, {half + 2, 8}, 0, 8, 172, bgr({84, 30, 30}), 3, cv::LINE_AA);
}

void beard_and_glasses(cv::Mat& out, const PersonConfig& person, const Features& own) {
  const double dark = 0.42;
  if (own.beard) {
    soft_patch(out, {kMiddle, own.mouth_y + 52}, {62, 26}, dark, 7);
    both_sides(78, [&](int x, int) { soft_patch(out, {x, own.mouth_y + 18}, {18, 44}, dark, 7); });
  }
  if (own.moustache)
    cv::ellipse(out, {kMiddle, own.mouth_y - 10}, {own.mouth_half, 7}, 0, 180, 360,
                bgr(shade(person.hair, 0.9)), cv::FILLED, cv::LINE_AA);
  if (!own.glasses) return;
  both_sides(own.eye_dx, [&](int x, int) {
    cv::ellipse(out, {x, own.eye_y}, {33, 24}, 0, 0, 360, bgr({36, 34, 38}), 5, cv::LINE_AA);
  });
  cv::line(out, {kMiddle - own.eye_dx + 32, own.eye_y}, {kMiddle + own.eye_dx - 32, own.eye_y},
           bgr({36, 34, 38}), 5, cv::LINE_AA);
}

void hair_strands(cv::Mat& out, const cv::Mat& mask, const PersonConfig& person, Random& random) {
  cv::Mat hair = plain(out.size(), person.hair);
  modulate(hair, grain_noise(out.size(), 50, 0.08, 3, random), 0.35);
  hair.copyTo(out, mask);
}

cv::Mat fringe(cv::Size size, const Features& own) {
  cv::Mat mask(size, CV_8U, cv::Scalar(255));
  // The face is cut out of the hair: an oval with a parting.
  cv::ellipse(mask, {kMiddle, own.fringe_y}, {own.fringe_half, 112}, 0, 0, 360, cv::Scalar(0), cv::FILLED,
              cv::LINE_AA);
  cv::ellipse(mask, {kMiddle, 196}, {own.chin_half, 140}, 0, 0, 180, cv::Scalar(0), cv::FILLED, cv::LINE_AA);
  return mask;
}

}  // namespace

cv::Mat face(const PersonConfig& person, Random& random) {
  const Features own = features_of(person);
  cv::Mat out = plain({kWidth, kHeight}, person.skin);
  soft_patch(out, {kMiddle, 110}, {62, 26}, 1.09, 18);
  both_sides(54, [&](int x, int) { soft_patch(out, {x, 200}, {26, 22}, own.cheeks, 12); });
  both_sides(62, [&](int x, int) { soft_patch(out, {x, 240}, {24, 34}, own.cheeks_low, 12); });
  both_sides(118, [&](int x, int) { soft_patch(out, {x, 190}, {34, 110}, 0.72, 18); });
  soft_patch(out, {kMiddle, 318}, {80, 22}, 0.68, 14);
  both_sides(own.eye_dx, [&](int x, int side) {
    eye(out, x, side, person, own);
    brow(out, x, side, person, own);
  });
  nose(out, person, own);
  mouth(out, person, own);
  beard_and_glasses(out, person, own);
  hair_strands(out, fringe(out.size(), own), person, random);
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
  printed.face = static_cast<int>(random.integer(4, 7));
  wear_own_colours(printed);
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

namespace mirada::world {

void wear_own_colours(PersonConfig& person) {
  if (person.face == 0) return;
  Random chance(paint::chosen_seed(person.face), "skin and hair");
  const Colour skins[] = {{224, 180, 150}, {198, 150, 118}, {150, 104, 76}, {110, 76, 56}};
  const Colour hairs[] = {{70, 48, 32}, {28, 22, 20}, {170, 130, 70}, {120, 60, 30}, {150, 150, 150}};
  person.skin = skins[chance.integer(0, 3)];
  person.hair = hairs[chance.integer(0, 4)];
}

}  // namespace mirada::world
