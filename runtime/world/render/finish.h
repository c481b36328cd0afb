#pragma once
#include <cstdint>
#include <vector>

#include <opencv2/core.hpp>

#include "world/render/ray_table.h"
#include "world/world_config.h"

namespace mirada::world {

/// What lens and sensor do to a picture: dark corners and noise. The noise is drawn once and laid at another
/// offset each picture, which costs a tenth of drawing it anew.
class Finish {
 public:
  Finish(const RayTable& rays, const NoiseConfig& noise, std::uint64_t seed);
  /// `bgra` has rows of rays.stride; gives CV_8UC3 of the camera's size. The same `chance` gives the same
  /// noise.
  cv::Mat develop(const std::vector<std::uint32_t>& bgra, std::uint64_t chance) const;

 private:
  int width_, height_, stride_;
  std::vector<std::uint16_t> bright_;  ///< 256 = unchanged, per channel of each pixel
  cv::Mat noise_;                      ///< CV_8SC3, larger than the picture by the offsets
};

}  // namespace mirada::world
