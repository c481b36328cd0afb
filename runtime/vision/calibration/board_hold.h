#pragma once
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "model/camera_model.h"
#include "vision/calibration/board.h"

namespace mirada::vision {

/// How a board is held before a camera whose lens is only roughly known.
struct BoardHold {
  Eigen::Isometry3d X_CB = Eigen::Isometry3d::Identity();
  Eigen::Vector2d middle{0, 0};       ///< of the board, in shares of the picture
  double size = 0;                    ///< side of a square as large as the board, in picture widths
  Eigen::Vector3d normal_C{0, 0, 1};  ///< into the paper
};

/// From the corners seen; `camera` has the picture's size. Nothing when no pose fits.
std::optional<BoardHold> hold_of(const BoardView& view, const BoardSpec& board, const CameraModel& camera);
/// From where it is. Nothing when the board's middle is not before the camera.
std::optional<BoardHold> hold_at(const Eigen::Isometry3d& X_CB, const BoardSpec& board,
                                 const CameraModel& camera);

/// How a person is asked to hold a board.
struct HoldWish {
  double u = 0.5, v = 0.5;  ///< the board's middle, in shares of the picture
  double size = 0.5;        ///< the share of the picture's width or height that it fills
  double top_near_rad = 0;  ///< its upper edge towards the camera
  double right_near_rad = 0;
};
/// The pose that comes nearest to a wish with the whole board inside the picture. Nothing when the lens does
/// not see there.
std::optional<Eigen::Isometry3d> pose_for(const HoldWish& wish, const BoardSpec& board,
                                          const CameraModel& camera);

/// The edge of the board's squares in the picture, a closed polygon; empty when it is not seen whole.
std::vector<cv::Point2f> outline_px(const Eigen::Isometry3d& X_CB, const BoardSpec& board,
                                    const CameraModel& camera);

}  // namespace mirada::vision
