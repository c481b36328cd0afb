#include "vision/calibration/board_truth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>
#include <opencv2/calib3d.hpp>

namespace mirada::vision {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kLens = 8;   ///< fx fy cx cy and four of the distortion's numbers
constexpr int kPrint = 4;  ///< xx yy xy of the surface, stretch
constexpr int kShared = kLens + kPrint;
constexpr int kPose = 6;
constexpr double kStillKnown = 1e-12;  ///< share of the largest eigenvalue

struct PoseOfView {
  Eigen::Matrix3d R;
  Vector3d t;
};

PoseOfView pose_of(const LensFit& fit, std::size_t view) {
  cv::Mat R;
  cv::Rodrigues(fit.rotations[view], R);
  PoseOfView out;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) out.R(i, j) = R.at<double>(i, j);
    out.t[i] = fit.translations[view].at<double>(i);
  }
  return out;
}

double& lens_number(CameraModel& camera, int i) {
  double* plain[] = {&camera.fx_px, &camera.fy_px, &camera.cx_px, &camera.cy_px};
  return i < 4 ? *plain[i] : camera.distortion[static_cast<std::size_t>(i - 4)];
}

/// The board in units of its half diagonal about its middle, so that all unknowns are of one size.
struct Sheet {
  Vector2d middle_m{0, 0};
  double half_m = 1;

  explicit Sheet(const std::vector<BoardView>& views) {
    Vector2d low(1e9, 1e9), high(-1e9, -1e9);
    for (const BoardView& view : views) {
      for (const cv::Point3f& p : view.corners_B_m) {
        low = low.cwiseMin(Vector2d(p.x, p.y));
        high = high.cwiseMax(Vector2d(p.x, p.y));
      }
    }
    middle_m = (low + high) / 2;
    half_m = std::max(1e-6, (high - low).norm() / 2);
  }
  Vector2d at(const cv::Point3f& p) const { return (Vector2d(p.x, p.y) - middle_m) / half_m; }
};

/// How a corner's pixel changes with its place in the camera's frame, by differences.
Eigen::Matrix<double, 2, 3> pixel_by_place(const CameraModel& camera, const Vector3d& p_C) {
  Eigen::Matrix<double, 2, 3> out = Eigen::Matrix<double, 2, 3>::Zero();
  const double step = 1e-5 * p_C.norm();
  for (int i = 0; i < 3; ++i) {
    Vector3d up = p_C;
    Vector3d down = p_C;
    up[i] += step;
    down[i] -= step;
    const auto a = camera.project(up);
    const auto b = camera.project(down);
    if (a && b) out.col(i) = (*a - *b) / (2 * step);
  }
  return out;
}

Vector2d pixel_by_lens(const CameraModel& camera, const Vector3d& p_C, int number) {
  const double step = number < 4 ? 1e-3 : 1e-6;
  CameraModel up = camera;
  CameraModel down = camera;
  lens_number(up, number) += step;
  lens_number(down, number) -= step;
  const auto a = up.project(p_C);
  const auto b = down.project(p_C);
  return a && b ? Vector2d((*a - *b) / (2 * step)) : Vector2d(0, 0);
}

struct Normal {
  MatrixXd A = MatrixXd::Zero(kShared, kShared);
  VectorXd b = VectorXd::Zero(kShared);
  double residuals = 0;
  double squares = 0;
};

/// Adds one view with its pose eliminated.
void add_view(const BoardView& view, const CameraModel& camera, const PoseOfView& X, const Sheet& sheet,
              Normal& sum) {
  const auto rows = static_cast<Eigen::Index>(2 * view.corners_px.size());
  MatrixXd shared(rows, kShared);
  MatrixXd pose(rows, kPose);
  VectorXd r(rows);
  for (std::size_t i = 0; i < view.corners_px.size(); ++i) {
    const cv::Point3f& p = view.corners_B_m[i];
    const Vector3d from_R = X.R * Vector3d(p.x, p.y, p.z);
    const Vector3d p_C = from_R + X.t;
    const auto row = static_cast<Eigen::Index>(2 * i);
    const auto foretold = camera.project(p_C);
    const Vector2d seen(view.corners_px[i].x, view.corners_px[i].y);
    r.segment<2>(row) = foretold ? Vector2d(seen - *foretold) : Vector2d(0, 0);
    const Eigen::Matrix<double, 2, 3> J = pixel_by_place(camera, p_C);
    Eigen::Matrix3d cross;
    cross << 0, -from_R.z(), from_R.y(), from_R.z(), 0, -from_R.x(), -from_R.y(), from_R.x(), 0;
    pose.block<2, 3>(row, 0) = -J * cross;
    pose.block<2, 3>(row, 3) = J;
    for (int k = 0; k < kLens; ++k) shared.block<2, 1>(row, k) = pixel_by_lens(camera, p_C, k);
    const Vector2d q = sheet.at(p);
    const Vector2d by_height = J * X.R.col(2) * sheet.half_m;
    shared.block<2, 1>(row, kLens) = by_height * q.x() * q.x();
    shared.block<2, 1>(row, kLens + 1) = by_height * q.y() * q.y();
    shared.block<2, 1>(row, kLens + 2) = by_height * q.x() * q.y();
    shared.block<2, 1>(row, kLens + 3) = J * X.R.col(0) * sheet.half_m * q.x();
  }
  const Eigen::HouseholderQR<MatrixXd> qr(pose);
  const MatrixXd Q = qr.householderQ() * MatrixXd::Identity(rows, kPose);
  const MatrixXd free = shared - Q * (Q.transpose() * shared);
  const VectorXd left = r - Q * (Q.transpose() * r);
  sum.A += free.transpose() * free;
  sum.b += free.transpose() * left;
  sum.squares += left.squaredNorm();
  sum.residuals += static_cast<double>(rows - kPose);
}

/// Height of each corner for a unit of each surface number, planes taken away: what the numbers bend it by.
MatrixXd heights(const std::vector<BoardView>& views, const Sheet& sheet) {
  const BoardView& fullest = *std::max_element(views.begin(), views.end(), [](const auto& a, const auto& b) {
    return a.corners_B_m.size() < b.corners_B_m.size();
  });
  const auto rows = static_cast<Eigen::Index>(fullest.corners_B_m.size());
  MatrixXd surface(rows, 3);
  MatrixXd plane(rows, 3);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Vector2d q = sheet.at(fullest.corners_B_m[static_cast<std::size_t>(i)]);
    surface.row(i) << q.x() * q.x(), q.y() * q.y(), q.x() * q.y();
    plane.row(i) << 1, q.x(), q.y();
  }
  return surface - plane * plane.colPivHouseholderQr().solve(surface);
}

}  // namespace

BoardTruth examine_board(const std::vector<BoardView>& views, const LensFit& fit) {
  BoardTruth out;
  out.sigma_bend_m = out.sigma_stretch = std::numeric_limits<double>::infinity();
  const Sheet sheet(views);
  Normal sum;
  for (std::size_t i = 0; i < views.size(); ++i) {
    add_view(views[i], fit.camera, pose_of(fit, i), sheet, sum);
  }
  // Unknowns of one size each: what is left is how well the views tell them apart.
  const VectorXd scale = sum.A.diagonal().cwiseMax(1e-30).cwiseSqrt().cwiseInverse();
  const MatrixXd scaled = scale.asDiagonal() * sum.A * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(scaled);
  if (eigen.eigenvalues().minCoeff() < kStillKnown * eigen.eigenvalues().maxCoeff()) return out;
  const MatrixXd inverse = scale.asDiagonal() * scaled.inverse() * scale.asDiagonal();
  const VectorXd x = inverse * sum.b;
  const double left = std::max(1e-12, sum.squares - x.dot(sum.b)) / std::max(1.0, sum.residuals - kShared);
  const MatrixXd height = heights(views, sheet) * sheet.half_m;
  const VectorXd z = height * x.segment<3>(kLens);
  Eigen::Index top = 0;
  Eigen::Index bottom = 0;
  out.bend_m = z.maxCoeff(&top) - z.minCoeff(&bottom);
  const Eigen::RowVector3d across = height.row(top) - height.row(bottom);
  out.sigma_bend_m = std::sqrt(left * across * inverse.block<3, 3>(kLens, kLens) * across.transpose());
  out.stretch = 1 + x[kLens + 3];
  out.sigma_stretch = std::sqrt(left * inverse(kLens + 3, kLens + 3));
  return out;
}

}  // namespace mirada::vision
