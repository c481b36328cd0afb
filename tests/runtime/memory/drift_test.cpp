#include "memory/drift.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/random.h"

namespace mirada::memory {
namespace {

struct Wheels {
  double left_share, right_share, slip;
};

/// One way of two straight pieces and a turn, as odometry believes it and as it really was.
struct Journey {
  Pose2 believed;
  Pose2 real;

  void roll(double left_m, double right_m, const Wheels& wheels, Random& chance) {
    constexpr int kSteps = 200;
    const double track_m = 0.15;
    for (int i = 0; i < kSteps; ++i) {
      const double l = left_m / kSteps;
      const double r = right_m / kSteps;
      advance(believed, l, r, track_m);
      const double slip_l = wheels.slip * std::sqrt(std::abs(l)) * chance.gaussian();
      const double slip_r = wheels.slip * std::sqrt(std::abs(r)) * chance.gaussian();
      advance(real, l * (1 + wheels.left_share) + slip_l, r * (1 + wheels.right_share) + slip_r, track_m);
      if (ledger) ledger->moved(believed);
    }
  }
  static void advance(Pose2& pose, double l, double r, double track_m) {
    const double turn = (r - l) / track_m;
    pose = compose(pose, {(l + r) / 2 * std::cos(turn / 2), (l + r) / 2 * std::sin(turn / 2), turn});
  }
  DriftLedger* ledger = nullptr;
};

/// Mean of e' C^-1 e over many robots: 2 when the covariance is right.
TEST(Drift, TheCovarianceFitsWhatWheelsOfThisKindDo) {
  DriveConfig drive;
  const Eigen::Vector2d place(1.2, 0.8);
  double sum = 0;
  constexpr int kRobots = 400;
  for (int i = 0; i < kRobots; ++i) {
    Random chance(static_cast<std::uint64_t>(i), "drift");
    const Wheels wheels{0.003 * chance.gaussian(), 0.003 * chance.gaussian(), 0.002};
    DriftLedger ledger(drift_rates(drive));
    ledger.moved({});
    const DriftMark seen = ledger.now();
    Journey way;
    way.ledger = &ledger;
    way.roll(1.0, 1.0, wheels, chance);
    way.roll(-0.1178, 0.1178, wheels, chance);  // a quarter turn
    way.roll(1.0, 1.0, wheels, chance);
    const Pose2 seen_from_real = compose(inverse(way.real), {place.x(), place.y(), 0});
    const Pose2 where_it_is = compose(way.believed, seen_from_real);
    const Eigen::Vector2d error(where_it_is.x_m - place.x(), where_it_is.y_m - place.y());
    sum += error.dot(ledger.covariance(seen, place).inverse() * error);
  }
  EXPECT_NEAR(sum / kRobots, 2.0, 0.45);
}

TEST(Drift, StandingStillNothingGrows) {
  DriftLedger ledger(drift_rates(DriveConfig{}));
  for (int i = 0; i < 100; ++i) ledger.moved({1, 2, 0.5});
  EXPECT_NEAR(ledger.covariance(ledger.now(), {3, 3}).trace(), 0, 1e-12);
}

}  // namespace
}  // namespace mirada::memory
