#include "memory/drift.h"

#include <cmath>
#include <numbers>

namespace mirada::memory {
namespace {

constexpr double kWheelShare = 0.003;
constexpr double kSlip_per_root_m = 0.002;

/// Turned by 90° to the left: where a small turn moves a point.
Eigen::Vector2d across(const Eigen::Vector2d& v) { return {-v.y(), v.x()}; }

}  // namespace

DriftRates drift_rates(const DriveConfig& drive) {
  DriftRates rates;
  rates.track_m = drive.track_m;
  rates.heading_per_m = kWheelShare * std::numbers::sqrt2 / drive.track_m;
  rates.heading_per_root_m = kSlip_per_root_m * std::numbers::sqrt2 / drive.track_m;
  rates.turn_share = kWheelShare;
  rates.length_share = kWheelShare;
  return rates;
}

void DriftLedger::moved(const Pose2& X_OR) {
  const Eigen::Vector2d p(X_OR.x_m, X_OR.y_m);
  if (started_) {
    const Eigen::Vector2d step = p - now_.p_OR_m;
    const Eigen::Vector2d middle = (p + now_.p_OR_m) / 2;
    const double turn = wrap_rad(X_OR.heading_rad - heading_rad_);
    const double towards = heading_rad_ + turn / 2;
    const double way = step.x() * std::cos(towards) + step.y() * std::sin(towards);
    const double half = turn * rates_.track_m / 2;
    const double tyre = (std::abs(way - half) + std::abs(way + half)) / 2;
    now_.way_m += way;
    now_.tyre_m += tyre;
    now_.turned_rad += turn;
    now_.way_moment += way * middle;
    now_.turn_moment += turn * middle;
    now_.tyre_moment += tyre * middle;
    now_.tyre_square += tyre * middle * middle.transpose();
  }
  now_.p_OR_m = p;
  heading_rad_ = X_OR.heading_rad;
  started_ = true;
}

Eigen::Matrix2d DriftLedger::covariance(const DriftMark& then, const Eigen::Vector2d& p_O_m) const {
  const auto squared = [](double rate, const Eigen::Vector2d& v) {
    return Eigen::Matrix2d(rate * rate * v * v.transpose());
  };
  const double way = now_.way_m - then.way_m;
  const double turn = now_.turned_rad - then.turned_rad;
  const double tyre = now_.tyre_m - then.tyre_m;
  Eigen::Matrix2d out =
      squared(rates_.heading_per_m, across(way * p_O_m - (now_.way_moment - then.way_moment)));
  out += squared(rates_.turn_share, across(turn * p_O_m - (now_.turn_moment - then.turn_moment)));
  out += squared(rates_.length_share, now_.p_OR_m - then.p_OR_m);
  const Eigen::Vector2d moment = now_.tyre_moment - then.tyre_moment;
  const Eigen::Matrix2d spread = tyre * p_O_m * p_O_m.transpose() - p_O_m * moment.transpose() -
                                 moment * p_O_m.transpose() + now_.tyre_square - then.tyre_square;
  Eigen::Matrix2d quarter;
  quarter << 0, -1, 1, 0;
  out += rates_.heading_per_root_m * rates_.heading_per_root_m * quarter * spread * quarter.transpose();
  return out;
}

}  // namespace mirada::memory
