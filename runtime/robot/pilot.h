#pragma once
#include <map>
#include <optional>
#include <utility>

#include "memory/corridors.h"
#include "memory/route.h"
#include "robot/motion.h"
#include "robot/watch.h"

namespace mirada::robot {

/// Drives by memory: chooses wheel speeds so that the robot stays, with room to stop, on floor that was
/// looked at and away from what is remembered; the neck keeps an eye on the way meanwhile, unless the program
/// has told it something else. Everything goes through Motion. Control thread.
class Pilot {
 public:
  Pilot(Motion& motion, Watch& watch, const RobotConfig& robot);

  /// Goes on until something else is asked for; asked again by the same block, it just goes on.
  MotionTicket roam(MotionOwner owner);
  MotionTicket follow_wall(MotionOwner owner);
  /// Until it is there (3 cm), or cannot get there.
  MotionTicket go_to(const Eigen::Vector2d& goal_O_m, MotionOwner owner);

  /// One control step, before Motion's.
  void step(Micros now, const memory::VisualMemory& memory);

  double radius_m() const { return radius_m_; }

 private:
  enum class Course { none, roam, wall, go_to };
  struct Wish {
    double bearing_rad = 0;
    double most_mps = 1;
    bool arrived = false;
    bool hopeless = false;
  };

  MotionTicket begin(Course course, MotionOwner owner);
  void leave();
  Wish roam_wish(Micros now, const memory::VisualMemory& memory, const memory::Corridors& ways);
  Wish wall_wish(const memory::VisualMemory& memory, const memory::Corridors& ways);
  Wish goal_wish(Micros now, const memory::VisualMemory& memory, const memory::Corridors& ways);
  void explore(Micros now, const memory::VisualMemory& memory);
  void note_visit(Micros now, const Eigen::Vector2d& p_O_m);
  double freshness(Micros now, const Eigen::Vector2d& p_O_m) const;
  double novelty(Micros now, const memory::VisualMemory& memory, double bearing_rad, double free_m) const;
  double carrot_rad(const memory::VisualMemory& memory, const memory::Corridors& ways) const;
  WheelSpeeds speeds(const Wish& wish, const memory::VisualMemory& memory,
                     const memory::Corridors& ways) const;

  Motion* motion_;
  Watch* watch_;
  DriveConfig drive_;
  bool can_pan_;
  double radius_m_;
  Course course_ = Course::none;
  MotionOwner owner_;
  MotionTicket ticket_ = 0;
  bool watches_ = false;                 ///< the neck was put on the way ahead by the pilot
  std::optional<double> heading_O_rad_;  ///< roam's choice
  Micros chosen_at_ = 0;
  double spin_ = 1;
  int side_ = 0;                                   ///< the wall's: 1 left, -1 right, 0 not chosen
  std::map<std::pair<int, int>, Micros> visited_;  ///< squares in O, and when
  std::optional<Eigen::Vector2d> fresh_O_m_;       ///< where roam is on its way to
  Micros fresh_since_ = 0;
  Eigen::Vector2d goal_O_m_ = Eigen::Vector2d::Zero();
  memory::Route route_;
  Micros routed_at_ = 0;
  double nearest_m_ = 0;
  Micros nearest_at_ = 0;
};

}  // namespace mirada::robot
