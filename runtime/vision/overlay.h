#pragma once
#include <opencv2/core.hpp>

#include "model/percepts.h"

namespace mirada::vision {

/// Draws what was seen on a picture of the same size: boundary in the answers' colours, distances, face
/// boxes.
void draw_overlay(cv::Mat& bgr, const SonarPercept& sonar, const FacesPercept& faces);

}  // namespace mirada::vision
