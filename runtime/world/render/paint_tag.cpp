#include <memory>

#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>
#include <opencv2/imgproc.hpp>

#include "world/render/paint.h"

namespace mirada::world::paint {

cv::Mat tag(int id) {
  constexpr int kCell_px = 16;
  const std::unique_ptr<apriltag_family_t, void (*)(apriltag_family_t*)> family(tag36h11_create(),
                                                                                tag36h11_destroy);
  const std::unique_ptr<image_u8_t, void (*)(image_u8_t*)> image(
      apriltag_to_image(family.get(), static_cast<std::uint32_t>(id)), image_u8_destroy);
  const cv::Mat cells(image->height, image->width, CV_8UC1, image->buf,
                      static_cast<std::size_t>(image->stride));
  CV_Assert(cells.cols == kTagCells && cells.rows == kTagCells);
  cv::Mat out;
  cv::cvtColor(cells, out, cv::COLOR_GRAY2BGR);
  cv::resize(out * 0.86 + cv::Scalar::all(16), out, {}, kCell_px, kCell_px, cv::INTER_NEAREST);
  return out;
}

}  // namespace mirada::world::paint
