#include "memory/attention.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mirada::memory {
namespace {

constexpr double kStep_rad = rad(5);
constexpr double kRim_rad = rad(3);  // the picture's rim is not counted on
constexpr double kOldest_s = 6;
constexpr double kGlance_s =
    0.09;                        // a picture of the new view and its answer, while the way ahead matters most
constexpr double kLook_s = 0.2;  // the same for whoever looks all round: fewer and wider moves
constexpr double kNeedWidth_rad = rad(45);
constexpr double kLeastNeed = 0.12;
constexpr double kFrontHalf_rad = rad(86);
constexpr double kNeedBehind = 0.3;  // whoever drives ahead seldom meets what stands there
constexpr double kNear_m = 0.8;
constexpr double kUsualSpeed_mps = 0.15;
constexpr double kMostLead_rad = rad(50);
constexpr double kLead_s = 0.5;
constexpr double kMustSee_rad = rad(12);
constexpr Micros kMustSeeAge = 450 * kMillisecond;
constexpr double kRolling_mps = 0.03;
constexpr std::array<double, 3> kZones_rad{rad(55), 0, rad(-55)};
constexpr std::array<double, 3> kRanks{1, 2, 1};

double motion_rad(const GazeRange& range) {
  return std::clamp(range.turn_radps * kLead_s, -kMostLead_rad, kMostLead_rad);
}

double within(double pan_rad, const JointConfig& pan) {
  return std::clamp(pan_rad, pan.min_rad, pan.max_rad);
}

/// What a look in one direction is worth.
double worth(const VisualMemory& memory, const GazeRange& range, Watching watching, double bearing_rad) {
  const double age_s = std::min(seconds(memory.look_age(bearing_rad)), kOldest_s);
  const double off_rad = std::abs(wrap_rad(bearing_rad - motion_rad(range)));
  const double share = off_rad / kNeedWidth_rad;
  const bool behind = std::abs(wrap_rad(bearing_rad)) > kFrontHalf_rad;
  const double around = behind ? kNeedBehind : 1;
  const double need = watching == Watching::around ? around : std::max(kLeastNeed, std::exp(-share * share));
  const double speed = std::min(std::abs(range.speed_mps) / kUsualSpeed_mps, 2.0);
  const Direction& known = memory.around().at(bearing_rad);
  const double close = known.answer == Answer::blocked && known.distance_m < kNear_m ? 0.5 : 0;
  const double danger = 1 + speed * std::max(0.0, std::cos(off_rad)) + close;
  return age_s * need * danger;
}

}  // namespace

const char* to_string(Watching watching) {
  switch (watching) {
    case Watching::nothing:
      return "nothing";
    case Watching::ahead:
      return "ahead";
    case Watching::around:
      return "around";
    case Watching::face:
      return "face";
    case Watching::zones:
    case Watching::ranked_zones:
      return "zones";
  }
  return "nothing";
}

void Attention::watch(Watching what) {
  if (what != watching_) zone_ = -1;
  watching_ = what;
}

NextLook Attention::next(const VisualMemory& memory, const GazeRange& range) {
  NextLook out;
  if (watching_ == Watching::zones || watching_ == Watching::ranked_zones) {
    out = zone(memory, range);
  } else if (watching_ == Watching::face && range.face_rad) {
    out.pan_rad = within(*range.face_rad, range.pan);
    out.why = "the_face";
  } else if (watching_ != Watching::nothing) {
    out = best(memory, range);
  }
  out.watching = to_string(watching_);
  return out;
}

NextLook Attention::best(const VisualMemory& memory, const GazeRange& range) const {
  NextLook out;
  const double ahead_rad = within(motion_rad(range), range.pan);
  // Whoever rolls looks where it rolls, whatever else is worth a look.
  if (std::abs(range.speed_mps) > kRolling_mps && memory.look_age(ahead_rad) > kMustSeeAge) {
    out.pan_rad = ahead_rad;
    out.why = "on_the_way";
    return out;
  }
  const double half_rad = std::max(range.half_view_rad - kRim_rad, kStep_rad);
  const int side = static_cast<int>(half_rad / kStep_rad);
  const Watching how = watching_ == Watching::ahead ? Watching::ahead : Watching::around;
  double most = -1;
  bool never = false;
  for (double pan = range.pan.min_rad; pan <= range.pan.max_rad + 1e-9; pan += kStep_rad) {
    double sum = 0;
    bool unseen = false;
    for (int i = -side; i <= side; ++i) {
      const double bearing_rad = pan + i * kStep_rad;
      sum += worth(memory, range, how, bearing_rad);
      unseen = unseen || memory.look_age(bearing_rad) >= VisualMemory::kNeverLooked;
    }
    const double travel_s = std::abs(pan - range.pan_now_rad) / std::max(range.pan.max_radps, 0.1);
    const double rate = sum / (travel_s + (how == Watching::around ? kLook_s : kGlance_s));
    if (rate <= most) continue;
    most = rate;
    never = unseen;
    out.pan_rad = pan;
  }
  const bool front = std::abs(wrap_rad(out.pan_rad - ahead_rad)) < kMustSee_rad;
  out.why = never ? "never_seen" : front && range.speed_mps != 0 ? "on_the_way" : "old";
  return out;
}

NextLook Attention::zone(const VisualMemory& memory, const GazeRange& range) {
  const int before = zone_;
  zone_ = (before + 1) % 3;
  if (watching_ == Watching::ranked_zones) {
    double most = -1;
    for (int i = 0; i < 3; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const double value = kRanks[at] * seconds(memory.look_age(within(kZones_rad[at], range.pan)));
      if (i == before || value <= most) continue;
      most = value;
      zone_ = i;
    }
  }
  NextLook out;
  out.pan_rad = within(kZones_rad[static_cast<std::size_t>(zone_)], range.pan);
  out.why = "its_turn";
  return out;
}

std::vector<double> sweep_stops(const GazeRange& range, double reach_rad) {
  const double view_rad = 2 * std::max(range.half_view_rad - kRim_rad, kStep_rad);
  const auto side = [&](double sign) {
    std::vector<double> out;
    for (double pan = view_rad; pan - view_rad / 2 < reach_rad; pan += view_rad) {
      // The last stop looks no farther than it must.
      const double wanted = std::min(pan, std::max(reach_rad - view_rad / 2 + kRim_rad, view_rad / 2));
      const double stop = within(sign * wanted, range.pan);
      if (out.empty() || std::abs(stop - out.back()) > kStep_rad) out.push_back(stop);
    }
    return out;
  };
  const bool left_first = range.pan_now_rad >= 0;
  std::vector<double> near = side(left_first ? 1 : -1);
  const std::vector<double> far = side(left_first ? -1 : 1);
  std::vector<double> out;
  if (std::abs(range.pan_now_rad) > kRim_rad) {
    // From the side: through it, the middle, and the other.
    std::reverse(near.begin(), near.end());
    out = near;
    out.push_back(within(0, range.pan));
  } else {
    out.push_back(range.pan_now_rad);
    out.insert(out.end(), near.begin(), near.end());
  }
  out.insert(out.end(), far.begin(), far.end());
  return out;
}

}  // namespace mirada::memory
