#pragma once
#include <Eigen/Geometry>

#include "model/camera_model.h"
#include "model/percepts.h"
#include "vision/faces/face_net.h"

namespace mirada::vision {

/// How large a face's box is taken to be: 0.15 m x 0.183 m, as width^0.35 x height^0.65, because a head that
/// turns keeps its height. Heads from about seven years on differ from it by kFaceSizeShare (one sigma).
constexpr double kFaceSize_m = 0.1707;
constexpr double kFaceSizeShare = 0.07;

/// The angle under which a box is seen, weighted alike; the boxes of small faces come out a little small,
/// which is put right.
double seen_size_rad(const cv::Rect2d& box_px, const CameraModel& camera);

/// Box, bearing, elevation and distance of a face, the distance from its size.
/// `camera` is scaled to the picture.
FacePercept place_face(const FaceBox& found, const CameraModel& camera, const Eigen::Isometry3d& X_RC);

/// The face's middle in the robot's frame, from its bearing, distance and
/// elevation; and the other way round.
Eigen::Vector3d face_point_R(const FacePercept& face, const Eigen::Isometry3d& X_RC);
void set_face_point_R(FacePercept& face, const Eigen::Vector3d& p_RF, const Eigen::Isometry3d& X_RC);

}  // namespace mirada::vision
