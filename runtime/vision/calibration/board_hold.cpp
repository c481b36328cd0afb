#include "vision/calibration/board_hold.h"

#include <algorithm>
#include <cmath>

#include <opencv2/calib3d.hpp>

namespace mirada::vision {
namespace {

constexpr double kEdge = 0.025;  ///< the share of the picture that stays free round a board
constexpr int kTries = 24;

Eigen::Vector3d middle_B_m(const BoardSpec& board) {
  return {(board.corner_columns - 1) * board.square_m / 2, (board.corner_rows - 1) * board.square_m / 2, 0};
}

Eigen::Isometry3d pose_from_vectors(const cv::Vec3d& rotation, const cv::Vec3d& translation) {
  cv::Matx33d R;
  cv::Rodrigues(rotation, R);
  Eigen::Isometry3d out = Eigen::Isometry3d::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) out.linear()(row, column) = R(row, column);
    out.translation()[row] = translation[row];
  }
  return out;
}

struct Box {
  double left = 1, right = 0, top = 1, bottom = 0;  ///< in shares of the picture
};

std::optional<Box> box_of(const std::vector<cv::Point2f>& outline, const CameraModel& camera) {
  if (outline.empty()) return std::nullopt;
  Box out;
  for (const cv::Point2f& p : outline) {
    out.left = std::min(out.left, p.x / static_cast<double>(camera.width_px));
    out.right = std::max(out.right, p.x / static_cast<double>(camera.width_px));
    out.top = std::min(out.top, p.y / static_cast<double>(camera.height_px));
    out.bottom = std::max(out.bottom, p.y / static_cast<double>(camera.height_px));
  }
  return out;
}

/// How far a span must move to lie between the edges.
double shift_inside(double low, double high) {
  if (low < kEdge) return kEdge - low;
  if (high > 1 - kEdge) return 1 - kEdge - high;
  return 0;
}

}  // namespace

std::optional<BoardHold> hold_of(const BoardView& view, const BoardSpec& board, const CameraModel& camera) {
  std::vector<cv::Point2d> rays;
  for (const cv::Point2f& corner : view.corners_px) {
    const auto ray = camera.unproject({corner.x, corner.y});
    if (!ray) return std::nullopt;
    rays.emplace_back(ray->x(), ray->y());
  }
  cv::Vec3d rotation;
  cv::Vec3d translation;
  try {
    const std::vector<cv::Point3d> points(view.corners_B_m.begin(), view.corners_B_m.end());
    if (!cv::solvePnP(points, rays, cv::Matx33d::eye(), cv::noArray(), rotation, translation, false,
                      cv::SOLVEPNP_IPPE)) {
      return std::nullopt;
    }
  } catch (const cv::Exception&) {
    return std::nullopt;
  }
  return hold_at(pose_from_vectors(rotation, translation), board, camera);
}

std::optional<BoardHold> hold_at(const Eigen::Isometry3d& X_CB, const BoardSpec& board,
                                 const CameraModel& camera) {
  const Eigen::Vector3d middle_C_m = X_CB * middle_B_m(board);
  const auto pixel = camera.project(middle_C_m);
  if (!pixel || !(middle_C_m.z() > 0)) return std::nullopt;
  BoardHold out;
  out.X_CB = X_CB;
  out.middle = {pixel->x() / camera.width_px, pixel->y() / camera.height_px};
  const double side_m = board.square_m * std::sqrt((board.corner_columns + 1.0) * (board.corner_rows + 1.0));
  out.size = side_m / middle_C_m.z() * camera.fx_px / camera.width_px;
  out.normal_C = X_CB.linear().col(2);
  return out;
}

std::optional<Eigen::Isometry3d> pose_for(const HoldWish& wish, const BoardSpec& board,
                                          const CameraModel& camera) {
  Eigen::Isometry3d X_CB = Eigen::Isometry3d::Identity();
  X_CB.linear() = (Eigen::AngleAxisd(wish.top_near_rad, Eigen::Vector3d::UnitX()) *
                   Eigen::AngleAxisd(wish.right_near_rad, Eigen::Vector3d::UnitY()))
                      .toRotationMatrix();
  const double wide = (board.corner_columns + 1) * board.square_m * camera.fx_px / camera.width_px;
  const double high = (board.corner_rows + 1) * board.square_m * camera.fy_px / camera.height_px;
  double distance_m = std::max(wide, high) / wish.size;
  double u = wish.u;
  double v = wish.v;
  for (int i = 0; i < kTries; ++i) {
    const auto ray = camera.unproject({u * camera.width_px, v * camera.height_px});
    if (!ray) return std::nullopt;
    X_CB.translation() = *ray * distance_m - X_CB.linear() * middle_B_m(board);
    const auto box = box_of(outline_px(X_CB, board, camera), camera);
    if (!box || box->right - box->left > 1 - 2 * kEdge || box->bottom - box->top > 1 - 2 * kEdge) {
      distance_m *= 1.1;
      continue;
    }
    const double du = shift_inside(box->left, box->right);
    const double dv = shift_inside(box->top, box->bottom);
    if (std::abs(du) < 1e-3 && std::abs(dv) < 1e-3) return X_CB;
    u += du;
    v += dv;
  }
  return std::nullopt;
}

std::vector<cv::Point2f> outline_px(const Eigen::Isometry3d& X_CB, const BoardSpec& board,
                                    const CameraModel& camera) {
  constexpr int kPieces = 6;  // a wide lens bends the sides
  const double right = board.corner_columns * board.square_m;
  const double bottom = board.corner_rows * board.square_m;
  const double first = -board.square_m;
  const Eigen::Vector3d corners[] = {
      {first, first, 0}, {right, first, 0}, {right, bottom, 0}, {first, bottom, 0}};
  std::vector<cv::Point2f> out;
  for (int side = 0; side < 4; ++side) {
    for (int i = 0; i < kPieces; ++i) {
      const double t = static_cast<double>(i) / kPieces;
      const Eigen::Vector3d p_C = X_CB * ((1 - t) * corners[side] + t * corners[(side + 1) % 4]);
      const auto pixel = p_C.z() > 0 ? camera.project(p_C) : std::nullopt;
      if (!pixel) return {};
      out.emplace_back(static_cast<float>(pixel->x()), static_cast<float>(pixel->y()));
    }
  }
  return out;
}

}  // namespace mirada::vision
