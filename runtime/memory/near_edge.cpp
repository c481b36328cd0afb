#include "memory/near_edge.h"

#include <cmath>
#include <limits>

namespace mirada::memory {

void NearEdge::aim(const NeckAngles& neck) {
  if (neck.pan_rad == neck_.pan_rad && neck.tilt_rad == neck_.tilt_rad) return;
  neck_ = neck;
  const Eigen::Isometry3d X_RC = robot_.X_RC(neck);
  const CameraModel& camera = robot_.camera;
  for (int i = 0; i < kColumns; ++i) {
    Column& column = columns_[static_cast<std::size_t>(i)];
    column = {neck.pan_rad, std::numeric_limits<double>::infinity()};
    const auto ray_C =
        camera.unproject({i * (camera.width_px - 1) / (kColumns - 1.0), camera.height_px - 1.0});
    if (!ray_C) continue;
    const Eigen::Vector3d ray_R = X_RC.linear() * *ray_C;
    column.bearing_rad = std::atan2(ray_R.y(), ray_R.x());
    if (ray_R.z() > -1e-6) continue;
    const Eigen::Vector3d p_R = X_RC.translation() - X_RC.translation().z() / ray_R.z() * ray_R;
    column.bearing_rad = std::atan2(p_R.y(), p_R.x());
    column.distance_m = std::hypot(p_R.x(), p_R.y());
  }
}

double NearEdge::distance_m(double bearing_rad) const {
  const Column* best = &columns_.front();
  for (const Column& column : columns_) {
    const double off = std::abs(wrap_rad(column.bearing_rad - bearing_rad));
    if (off < std::abs(wrap_rad(best->bearing_rad - bearing_rad))) best = &column;
  }
  return best->distance_m;
}

}  // namespace mirada::memory
