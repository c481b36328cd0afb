#pragma once
#include <vector>

#include <opencv2/core.hpp>

namespace mirada::vision {

/// Side of the picture that local_patterns() takes.
inline constexpr int kPatternSide_px = 72;

/// Histograms of uniform local binary patterns (Ahonen, Hadid, Pietikäinen 2004) of a grey face, cell by
/// cell, each value by its root, so that the scalar product of two is how much their histograms overlap
/// (Bhattacharyya).
std::vector<float> local_patterns(const cv::Mat& grey);

}  // namespace mirada::vision
