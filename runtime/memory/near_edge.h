#pragma once
#include <array>

#include "model/robot_config.h"

namespace mirada::memory {

/// The nearest floor that a picture shows, by bearing: nearer than this nothing was looked at. One thread.
class NearEdge {
 public:
  explicit NearEdge(const RobotConfig& robot) : robot_(robot) { aim({}); }

  /// Where the neck points at the exposure.
  void aim(const NeckAngles& neck);
  /// From the robot's origin, m; infinite where no floor is in view.
  double distance_m(double bearing_rad) const;

 private:
  static constexpr int kColumns = 9;
  struct Column {
    double bearing_rad = 0;
    double distance_m = 0;
  };

  RobotConfig robot_;
  NeckAngles neck_{1e9, 0};
  std::array<Column, kColumns> columns_{};
};

}  // namespace mirada::memory
