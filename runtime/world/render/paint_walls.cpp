#include <algorithm>

#include <opencv2/imgproc.hpp>

#include "world/render/paint.h"

namespace mirada::world::paint {
namespace {

cv::Rect span(double x0, double y0, double x1, double y1) {
  return {cvRound(x0), cvRound(y0), std::max(1, cvRound(x1) - cvRound(x0)),
          std::max(1, cvRound(y1) - cvRound(y0))};
}

void stripes(cv::Mat& out, Colour colour, double px_per_m) {
  const double pitch = std::max(0.09 * px_per_m, 4.0);
  for (double x = 0; x < out.cols; x += pitch) {
    cv::rectangle(out, span(x, 0, x + pitch * 0.45, out.rows), bgr(shade(colour, 0.94)), cv::FILLED);
    cv::line(out, {cvRound(x + pitch * 0.72), 0}, {cvRound(x + pitch * 0.72), out.rows},
             bgr(shade(colour, 1.05)), 1);
  }
}

void bricks(cv::Mat& out, Colour colour, double px_per_m, Random& random) {
  const double high = std::max(0.07 * px_per_m, 4.0);
  const double wide = std::max(0.23 * px_per_m, 8.0);
  out.setTo(bgr(mix(colour, {205, 200, 192}, 0.65)));
  int row = 0;
  for (double y = out.rows; y > -high; y -= high, ++row) {
    for (double x = (row % 2) * -wide / 2; x < out.cols; x += wide) {
      const Colour brick = shade(colour, random.uniform(0.86, 1.12));
      cv::rectangle(out, span(x + 1, y - high + 1, x + wide - 1, y - 1), bgr(brick), cv::FILLED);
    }
  }
}

void board(cv::Mat& out, Colour colour, double px_per_m, Random& random) {
  const double panel = 1.2 * px_per_m;
  for (double x = 0; x < out.cols; x += panel) {
    const Colour own = shade(colour, random.uniform(0.96, 1.04));
    cv::rectangle(out, span(x, 0, x + panel, out.rows), bgr(own), cv::FILLED);
    cv::line(out, {cvRound(x), 0}, {cvRound(x), out.rows}, bgr(shade(colour, 0.6)), 2);
    cv::rectangle(out, span(x + panel * 0.15, out.rows * 0.3, x + panel * 0.85, out.rows * 0.42),
                  bgr(shade(colour, 0.82)), cv::FILLED);
  }
  cv::rectangle(out, span(0, 0, out.cols, 0.025 * px_per_m), bgr(shade(colour, 0.7)), cv::FILLED);
}

void picture(cv::Mat& out, const cv::Rect& frame, Random& random) {
  const cv::Rect inside(frame.x + 6, frame.y + 6, frame.width - 12, frame.height - 12);
  if (inside.width < 4 || inside.height < 4 || (frame & cv::Rect({}, out.size())) != frame) return;
  cv::rectangle(out, frame, bgr({92, 66, 44}), cv::FILLED);
  cv::Mat view = out(inside);
  const Colour sky{static_cast<std::uint8_t>(random.integer(120, 200)), 190, 225};
  view.setTo(bgr(sky));
  const Colour hill{static_cast<std::uint8_t>(random.integer(50, 160)), 140, 80};
  cv::ellipse(view, {view.cols / 3, view.rows}, {view.cols / 2, view.rows / 2}, 0, 180, 360, bgr(hill),
              cv::FILLED, cv::LINE_AA);
  cv::ellipse(view, {view.cols * 4 / 5, view.rows}, {view.cols / 2, view.rows / 3}, 0, 180, 360,
              bgr(shade(hill, 0.8)), cv::FILLED, cv::LINE_AA);
  cv::circle(view, {view.cols * 3 / 4, view.rows / 4}, view.rows / 9, bgr({250, 220, 120}), cv::FILLED,
             cv::LINE_AA);
}

void skirting_board(cv::Mat& out, const WallConfig& wall, double px_per_m) {
  const double top = out.rows - wall.skirting_m * px_per_m;
  cv::rectangle(out, span(0, top, out.cols, out.rows), bgr(wall.skirting), cv::FILLED);
  cv::line(out, {0, cvRound(top) - 1}, {out.cols, cvRound(top) - 1}, bgr(shade(wall.colour, 0.72)), 1);
  const int groove = cvRound(top + wall.skirting_m * px_per_m * 0.25);
  cv::line(out, {0, groove}, {out.cols, groove}, bgr(shade(wall.skirting, 0.86)), 1);
  cv::line(out, {0, out.rows - 1}, {out.cols, out.rows - 1}, bgr(shade(wall.skirting, 0.7)), 1);
}

void grain(cv::Mat& out, double cell_px, double amount, Random& random) {
  modulate(out, grain_noise(out.size(), cell_px, 10, 4, random), amount);
}

void edge(cv::Mat& out, Colour colour) {
  cv::rectangle(out, cv::Rect(0, 0, out.cols, out.rows), bgr(shade(colour, 0.78)), 1);
}

void drawers(cv::Mat& out, Colour colour) {
  const int count = std::max(1, std::min(4, out.rows / 60));
  const double high = out.rows / double(count);
  for (int i = 0; i < count; ++i) {
    const cv::Rect front = span(6, i * high + 5, out.cols - 6, (i + 1) * high - 5);
    cv::rectangle(out, front, bgr(shade(colour, 1.1)), cv::FILLED);
    cv::rectangle(out, front, bgr(shade(colour, 0.6)), 1);
    const cv::Point knob(out.cols / 2, cvRound((i + 0.5) * high));
    cv::circle(out, knob, 5, bgr({70, 70, 72}), cv::FILLED, cv::LINE_AA);
    cv::circle(out, knob - cv::Point(1, 1), 2, bgr({190, 190, 195}), cv::FILLED, cv::LINE_AA);
  }
}

void books(cv::Mat& out, Colour frame, double px_per_m, Random& random) {
  constexpr Colour kSpines[] = {{164, 62, 52},  {52, 92, 148},  {66, 122, 84},
                                {206, 166, 84}, {122, 78, 132}, {222, 214, 196}};
  out.setTo(bgr(shade(frame, 0.4)));
  const int shelves = std::max(1, cvRound(out.rows / (0.3 * px_per_m)));
  const double high = out.rows / double(shelves);
  for (int s = 0; s < shelves; ++s) {
    const double bottom = (s + 1) * high - 6;
    for (double x = 8; x < out.cols - 8;) {
      const double wide = random.uniform(0.018, 0.05) * px_per_m;
      const Colour colour = shade(kSpines[random.integer(0, 5)], random.uniform(0.8, 1.1));
      const double top = bottom - high * random.uniform(0.62, 0.86);
      cv::rectangle(out, span(x, top, std::min(x + wide, out.cols - 8.0), bottom), bgr(colour), cv::FILLED);
      cv::line(out, {cvRound(x), cvRound(top)}, {cvRound(x), cvRound(bottom)}, bgr(shade(colour, 0.6)), 1);
      x += wide;
    }
    cv::rectangle(out, span(0, bottom, out.cols, (s + 1) * high), bgr(frame), cv::FILLED);
  }
  cv::rectangle(out, cv::Rect(0, 0, out.cols, out.rows), bgr(frame), 12);
}

void crate(cv::Mat& out, Colour colour, Random& random) {
  const int slats = 4;
  for (int i = 0; i < slats; ++i) {
    const cv::Rect slat =
        span(0, out.rows * i / double(slats), out.cols, out.rows * (i + 1) / double(slats) - 3);
    cv::rectangle(out, slat, bgr(shade(colour, random.uniform(0.9, 1.08))), cv::FILLED);
    cv::line(out, {0, slat.br().y + 1}, {out.cols, slat.br().y + 1}, bgr(shade(colour, 0.35)), 3);
  }
  const int post = std::max(4, out.cols / 9);
  for (const int x : {0, out.cols - post}) {
    cv::rectangle(out, cv::Rect(x, 0, post, out.rows), bgr(shade(colour, 0.92)), cv::FILLED);
    cv::rectangle(out, cv::Rect(x, 0, post, out.rows), bgr(shade(colour, 0.5)), 1);
  }
}

void cardboard(cv::Mat& out, Colour colour) {
  const int tape = std::max(3, out.cols / 10);
  cv::rectangle(out, cv::Rect(out.cols / 2 - tape / 2, 0, tape, out.rows / 4), bgr(shade(colour, 1.18)),
                cv::FILLED);
  cv::line(out, {0, out.rows / 30 + 2}, {out.cols, out.rows / 30 + 2}, bgr(shade(colour, 0.75)), 1);
  const cv::Point arrow(out.cols / 5, out.rows * 3 / 5);
  const int s = std::max(4, out.rows / 10);
  cv::arrowedLine(out, arrow, arrow - cv::Point(0, s * 2), bgr(shade(colour, 0.45)), 2, cv::LINE_AA, 0, 0.4);
  cv::line(out, arrow + cv::Point(-s, 4), arrow + cv::Point(s, 4), bgr(shade(colour, 0.45)), 2);
}

}  // namespace

cv::Mat wall(const WallConfig& wall, double length_m, double px_per_m, Random& random) {
  cv::Mat out = plain({cvRound(length_m * px_per_m), cvRound(wall.height_m * px_per_m)}, wall.colour);
  switch (wall.look) {
    case WallLook::paint:
      break;
    case WallLook::wallpaper:
      stripes(out, wall.colour, px_per_m);
      break;
    case WallLook::brick:
      bricks(out, wall.colour, px_per_m, random);
      break;
    case WallLook::board:
      board(out, wall.colour, px_per_m, random);
      break;
  }
  modulate(out, soft_noise(out.size(), 0.5 * px_per_m, 5, random), 0.025);
  if (wall.skirting_m > 0) skirting_board(out, wall, px_per_m);
  if (wall.pictures && wall.height_m > 1.8) {
    for (double x = 0.7; x + 0.5 < length_m; x += 1.7) {
      const double y = out.rows - 1.6 * px_per_m;
      picture(out, span(x * px_per_m, y, (x + 0.55) * px_per_m, y + 0.4 * px_per_m), random);
    }
  }
  return out;
}

cv::Mat box_side(const BoxConfig& box, double length_m, double px_per_m, Random& random) {
  cv::Mat out = plain({cvRound(length_m * px_per_m), cvRound(box.height_m * px_per_m)}, box.colour);
  switch (box.look) {
    case BoxLook::plain:
      break;
    case BoxLook::wood:
      grain(out, 8, 0.16, random);
      break;
    case BoxLook::cardboard:
      cardboard(out, box.colour);
      break;
    case BoxLook::books:
      books(out, box.colour, px_per_m, random);
      break;
    case BoxLook::drawers:
      drawers(out, box.colour);
      break;
    case BoxLook::crate:
      crate(out, box.colour, random);
      break;
    case BoxLook::poster:
      poster(out, px_per_m, random);
      break;
  }
  if (box.look == BoxLook::crate || box.look == BoxLook::drawers) grain(out, 6, 0.10, random);
  modulate(out, soft_noise(out.size(), 24, 4, random), 0.04);
  if (box.look != BoxLook::plain) edge(out, box.colour);
  return out;
}

cv::Mat box_top(const BoxConfig& box, double px_per_m, Random& random) {
  cv::Mat out = plain({cvRound(box.length_m * px_per_m), cvRound(box.width_m * px_per_m)}, box.colour);
  if (box.look == BoxLook::cardboard) {
    cv::line(out, {0, out.rows / 2}, {out.cols, out.rows / 2}, bgr(shade(box.colour, 0.6)), 2);
  } else if (box.look != BoxLook::plain) {
    grain(out, 7, 0.12, random);
  }
  modulate(out, soft_noise(out.size(), 24, 4, random), 0.04);
  edge(out, box.colour);
  return out;
}

cv::Mat cylinder(const CylinderConfig& c, double px_per_m, Random& random) {
  cv::Mat out = plain({cvRound(6.2832 * c.radius_m * px_per_m), cvRound(c.height_m * px_per_m)}, c.colour);
  if (c.look == CylinderLook::stripes) {
    const int bands = 5;
    for (int i = 1; i < bands; i += 2) {
      cv::rectangle(out, span(0, out.rows * i / double(bands), out.cols, out.rows * (i + 1) / double(bands)),
                    bgr({244, 242, 236}), cv::FILLED);
    }
  } else if (c.look == CylinderLook::wood) {
    modulate(out, grain_noise(out.size(), 40, 0.12, 4, random), 0.15);
  } else if (c.look == CylinderLook::plant) {
    cv::rectangle(out, span(0, 0, out.cols, out.rows * 0.15), bgr(shade(c.colour, 1.15)), cv::FILLED);
  }
  modulate(out, soft_noise(out.size(), 16, 3, random), 0.04);
  return out;
}

cv::Mat leaves(cv::Size size, Colour colour, Random& random) {
  cv::Mat out = plain(size, shade(colour, 0.55));
  for (int i = 0; i < size.area() / 60; ++i) {
    const cv::Point at(static_cast<int>(random.integer(0, size.width - 1)),
                       static_cast<int>(random.integer(0, size.height - 1)));
    const cv::Size leaf(static_cast<int>(random.integer(5, 11)), static_cast<int>(random.integer(2, 4)));
    cv::ellipse(out, at, leaf, random.uniform(0, 360), 0, 360, bgr(shade(colour, random.uniform(0.6, 1.25))),
                cv::FILLED, cv::LINE_AA);
  }
  return out;
}

}  // namespace mirada::world::paint
