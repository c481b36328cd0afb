#pragma once
#include <cstdint>
#include <iosfwd>
#include <string>

#include "world/world_config.h"

namespace mirada::scenarios {

/// What somebody who is followed does.
struct Walk {
  double speed_mps = 0.25;
  bool watches_robot = true;  ///< shows their face all the time, or walks as people do
  bool pillar = false;        ///< passes behind one
  bool poster = false;        ///< a printed face hangs in the room
  bool learnt = false;        ///< the robot learns their face first
};

/// What the truth says of one run of *follow the person at 100 cm*.
struct FollowRun {
  std::uint64_t seed = 0;
  double in_view_share = 0;      ///< of the time: within 10 degrees of the picture's middle
  double at_distance_share = 0;  ///< within 0.8 and 1.2 m
  double both_share = 0;
  double too_near_share = 0, too_far_share = 0;
  double longest_out_s = 0;     ///< longest time that they were not within 10 degrees
  double end_off_m = 0;         ///< distance to them at the end, less the metre
  double longest_poster_s = 0;  ///< longest time that it looked at a poster instead
  int contacts = 0;
  double wall_s = 0;
  std::string status;
  std::string hash;
};

/// The room: a walker who begins a metre before the robot and walks a way by chance.
world::WorldConfig follow_room(const Walk& walk, std::uint64_t seed);
/// The first `settle_s` seconds do not count. `trace`: where a line a tenth of a second goes, as CSV, by the
/// truth: t_s, bearing_deg (off the picture's middle, positive left), away_m, turned_deg (the person, off the
/// robot), pan_deg, heading_deg; null: nowhere.
FollowRun run_follow(const Walk& walk, std::uint64_t seed, double seconds, double settle_s = 6,
                     std::ostream* trace = nullptr);
/// The same walk followed by FollowOracle: what the robot's wheels allow whoever knows everything so late.
FollowRun run_oracle(const Walk& walk, std::uint64_t seed, double seconds, double delay_s,
                     double settle_s = 6);

}  // namespace mirada::scenarios
