#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "model/camera_model.h"
#include "model/geometry.h"
#include "world/held_board.h"
#include "world/world_config.h"

namespace mirada::world {

/// Pictures of a room through one camera: each pixel's exact ray (distortion included) meets floor, faces and
/// people, so a foot appears where CameraModel::project says. One thread; the same arguments give the same
/// bits.
class Renderer {
 public:
  /// Paints the textures (tens of milliseconds to some tenths of a second).
  Renderer(const WorldConfig& placed, const CameraModel& camera, std::uint64_t seed);
  ~Renderer();
  Renderer(Renderer&&) noexcept;

  /// `people`: where each of the world's people stands. `chance` picks the sensor noise. `held`: a print that
  /// is nearer than all of it, or null. A new CV_8UC3 picture.
  cv::Mat render(const Eigen::Isometry3d& X_WC, const std::vector<Pose2>& people, std::int64_t chance,
                 const HeldBoard* held = nullptr);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mirada::world
