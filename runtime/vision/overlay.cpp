#include "vision/overlay.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <opencv2/imgproc.hpp>

namespace mirada::vision {
namespace {

const cv::Scalar kBlocked(60, 90, 255);
const cv::Scalar kClear(80, 200, 80);
const cv::Scalar kUnsure(170, 170, 170);
const cv::Scalar kFace(255, 160, 50);

const cv::Scalar& colour_of(Answer answer) {
  return answer == Answer::blocked ? kBlocked : answer == Answer::clear ? kClear : kUnsure;
}

/// White with a dark rim: legible on any picture.
void write(cv::Mat& bgr, const std::string& text, cv::Point middle, double scale) {
  constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
  const int thin = std::max(1, static_cast<int>(std::lround(scale * 1.6)));
  int base = 0;
  const cv::Size size = cv::getTextSize(text, kFont, scale, thin, &base);
  const cv::Point at(std::clamp(middle.x - size.width / 2, 2, std::max(2, bgr.cols - size.width - 2)),
                     std::clamp(middle.y, size.height + 2, std::max(size.height + 2, bgr.rows - 4)));
  cv::putText(bgr, text, at, kFont, scale, cv::Scalar(30, 30, 30), thin + 2, cv::LINE_AA);
  cv::putText(bgr, text, at, kFont, scale, cv::Scalar(255, 255, 255), thin, cv::LINE_AA);
}

void draw_boundary(cv::Mat& bgr, const std::vector<BoundaryPixel>& boundary, double scale) {
  const int thick = std::max(2, static_cast<int>(std::lround(3 * scale)));
  for (std::size_t i = 0; i + 1 < boundary.size(); ++i) {
    const BoundaryPixel& a = boundary[i];
    const BoundaryPixel& b = boundary[i + 1];
    if (a.answer != b.answer || std::abs(a.v_px - b.v_px) > 0.08 * bgr.rows) continue;
    if (a.answer != Answer::blocked && a.answer != Answer::clear) continue;
    const cv::Point from(cvRound(a.u_px), cvRound(a.v_px));
    const cv::Point to(cvRound(b.u_px), cvRound(b.v_px));
    cv::line(bgr, from, to, cv::Scalar(30, 30, 30), thick + 2, cv::LINE_AA);
    cv::line(bgr, from, to, colour_of(a.answer), thick, cv::LINE_AA);
  }
}

/// A dot and the centimetres where the nearest obstacle stands on the floor.
void draw_nearest(cv::Mat& bgr, const SonarPercept& sonar, double scale) {
  const SonarReading* nearest = nullptr;
  for (const SonarReading& reading : sonar.readings) {
    if (reading.answer == Answer::blocked && (!nearest || reading.distance_m < nearest->distance_m))
      nearest = &reading;
  }
  if (!nearest) return;
  // The lowest boundary pixel is the nearest place, but for the lens's small offset.
  const BoundaryPixel* place = nullptr;
  for (const BoundaryPixel& pixel : sonar.boundary) {
    if (pixel.answer == Answer::blocked && (!place || pixel.v_px > place->v_px)) place = &pixel;
  }
  if (!place) return;
  const cv::Point at(cvRound(place->u_px), std::min(cvRound(place->v_px), bgr.rows - 1));
  cv::circle(bgr, at, std::max(3, cvRound(5 * scale)), cv::Scalar(255, 255, 255), cv::FILLED, cv::LINE_AA);
  cv::circle(bgr, at, std::max(2, cvRound(4 * scale)), kBlocked, cv::FILLED, cv::LINE_AA);
  write(bgr, std::to_string(std::lround(nearest->distance_m * 100)) + " cm",
        {at.x, at.y - cvRound(9 * scale)}, 0.6 * scale);
}

}  // namespace

void draw_overlay(cv::Mat& bgr, const SonarPercept& sonar, const FacesPercept& faces) {
  if (bgr.empty()) return;
  const double scale = std::clamp(bgr.cols / 320.0, 0.5, 8.0);
  draw_boundary(bgr, sonar.boundary, scale);
  for (const FacePercept& face : faces.faces) {
    const cv::Rect box(cvRound(face.x_px), cvRound(face.y_px), cvRound(face.w_px), cvRound(face.h_px));
    cv::rectangle(bgr, box, cv::Scalar(30, 30, 30), cvRound(4 * scale), cv::LINE_AA);
    cv::rectangle(bgr, box, kFace, std::max(2, cvRound(2 * scale)), cv::LINE_AA);
  }
  draw_nearest(bgr, sonar, scale);
  if (sonar.frame != 0 && !sonar.floor_model_trusted)
    write(bgr, "?", {bgr.cols / 2, bgr.rows - 6}, 1.5 * scale);
}

}  // namespace mirada::vision
