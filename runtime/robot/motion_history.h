#pragma once
#include <deque>

#include "model/geometry.h"

namespace mirada::robot {

/// Where the robot was and where its neck pointed during the last seconds, so that a picture is read with the
/// pose of its exposure and not of its arrival. One thread.
class MotionHistory {
 public:
  struct State {
    Pose2 X_OR;
    NeckAngles neck;
  };

  /// `t` must not go back; the same `t` again replaces.
  void record(Micros t, const State& state);
  /// Linear between two records; the nearest end outside of them; all zero while empty.
  State at(Micros t) const;
  /// Whether neck and robot turned slowly enough around `t` for a picture that is not blurred.
  bool steady(Micros t) const;
  void clear() { samples_.clear(); }

 private:
  struct Sample {
    Micros t;
    State state;
  };
  std::deque<Sample> samples_;
};

}  // namespace mirada::robot
