#pragma once
#include <vector>

#include <opencv2/core.hpp>

namespace mirada::vision {

/// Where a face may be in a grey picture: areas that are not uniform, as Vega and Cañas (2019, section 5.4)
/// skip uniform ones, but by density: a cell counts when most of its neighbourhood is textured, for one cell
/// with an edge in it is found nearly everywhere. Areas do not overlap. The whole picture when hardly
/// anything would be saved; empty when there is nothing but plain wall.
std::vector<cv::Rect> textured_areas(const cv::Mat& gray);

}  // namespace mirada::vision
