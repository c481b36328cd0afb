#include "vision/polar_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mirada::vision {
namespace {

using Eigen::Vector2d;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kJumpShare =
    0.12;  // neighbours farther apart than this share of their distance are two things
constexpr double kJump_m = 0.015;
constexpr double kLongestBlind_m =
    0.5;  // farther than this without a look at the floor, "clear" would be a guess

double area(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// How far along the unit vector `ray` from the origin the segment a-b is crossed; NaN when it is not.
/// `slack` is the share of the segment by which it may be missed.
double crossing_m(const Vector2d& ray, const Vector2d& a, const Vector2d& b, double slack) {
  const Vector2d along = b - a;
  const double slant = area(ray, along);
  if (std::abs(slant) < 1e-12) return kNan;
  const double share = area(a, ray) / slant;
  const double distance_m = area(a, along) / slant;
  return share >= -slack && share <= 1 + slack && distance_m > 0 ? distance_m : kNan;
}

bool is_place(Answer answer) { return answer == Answer::blocked || answer == Answer::clear; }

/// The point on `column` as far from its foot as `end` is from its own.
Vector2d beside(const ColumnEnd& end, const ColumnEnd& column) {
  const Vector2d way = column.end_R_m - column.foot_R_m;
  const double length_m = way.norm();
  if (length_m < 1e-9) return column.end_R_m;
  return column.foot_R_m + way * ((end.end_R_m - end.foot_R_m).norm() / length_m);
}

class Sweep {
 public:
  Sweep(const std::vector<ColumnEnd>& columns, double heading_rad, double sigma_heading_rad,
        std::vector<SonarReading>& out)
      : columns_(columns), heading_rad_(heading_rad), sigma_heading_rad_(sigma_heading_rad), out_(out) {}

  void prepare(double half_view_rad);
  void between(const ColumnEnd& left, const ColumnEnd& right);
  void side(const ColumnEnd& edge);

 private:
  double relative_rad(const Vector2d& p) const { return wrap_rad(std::atan2(p.y(), p.x()) - heading_rad_); }
  void offer(SonarReading& reading, Answer answer, double distance_m, double sigma_m);
  void cross_one(SonarReading& reading, const ColumnEnd& left, const ColumnEnd& right);
  void past_edge(const ColumnEnd& left, const ColumnEnd& right);
  void beside_unknown(SonarReading& reading, const ColumnEnd& left, const ColumnEnd& right);
  /// Calls back for every reading whose bearing lies between the two, heading-relative.
  template <class F>
  void for_bearings(double from_rad, double to_rad, F&& f);

  const std::vector<ColumnEnd>& columns_;
  double heading_rad_;
  double sigma_heading_rad_;
  std::vector<SonarReading>& out_;
  double first_rad_ = 0;  ///< heading-relative bearing of out_[0]
};

void Sweep::prepare(double half_view_rad) {
  out_.clear();
  const double first = std::ceil(deg(heading_rad_ - half_view_rad) - 1e-9);
  const double last = std::floor(deg(heading_rad_ + half_view_rad) + 1e-9);
  first_rad_ = rad(first) - heading_rad_;
  for (double bearing_deg = first; bearing_deg <= last; ++bearing_deg) {
    out_.push_back({wrap_rad(rad(bearing_deg)), Answer::not_seen, kNan, kNan});
  }
}

template <class F>
void Sweep::for_bearings(double from_rad, double to_rad, F&& f) {
  const double low = std::min(from_rad, to_rad);
  const double high = std::max(from_rad, to_rad);
  if (high - low > 1.5) return;  // a place beside or behind the lens: no sensible order of bearings
  const int begin = std::max(0, static_cast<int>(std::ceil(deg(low - first_rad_) - 1e-9)));
  const int end = std::min(static_cast<int>(out_.size()) - 1,
                           static_cast<int>(std::floor(deg(high - first_rad_) + 1e-9)));
  for (int i = begin; i <= end; ++i) f(out_[static_cast<std::size_t>(i)]);
}

void Sweep::offer(SonarReading& reading, Answer answer, double distance_m, double sigma_m) {
  if (is_place(answer) && is_place(reading.answer)) {
    if (distance_m >= reading.distance_m) return;
  } else if (is_place(reading.answer)) {
    // Somewhere along a clear bearing something could not be judged: then it is not clear.
    if (reading.answer == Answer::blocked) return;
  } else if (answer == Answer::clear && reading.answer != Answer::not_seen) {
    return;
  }
  reading.answer = answer;
  reading.distance_m = is_place(answer) ? distance_m : kNan;
  reading.sigma_m = is_place(answer) ? sigma_m : kNan;
}

void Sweep::beside_unknown(SonarReading& reading, const ColumnEnd& left, const ColumnEnd& right) {
  const ColumnEnd& known = is_place(left.answer) ? left : right;
  const ColumnEnd& other = is_place(left.answer) ? right : left;
  if (known.answer == Answer::blocked) {
    offer(reading, Answer::blocked, known.end_R_m.norm(), known.sigma_m);
  } else {
    offer(reading, other.answer, 0, 0);
  }
}

void Sweep::cross_one(SonarReading& reading, const ColumnEnd& left, const ColumnEnd& right) {
  const double left_m = left.end_R_m.norm();
  const double right_m = right.end_R_m.norm();
  const Vector2d ray(std::cos(reading.bearing_rad), std::sin(reading.bearing_rad));
  double distance_m = crossing_m(ray, left.end_R_m, right.end_R_m, 1e-3);
  if (std::isnan(distance_m)) distance_m = std::min(left_m, right_m);
  const double turn_rad = std::abs(relative_rad(left.end_R_m) - relative_rad(right.end_R_m));
  const double slope_m = turn_rad > 1e-4 ? std::abs(left_m - right_m) / turn_rad * sigma_heading_rad_ : 0;
  offer(reading, left.answer, distance_m, std::hypot(std::max(left.sigma_m, right.sigma_m), slope_m));
}

/// Up to the nearer thing's side it counts, beyond it what lies farther off: also where that is hidden from
/// the lens but not from the robot's origin.
void Sweep::past_edge(const ColumnEnd& left, const ColumnEnd& right) {
  const bool left_nearer = left.end_R_m.squaredNorm() < right.end_R_m.squaredNorm();
  const ColumnEnd& nearer = left_nearer ? left : right;
  const ColumnEnd& farther = left_nearer ? right : left;
  const double share = left_nearer ? left.edge : 1 - left.edge;
  const Vector2d side = nearer.end_R_m + share * (beside(nearer, farther) - nearer.end_R_m);
  const auto give = [&](const ColumnEnd& end, const Vector2d& to) {
    for_bearings(relative_rad(end.end_R_m), relative_rad(to),
                 [&](SonarReading& reading) { offer(reading, end.answer, end.end_R_m.norm(), end.sigma_m); });
  };
  give(nearer, side);
  if (share >= 1) {
    give(nearer, farther.end_R_m);
  } else {
    give(farther, side);
  }
}

void Sweep::between(const ColumnEnd& left, const ColumnEnd& right) {
  if (is_jump(left, right)) return past_edge(left, right);
  const bool places = is_place(left.answer) && is_place(right.answer);
  for_bearings(relative_rad(left.end_R_m), relative_rad(right.end_R_m), [&](SonarReading& reading) {
    if (places) {
      cross_one(reading, left, right);
    } else {
      beside_unknown(reading, left, right);
    }
  });
}

/// The picture's side: bearings that come in through its foot leave there (clear so far); others only come in
/// there, and what is nearer was not seen.
void Sweep::side(const ColumnEnd& edge) {
  if (!is_place(edge.answer)) return;
  const double low =
      std::min(relative_rad(columns_.front().foot_R_m), relative_rad(columns_.back().foot_R_m));
  const double high =
      std::max(relative_rad(columns_.front().foot_R_m), relative_rad(columns_.back().foot_R_m));
  for_bearings(relative_rad(edge.foot_R_m), relative_rad(edge.end_R_m), [&](SonarReading& reading) {
    const Vector2d ray(std::cos(reading.bearing_rad), std::sin(reading.bearing_rad));
    const double side_m = crossing_m(ray, edge.foot_R_m, edge.end_R_m, 0);
    if (std::isnan(side_m)) return;
    const double relative = wrap_rad(reading.bearing_rad - heading_rad_);
    if (relative >= low - 1e-9 && relative <= high + 1e-9) {
      offer(reading, Answer::clear, side_m, edge.sigma_m);
    } else if (side_m > kLongestBlind_m && reading.answer == Answer::clear) {
      reading.answer = Answer::not_seen;
      reading.distance_m = reading.sigma_m = kNan;
    }
  });
}

}  // namespace

bool is_jump(const ColumnEnd& a, const ColumnEnd& b) {
  if (!is_place(a.answer) || !is_place(b.answer)) return false;
  const double a_m = a.end_R_m.norm();
  const double b_m = b.end_R_m.norm();
  return a.answer != b.answer || std::abs(a_m - b_m) > kJump_m + kJumpShare * std::min(a_m, b_m);
}

void sweep(const std::vector<ColumnEnd>& columns, double heading_rad, double half_view_rad,
           double sigma_heading_rad, std::vector<SonarReading>& out) {
  Sweep work(columns, heading_rad, sigma_heading_rad, out);
  work.prepare(half_view_rad);
  if (columns.empty()) return;
  for (std::size_t i = 0; i + 1 < columns.size(); ++i) work.between(columns[i], columns[i + 1]);
  work.side(columns.front());
  work.side(columns.back());
}

}  // namespace mirada::vision
