#include "vision/calibration/lens_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <opencv2/calib3d.hpp>

namespace mirada::vision {
namespace {

const cv::TermCriteria kUntilStill(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 200, 1e-10);

void take(const cv::Mat& K, const cv::Mat& D, std::size_t count, cv::Size size, CameraModel& camera) {
  camera.width_px = size.width;
  camera.height_px = size.height;
  camera.fx_px = K.at<double>(0, 0);
  camera.fy_px = K.at<double>(1, 1);
  camera.cx_px = K.at<double>(0, 2);
  camera.cy_px = K.at<double>(1, 2);
  for (std::size_t i = 0; i < count; ++i) camera.distortion[i] = D.at<double>(static_cast<int>(i));
}

double rms_px(const BoardView& view, const std::vector<cv::Point2d>& projected) {
  double sum = 0;
  for (std::size_t i = 0; i < projected.size(); ++i) {
    const cv::Point2d error = projected[i] - cv::Point2d(view.corners_px[i]);
    sum += error.dot(error);
  }
  return std::sqrt(sum / static_cast<double>(projected.size()));
}

template <class Point>
std::vector<std::vector<Point>> doubles(const std::vector<BoardView>& views, auto member) {
  std::vector<std::vector<Point>> out;
  for (const BoardView& view : views) out.emplace_back((view.*member).begin(), (view.*member).end());
  return out;
}

bool finite(const LensFit& fit) {
  return std::isfinite(fit.rms_px) && std::isfinite(fit.camera.fx_px) && fit.camera.fx_px > 0 &&
         fit.camera.fy_px > 0;
}

constexpr int kLensUnknowns = 8;  ///< fx fy cx cy k1..k4
using LensMatrix = Eigen::Matrix<double, kLensUnknowns, kLensUnknowns>;

/// What one view says of the lens when its own pose is left free (Schur complement of its normal equations).
LensMatrix lens_information(const cv::Mat& jacobian) {
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Map<const Rows> J(jacobian.ptr<double>(), jacobian.rows, jacobian.cols);
  const auto lens = J.leftCols<kLensUnknowns>();
  const auto pose = J.middleCols<6>(kLensUnknowns);
  const Eigen::Matrix<double, kLensUnknowns, 6> mixed = lens.transpose() * pose;
  const Eigen::Matrix<double, 6, 6> own = pose.transpose() * pose;
  return lens.transpose() * lens - mixed * own.ldlt().solve(mixed.transpose());
}

/// Standard deviations from the residuals: fisheye::calibrate gives none.
void set_fisheye_sigma(const LensMatrix& information, double residuals, LensFit& fit) {
  const LensMatrix covariance = information.ldlt().solve(LensMatrix::Identity());
  const double unknowns = kLensUnknowns + 6.0 * static_cast<double>(fit.rotations.size());
  const double corner_px = fit.rms_px * std::sqrt(residuals / 2 / std::max(1.0, residuals - unknowns));
  const auto sigma = [&](int i) { return corner_px * std::sqrt(std::max(0.0, covariance(i, i))); };
  fit.sigma_fx_px = sigma(0);
  fit.sigma_fy_px = sigma(1);
  fit.sigma_cx_px = sigma(2);
  fit.sigma_cy_px = sigma(3);
}

}  // namespace

LensFit fit_brown(const std::vector<BoardView>& views) {
  LensFit fit;
  std::vector<std::vector<cv::Point3f>> board;
  std::vector<std::vector<cv::Point2f>> picture;
  for (const BoardView& view : views) {
    board.push_back(view.corners_B_m);
    picture.push_back(view.corners_px);
  }
  cv::Mat K;
  cv::Mat D;
  cv::Mat sigma;
  cv::Mat sigma_pose;
  cv::Mat per_view;
  try {
    fit.rms_px = cv::calibrateCamera(board, picture, views[0].size_px, K, D, fit.rotations, fit.translations,
                                     sigma, sigma_pose, per_view, 0, kUntilStill);
  } catch (const cv::Exception&) {
    return fit;
  }
  take(K, D, 5, views[0].size_px, fit.camera);
  fit.sigma_fx_px = sigma.at<double>(0);
  fit.sigma_fy_px = sigma.at<double>(1);
  fit.sigma_cx_px = sigma.at<double>(2);
  fit.sigma_cy_px = sigma.at<double>(3);
  for (int i = 0; i < per_view.rows; ++i) fit.view_rms_px.push_back(per_view.at<double>(i));
  fit.solved = finite(fit);
  return fit;
}

LensFit fit_fisheye(const std::vector<BoardView>& views) {
  LensFit fit;
  const auto board = doubles<cv::Point3d>(views, &BoardView::corners_B_m);
  const auto picture = doubles<cv::Point2d>(views, &BoardView::corners_px);
  cv::Mat K;
  cv::Mat D;
  LensMatrix information = LensMatrix::Zero();
  double residuals = 0;
  try {
    fit.rms_px = cv::fisheye::calibrate(
        board, picture, views[0].size_px, K, D, fit.rotations, fit.translations,
        cv::fisheye::CALIB_RECOMPUTE_EXTRINSIC | cv::fisheye::CALIB_FIX_SKEW, kUntilStill);
    for (std::size_t i = 0; i < views.size(); ++i) {
      std::vector<cv::Point2d> projected;
      cv::Mat jacobian;
      cv::fisheye::projectPoints(board[i], projected, fit.rotations[i], fit.translations[i], K, D, 0,
                                 jacobian);
      information += lens_information(jacobian);
      residuals += jacobian.rows;
      fit.view_rms_px.push_back(rms_px(views[i], projected));
    }
  } catch (const cv::Exception&) {
    return fit;
  }
  fit.camera.lens = CameraModel::Lens::fisheye;
  take(K, D, 4, views[0].size_px, fit.camera);
  set_fisheye_sigma(information, residuals, fit);
  fit.solved = finite(fit);
  return fit;
}

}  // namespace mirada::vision
