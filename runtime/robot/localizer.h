#pragma once
#include <optional>

#include <Eigen/Core>

#include "memory/drift.h"
#include "model/percepts.h"
#include "model/place.h"

namespace mirada::robot {

/// Where the robot is in a place (frame P): odometry, corrected by tags and painted lines whose places are
/// known. An extended Kalman filter over x, y, heading and how much unequal wheels turn it with each metre
/// (Thrun, Burgard and Fox, *Probabilistic Robotics*, 7.4), with a gate: sightings that cannot be true where
/// it believes to be make it say that it is lost, and it starts again from the tags that it sees. Lines
/// correct a pose that is known; they never give one, since one looks as another. Control thread.
class Localizer {
 public:
  explicit Localizer(const DriveConfig& drive);

  /// Without a place nothing is ever known.
  void know(std::optional<Place> place);
  const std::optional<Place>& place() const { return place_; }
  /// Put down anew: about where the place says that a robot starts, or anywhere. Its wheels are still its
  /// own.
  void put_down(const Pose2& X_OR);

  /// The odometry now, every few centimetres at the latest.
  void moved(const Pose2& X_OR);
  /// Tags as they were seen.
  void see(const ThingsPercept& things);
  /// Painted lines as they were seen.
  void see(const LinesPercept& lines);

  struct Estimate {
    Pose2 X_PR;
    double sigma_m = 0;    ///< of the place, along its worse axis
    double sigma_rad = 0;  ///< of the heading
    bool known = false;    ///< false: the pose says nothing
    bool lost = false;     ///< it was known, and what is seen says otherwise
  };
  Estimate estimate() const;

 private:
  struct Sighting {
    const PlaceTag* tag;
    Eigen::Vector2d p_RT_m;  ///< from where the robot is now
    double distance_m, sigma_m;
    double facing_rad;  ///< the tag's heading in the robot's frame
    bool facing_known;
  };
  std::optional<Sighting> sighting_of(const ThingSeen& thing, const Pose2& X_RS) const;
  bool correct(const Sighting& seen);
  void start_from(const Sighting& seen);
  void doubt(const Sighting& seen);
  void correct(int line, const LineSeen& seen);
  void judge_lines(double fitting_m, double strange_m);

  void stand_at(const Pose2& X_PR, const Eigen::Matrix3d& covariance);
  void change_by(const Eigen::Vector4d& change);

  memory::DriftRates rates_;
  std::optional<Place> place_;
  Pose2 X_OR_;
  bool begun_ = false;
  Pose2 X_PR_;
  double bend_radpm_ = 0;  ///< how much more it turns than the wheels tell, with each metre ahead
  Eigen::Matrix4d covariance_ = Eigen::Matrix4d::Zero();  ///< of x, y, heading and bend
  bool known_ = false;
  bool lost_ = false;
  int agreed_ = 0;     ///< sightings in a row that fitted
  int disagreed_ = 0;  ///< sightings in a row that could not be
  int strange_ = 0;    ///< looks with lines that are on no map, less those with lines that are
  Pose2 X_OR_judged_;  ///< where lines were judged last
};

}  // namespace mirada::robot
