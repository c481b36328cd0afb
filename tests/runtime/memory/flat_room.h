#pragma once
#include <cmath>
#include <limits>
#include <vector>

#include "base/random.h"
#include "memory/visual_memory.h"

namespace mirada::memory {

/// Round pillars on a floor, looked at by an ideal sonar: what each picture of it would say.
struct FlatRoom {
  struct Pillar {
    double x_m, y_m, radius_m;
  };
  std::vector<Pillar> pillars;
  double range_m = 3;
  double sigma_m = 0.02;

  double distance_m(const Pose2& X_WR, double bearing_rad) const {
    const double angle = X_WR.heading_rad + bearing_rad;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Pillar& pillar : pillars) {
      const double dx = pillar.x_m - X_WR.x_m;
      const double dy = pillar.y_m - X_WR.y_m;
      const double along = dx * std::cos(angle) + dy * std::sin(angle);
      const double off = dy * std::cos(angle) - dx * std::sin(angle);
      const double half_square = pillar.radius_m * pillar.radius_m - off * off;
      if (along > 0 && half_square > 0) nearest = std::min(nearest, along - std::sqrt(half_square));
    }
    return nearest;
  }

  /// The odometry believes that the robot stands at X_OR.
  SonarPercept look(const Pose2& X_WR, const Pose2& X_OR, double pan_deg, Micros t) const {
    SonarPercept out;
    out.frame = static_cast<std::uint64_t>(t) + 1;
    out.t_exposure = t;
    out.neck.pan_rad = rad(pan_deg);
    out.X_OR = X_OR;
    out.floor_model_trusted = true;
    for (double degree = std::ceil(pan_deg - 31); degree <= pan_deg + 31; ++degree) {
      const double distance = distance_m(X_WR, rad(degree));
      const bool blocked = distance < range_m;
      out.readings.push_back(
          {rad(degree), blocked ? Answer::blocked : Answer::clear, blocked ? distance : range_m, sigma_m});
    }
    return out;
  }
  SonarPercept look(const Pose2& X_WR, double pan_deg, Micros t) const {
    return look(X_WR, X_WR, pan_deg, t);
  }
};

inline RobotConfig sim_robot() { return *robot_by_name("mirada-sim"); }

/// Drives the memory's odometry there in small steps, without a look.
inline void roll(VisualMemory& memory, const Pose2& to, Micros until) {
  const Pose2 from = memory.X_OR();
  const Micros start = memory.now();
  constexpr int kSteps = 200;
  for (int i = 1; i <= kSteps; ++i) {
    const double part = i / static_cast<double>(kSteps);
    memory.moved(start + (until - start) * i / kSteps,
                 {from.x_m + part * (to.x_m - from.x_m), from.y_m + part * (to.y_m - from.y_m),
                  from.heading_rad + part * wrap_rad(to.heading_rad - from.heading_rad)});
  }
}

}  // namespace mirada::memory
