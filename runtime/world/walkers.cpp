#include "world/walkers.h"

#include <algorithm>
#include <cmath>

namespace mirada::world {
namespace {

constexpr double kTurn_radps = 2.5;
constexpr double kPolite_m = 0.25;  // people stop this far from the robot

}  // namespace

Walkers::Walkers(const std::vector<PersonConfig>& people) : people_(people) { reset(); }

void Walkers::reset() {
  poses_.clear();
  for (const PersonConfig& person : people_) poses_.push_back(person.X_WP);
  walks_.assign(people_.size(), Walk{});
}

void Walkers::step(Micros dt, const Pose2& X_WR, double robot_reach_m) {
  for (std::size_t i = 0; i < people_.size(); ++i) {
    const PersonConfig& person = people_[i];
    Pose2& pose = poses_[i];
    const double most = kTurn_radps * seconds(dt);
    const auto turn_to = [&](double heading_rad) {
      const double turn = wrap_rad(heading_rad - pose.heading_rad);
      pose.heading_rad = wrap_rad(pose.heading_rad + std::clamp(turn, -most, most));
      return std::abs(turn);
    };
    const Eigen::Vector2d apart_now(pose.x_m - X_WR.x_m, pose.y_m - X_WR.y_m);
    if (person.watches_robot) turn_to(std::atan2(-apart_now.y(), -apart_now.x()));
    if (person.path_m.empty()) continue;
    const Eigen::Vector2d target = person.path_m[walks_[i].next];
    const Eigen::Vector2d way = target - Eigen::Vector2d(pose.x_m, pose.y_m);
    const double left_m = way.norm();
    if (left_m < 0.01) {
      walks_[i].next = (walks_[i].next + 1) % person.path_m.size();
      continue;
    }
    if (!person.watches_robot && turn_to(std::atan2(way.y(), way.x())) > 0.35) continue;
    const Eigen::Vector2d stride = way / left_m * std::min(left_m, person.speed_mps * seconds(dt));
    const double apart = (apart_now + stride).norm();
    if (apart < robot_reach_m + person.radius_m + kPolite_m && apart < apart_now.norm()) continue;
    pose.x_m += stride.x();
    pose.y_m += stride.y();
  }
}

std::vector<Shape> Walkers::shapes() const {
  std::vector<Shape> out;
  for (std::size_t i = 0; i < people_.size(); ++i) {
    out.push_back({{Eigen::Vector2d(poses_[i].x_m, poses_[i].y_m)}, people_[i].radius_m});
  }
  return out;
}

}  // namespace mirada::world
