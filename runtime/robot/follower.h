#pragma once
#include <deque>
#include <optional>

#include "memory/visual_memory.h"
#include "robot/gaze.h"
#include "robot/motion.h"
#include "robot/watch.h"

namespace mirada::robot {

/// What following does just now.
enum class FollowState {
  idle,       ///< nobody asked for it
  following,  ///< sees the person
  predicted,  ///< does not, and goes by where they were going
  searching,  ///< looks for them
  gone,       ///< has given up: stands and looks ahead, and goes on when a face
              ///< appears
};
const char* to_string(FollowState state);

/// Follows a face: the neck at once, the body after it; with a distance to
/// keep, it drives too, on floor that was looked at or that the person walked
/// on, round what is remembered: obstacles win. Everything goes through Motion
/// and Gaze. Control thread.
class Follower {
 public:
  Follower(Motion& motion, Gaze& gaze, Watch& watch, const RobotConfig& robot);

  /// Goes on until something else is asked for; asked again by the same block,
  /// it just goes on.
  MotionTicket face(MotionOwner owner);
  MotionTicket person(double distance_m, MotionOwner owner);
  void stop();

  /// What step() goes by.
  struct Sight {
    Micros now = 0;
    Pose2 X_OR;
    const FacesPercept* faces = nullptr;  ///< the newest, or null when none is fresh
  };
  /// One control step, before Motion's.
  void step(const Sight& sight, const memory::VisualMemory& memory);

  bool active() const { return mode_ != Mode::none; }
  bool drives() const { return mode_ == Mode::person; }
  FollowState state() const { return state_; }
  /// The number of the face that is followed; 0 = none yet.
  int id() const { return target_ ? target_->id : 0; }

 private:
  static constexpr Micros kPredictFor = 2'200 * kMillisecond;  ///< after the newest sight
  static constexpr double kBackAside_rad = rad(60);            ///< so far off them the body turns to back off
  enum class Mode { none, face, person };
  struct Target {
    int id = 0;
    Eigen::Vector2d p_O_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d v_O_mps = Eigen::Vector2d::Zero();
    double height_m = 0;  ///< above the lens
    Micros t = 0;         ///< the exposure of the newest sight
    bool by_face = true;
    std::string name;  ///< "" = not known
  };

  /// Where it looks for a moment instead of at the person.
  enum class Glance { ahead, low, behind };

  /// Where the person walked or the robot drove, and from when to when they were there.
  struct Crumb {
    Eigen::Vector2d p_O_m;
    Micros since = 0, until = 0;
    bool sure = true;  ///< their face was seen, or it was the robot itself
  };

  MotionTicket begin(Mode mode, double distance_m, MotionOwner owner);
  void leave();
  void look_for_target(const Sight& sight);
  double scale(bool by_face) const;
  void take(const FacePercept& face, const Sight& sight, bool by_face);
  bool may_be_target(const FacePercept& face) const;
  FollowState state_at(Micros now) const;
  Eigen::Vector2d place_at(Micros t) const;
  void move_neck(const Sight& sight, double bearing_rad, double away_m, const memory::VisualMemory& memory);
  bool glance(const Sight& sight, double bearing_rad, const memory::VisualMemory& memory);
  void mind_behind(const Sight& sight, double bearing_rad, double away_m, const memory::VisualMemory& memory);
  WheelSpeeds wheels(const Sight& sight, double bearing_rad, double away_m,
                     const memory::VisualMemory& memory);
  double room_m(const memory::VisualMemory& memory, double bearing_rad) const;
  void measure_range(const Sight& sight, const memory::VisualMemory& memory);
  void note_own_way(const Sight& sight);
  bool walked_on(const Eigen::Vector2d& p_O_m) const;
  bool stood_on(const memory::ObstaclePoint& point) const;
  bool was_the_person(const memory::ObstaclePoint& point) const;
  std::size_t search_look(Micros now) const;
  double search_rad(Micros now, double bearing_rad) const;
  double way_back(const memory::VisualMemory& memory, double bearing_rad, double away_m) const;
  double way_to(const memory::VisualMemory& memory, double bearing_rad, double away_m) const;

  Motion* motion_;
  Gaze* gaze_;
  Watch* watch_;
  RobotConfig robot_;
  double radius_m_;
  double lens_m_;  ///< height of the lens, level
  Mode mode_ = Mode::none;
  double keep_m_ = 0;
  MotionOwner owner_;
  MotionTicket ticket_ = 0;
  FollowState state_ = FollowState::idle;
  std::optional<Target> target_;
  std::deque<Crumb> own_way_;  ///< where the robot itself has been
  double range_scale_ = 1;     ///< what their feet say of the distance by face or clothes
  int measured_ = 0;           ///< times
  std::deque<Crumb> crumbs_;
  std::uint64_t seen_frame_ = 0;
  Micros begun_at_ = 0;  ///< 0: not looked yet
  double begun_heading_rad_ = 0;
  bool turning_ = false;
  bool wants_to_drive_ = false;
  double search_side_ = 1;
  Micros glance_since_ = 0;  ///< 0: not glancing
  Micros glance_settled_ = 0;
  Micros glanced_at_ = 0;
  Glance glance_at_ = Glance::ahead;
  double behind_side_ = 0;  ///< turning to look behind, that far to the left of them; 0: not
  double behind_last_ = 0;
  Micros behind_since_ = 0;
};

}  // namespace mirada::robot
