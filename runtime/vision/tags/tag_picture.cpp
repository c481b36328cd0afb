#include "vision/tags/tag_picture.h"

#include <cassert>
#include <cstdint>
#include <memory>
#include <span>

#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>

#include "vision/tags/aruco_codes.h"

namespace mirada::vision {
namespace {

cv::Mat from_bits(std::uint64_t code, int side) {
  cv::Mat out = cv::Mat::zeros(side + 2, side + 2, CV_8UC1);
  for (int i = 0; i < side * side; ++i) {
    const bool white = (code >> (side * side - 1 - i) & 1U) != 0;
    out.at<unsigned char>(1 + i / side, 1 + i % side) = white ? 255 : 0;
  }
  return out;
}

cv::Mat from_library(int id) {
  const std::unique_ptr<apriltag_family_t, void (*)(apriltag_family_t*)> family(tag36h11_create(),
                                                                                tag36h11_destroy);
  const std::unique_ptr<image_u8_t, void (*)(image_u8_t*)> image(
      apriltag_to_image(family.get(), static_cast<std::uint32_t>(id)), image_u8_destroy);
  const cv::Mat whole(image->height, image->width, CV_8UC1, image->buf,
                      static_cast<std::size_t>(image->stride));
  const int border = (image->width - family->width_at_border) / 2;
  return whole(cv::Rect(border, border, family->width_at_border, family->width_at_border)).clone();
}

}  // namespace

cv::Mat tag_picture(TagFamily family, int id) {
  assert(id >= 0 && id < family_size(family));
  const auto at = static_cast<std::size_t>(id);
  switch (family) {
    case TagFamily::aruco_4x4:
      return from_bits(kAruco4x4[at], 4);
    case TagFamily::aruco_5x5:
      return from_bits(kAruco5x5[at], 5);
    case TagFamily::aruco_6x6:
      return from_bits(kAruco6x6[at], 6);
    case TagFamily::april_36h11:
      break;
  }
  return from_library(id);
}

}  // namespace mirada::vision
