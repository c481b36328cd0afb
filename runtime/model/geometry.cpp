#include "model/geometry.h"

#include <cmath>

namespace mirada {

Pose2 compose(const Pose2& X_AB, const Pose2& X_BC) {
  const double c = std::cos(X_AB.heading_rad);
  const double s = std::sin(X_AB.heading_rad);
  return {X_AB.x_m + c * X_BC.x_m - s * X_BC.y_m, X_AB.y_m + s * X_BC.x_m + c * X_BC.y_m,
          wrap_rad(X_AB.heading_rad + X_BC.heading_rad)};
}

Pose2 inverse(const Pose2& X_AB) {
  const double c = std::cos(X_AB.heading_rad);
  const double s = std::sin(X_AB.heading_rad);
  return {-c * X_AB.x_m - s * X_AB.y_m, s * X_AB.x_m - c * X_AB.y_m, wrap_rad(-X_AB.heading_rad)};
}

}  // namespace mirada
