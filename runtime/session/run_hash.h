#pragma once
#include <memory>
#include <string>
#include <string_view>

#include "model/command.h"
#include "model/percepts.h"

namespace mirada::session {

/// SHA-256 over what a run did, tick by tick, in quantised whole numbers (0.1 mm, 0.0001 rad, 0.1 mm/s):
/// poses, commands, percepts and says, never wall time. One thread.
class RunHash {
 public:
  RunHash();
  ~RunHash();

  void tick(Micros t, const Pose2& X_WR, const NeckAngles& neck, const WheelSpeeds& command);
  /// Only what is new since the last call is taken.
  void percepts(const Percepts& percepts);
  void say(Micros t, std::string_view text);
  /// In lower-case hex. Nothing may be added afterwards.
  std::string finish();

 private:
  struct Impl;
  void number(double value, double unit);
  void bytes(std::string_view text);

  std::unique_ptr<Impl> impl_;
  std::uint64_t sonar_frame_ = 0;
  std::uint64_t faces_frame_ = 0;
  std::uint64_t things_frame_ = 0;
  std::uint64_t lines_frame_ = 0;
};

}  // namespace mirada::session
