#include "model/camera_model.h"

#include <cmath>

#include <Eigen/LU>

namespace mirada {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Distortion = std::array<double, 5>;

// Brown's radial factor is 1 + k1 s + k2 s^2 + k3 s^3 with s = r^2; seen from the centre it must keep
// growing, or two rays share a pixel. Its slope is a cubic in s that starts at 1, so its lowest point lies at
// the end or where the cubic's own slope is zero.
bool brown_grows_up_to(double s, const Distortion& k) {
  const double a = 3 * k[0];
  const double b = 5 * k[1];
  const double c = 7 * k[4];
  const auto slope = [&](double t) { return 1 + t * (a + t * (b + t * c)); };
  if (slope(s) <= 0) return false;
  const double disc = b * b - 3 * a * c;
  if (disc < 0) return true;
  // Numerically safe roots of a + 2 b t + 3 c t^2.
  const double q = -(b + std::copysign(std::sqrt(disc), b));
  for (const double t : {c == 0 ? -1 : q / (3 * c), q == 0 ? -1 : a / q}) {
    if (t > 0 && t < s && slope(t) <= 0) return false;
  }
  return true;
}

struct Bent {
  Vector2d point;
  Matrix2d slope;
};

Bent brown(const Vector2d& p, const Distortion& k) {
  const double x = p.x();
  const double y = p.y();
  const double s = p.squaredNorm();
  const double radial = 1 + s * (k[0] + s * (k[1] + s * k[4]));
  const double radial_slope = k[0] + s * (2 * k[1] + s * 3 * k[4]);  // d radial / d s
  Bent out;
  out.point = {x * radial + 2 * k[2] * x * y + k[3] * (s + 2 * x * x),
               y * radial + k[2] * (s + 2 * y * y) + 2 * k[3] * x * y};
  const double mixed = 2 * x * y * radial_slope + 2 * k[2] * x + 2 * k[3] * y;
  out.slope << radial + 2 * x * x * radial_slope + 2 * k[2] * y + 6 * k[3] * x, mixed, mixed,
      radial + 2 * y * y * radial_slope + 6 * k[2] * y + 2 * k[3] * x;
  return out;
}

std::optional<Vector2d> unbend_brown(const Vector2d& bent, const Distortion& k) {
  Vector2d p = bent;
  Bent at = brown(p, k);
  for (int i = 0; i < 60; ++i) {
    const Vector2d error = bent - at.point;
    if (error.norm() < 1e-14) break;
    const Vector2d step = at.slope.determinant() != 0 ? Vector2d(at.slope.inverse() * error) : error;
    double share = 1;
    Bent next = brown(p + step, k);
    while (share > 1e-3 && (bent - next.point).norm() > error.norm()) {
      share /= 2;
      next = brown(p + share * step, k);
    }
    p += share * step;
    at = next;
  }
  if (!((bent - at.point).norm() < 1e-11) || !brown_grows_up_to(p.squaredNorm(), k)) return std::nullopt;
  return p;
}

double fisheye_radius(double theta, const Distortion& k) {
  const double s = theta * theta;
  return theta * (1 + s * (k[0] + s * (k[1] + s * (k[2] + s * k[3]))));
}

double fisheye_slope(double theta, const Distortion& k) {
  const double s = theta * theta;
  return 1 + s * (3 * k[0] + s * (5 * k[1] + s * (7 * k[2] + s * 9 * k[3])));
}

bool fisheye_grows_up_to(double theta, const Distortion& k) {
  constexpr int kSteps = 24;
  for (int i = 1; i <= kSteps; ++i) {
    if (fisheye_slope(theta * i / kSteps, k) <= 0) return false;
  }
  return true;
}

/// The angle off the axis that lands at this radius: bisection, then Newton to the last digit.
std::optional<double> fisheye_angle(double radius, const Distortion& k) {
  double low = 0;
  double high = std::numbers::pi / 2;
  if (fisheye_grows_up_to(high, k) && fisheye_radius(high, k) <= radius) return std::nullopt;
  for (int i = 0; i < 40; ++i) {
    const double middle = (low + high) / 2;
    const bool beyond = fisheye_slope(middle, k) <= 0 || fisheye_radius(middle, k) > radius;
    (beyond ? high : low) = middle;
  }
  double theta = low;
  for (int i = 0; i < 4; ++i) theta -= (fisheye_radius(theta, k) - radius) / fisheye_slope(theta, k);
  if (!(std::abs(fisheye_radius(theta, k) - radius) < 1e-11) || !fisheye_grows_up_to(theta, k))
    return std::nullopt;
  return theta;
}

}  // namespace

double CameraModel::hfov_rad() const { return 2 * std::atan(width_px / (2 * fx_px)); }
double CameraModel::vfov_rad() const { return 2 * std::atan(height_px / (2 * fy_px)); }

std::optional<Vector2d> CameraModel::project(const Eigen::Vector3d& p_C) const {
  if (!(p_C.z() > 0)) return std::nullopt;
  Vector2d bent = p_C.head<2>() / p_C.z();
  if (lens == Lens::brown) {
    if (!brown_grows_up_to(bent.squaredNorm(), distortion)) return std::nullopt;
    bent = brown(bent, distortion).point;
  } else if (const double r = bent.norm(); r > 0) {
    const double theta = std::atan(r);
    if (!fisheye_grows_up_to(theta, distortion)) return std::nullopt;
    bent *= fisheye_radius(theta, distortion) / r;
  }
  return Vector2d(fx_px * bent.x() + cx_px, fy_px * bent.y() + cy_px);
}

std::optional<Eigen::Vector3d> CameraModel::unproject(const Vector2d& pixel) const {
  const Vector2d bent((pixel.x() - cx_px) / fx_px, (pixel.y() - cy_px) / fy_px);
  if (lens == Lens::brown) {
    const auto p = unbend_brown(bent, distortion);
    if (!p) return std::nullopt;
    return Eigen::Vector3d(p->x(), p->y(), 1);
  }
  const double radius = bent.norm();
  if (radius == 0) return Eigen::Vector3d(0, 0, 1);
  const auto theta = fisheye_angle(radius, distortion);
  if (!theta) return std::nullopt;
  const Vector2d p = bent * (std::tan(*theta) / radius);
  return Eigen::Vector3d(p.x(), p.y(), 1);
}

CameraModel CameraModel::scaled_to(int new_width_px, int new_height_px) const {
  CameraModel out = *this;
  const double sx = static_cast<double>(new_width_px) / width_px;
  const double sy = static_cast<double>(new_height_px) / height_px;
  out.width_px = new_width_px;
  out.height_px = new_height_px;
  out.fx_px *= sx;
  out.fy_px *= sy;
  out.cx_px = (cx_px + 0.5) * sx - 0.5;
  out.cy_px = (cy_px + 0.5) * sy - 0.5;
  return out;
}

}  // namespace mirada
