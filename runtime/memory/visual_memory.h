#pragma once
#include <array>

#include "memory/surroundings.h"
#include "memory/things.h"

namespace mirada::memory {

/// What the robot has seen around itself lately, kept on odometry: obstacles, floor, and where nothing was
/// looked at. Bounded in size, and in time for each picture and question. One thread.
class VisualMemory {
 public:
  explicit VisualMemory(const RobotConfig& robot);

  /// The odometry now, every few centimetres at the latest.
  void moved(Micros now, const Pose2& X_OR);
  /// A picture's answers, at most a second old. It must not be blurred.
  void observe(const SonarPercept& sonar);
  /// A thing seen from X_OR at `t`.
  void observe(const ThingSeen& thing, const Pose2& X_OR, Micros t);
  void forget();
  /// Whether more is kept than the newest picture shows (it is): only to measure what the memory is worth.
  void remember(bool all) { remembers_ = all; }
  const Things& things() const { return things_; }

  /// From where the robot is now.
  const Surroundings& around() const;
  const ObstaclePoints& points() const { return points_; }
  const FreeFloor& floor() const { return floor_; }
  const DriftLedger& drift() const { return drift_; }
  const Pose2& X_OR() const { return X_OR_; }
  Micros now() const { return now_; }
  /// How long ago the last picture was taken that showed this direction: driving makes it older (4 s a
  /// metre). kNeverLooked at most.
  Micros look_age(double bearing_rad) const;
  static constexpr Micros kNeverLooked = 20 * kSecond;
  /// The exposure of the newest picture that was remembered.
  Micros last_look() const { return last_look_; }
  /// Counts up with each change; the same number, the same content.
  std::uint64_t version() const { return version_; }

  /// Whether a robot this wide can roll straight to `ahead_m` from its origin in this direction: all of that
  /// strip was seen as floor and nothing stands in it.
  bool way_clear(double bearing_rad, double width_m, double ahead_m) const;

 private:
  NearEdge near_;
  DriftLedger drift_;
  ObstaclePoints points_;
  FreeFloor floor_;
  Things things_;
  double body_m_;
  double begins_m_;  ///< a picture that shows floor from here on shows all that matters
  bool remembers_ = true;
  Pose2 X_OR_;
  Micros now_ = 0;
  struct Looked {
    Micros at = 0;
    double tyre_m = 0;
    bool ever = false;
  };
  static constexpr int kLookedBins = 72;
  std::size_t bin(double heading_rad) const;
  void note_looks(const SonarPercept& sonar);

  std::array<Looked, kLookedBins> looked_{};  ///< by heading in O, 5 degrees each
  Micros last_look_ = 0;
  std::uint64_t version_ = 1;
  mutable Surroundings around_;
  mutable std::uint64_t around_version_ = 0;
};

}  // namespace mirada::memory
