#include "robot/sureness.h"

#include <algorithm>
#include <cmath>

namespace mirada::robot {
namespace {

constexpr double kAboutRight = 0.1;  // of the distance
constexpr double kAboutRightLeast_m = 0.02;

}  // namespace

double sureness(const SonarReading& reading) {
  const bool measured = reading.answer == Answer::blocked || reading.answer == Answer::clear;
  if (!measured || !(reading.distance_m >= 0) || !(reading.sigma_m >= 0)) return 0;
  const double about_m = std::max(kAboutRight * reading.distance_m, kAboutRightLeast_m);
  return reading.sigma_m == 0 ? 1 : std::erf(about_m / (std::sqrt(2.0) * reading.sigma_m));
}

}  // namespace mirada::robot
