#pragma once
#include <opencv2/core.hpp>

#include "vision/tags/tag_finder.h"

namespace mirada::vision {

/// A mark as it is printed: CV_8UC1, one pixel a cell, its black border included and no white one about it.
/// `id` is below family_size(family).
cv::Mat tag_picture(TagFamily family, int id);

}  // namespace mirada::vision
