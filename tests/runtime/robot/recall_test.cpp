#include "robot/recall.h"

#include <gtest/gtest.h>

#include "robot/motion_history.h"

namespace mirada::robot {
namespace {

SonarPercept seen_around(double middle_deg, Micros t, double blocked_m) {
  SonarPercept sonar;
  sonar.frame = static_cast<std::uint64_t>(t) + 1;
  sonar.t_exposure = t;
  sonar.neck.pan_rad = rad(middle_deg);
  for (double degree = middle_deg - 31; degree <= middle_deg + 31; ++degree)
    sonar.readings.push_back({rad(degree), Answer::blocked, blocked_m, 0.02});
  return sonar;
}

class Recalling : public ::testing::Test {
 protected:
  Recall ask(double bearing_deg) const {
    return recall({sonar_, memory_.X_OR(), memory_.now()}, sonar_.t_exposure, memory_, rad(bearing_deg));
  }
  void see(double middle_deg, Micros t, double blocked_m) {
    memory_.moved(t, {});
    sonar_ = seen_around(middle_deg, t, blocked_m);
    memory_.observe(sonar_);
  }
  memory::VisualMemory memory_{*robot_by_name("mirada-sim")};
  SonarPercept sonar_;
};

TEST_F(Recalling, InViewItIsWhatIsSeenNow) {
  see(0, kSecond, 1.0);
  const Recall ahead = ask(10);
  EXPECT_FALSE(ahead.remembered);
  EXPECT_EQ(ahead.age, 0);
  EXPECT_NEAR(ahead.reading.distance_m, 1.0, 1e-9);
}

TEST_F(Recalling, OutOfViewItIsWhatIsRememberedWithItsAge) {
  see(0, kSecond, 1.0);
  see(70, 3 * kSecond, 0.8);
  const Recall ahead = ask(0);
  EXPECT_TRUE(ahead.remembered);
  EXPECT_EQ(ahead.age, 2 * kSecond);
  EXPECT_EQ(ahead.reading.answer, Answer::blocked);
  EXPECT_NEAR(ahead.reading.distance_m, 1.0, 0.02);
  EXPECT_GT(ahead.reading.sigma_m, 0);
  EXPECT_EQ(ask(-120).reading.answer, Answer::not_seen);
}

TEST_F(Recalling, InViewButNotJudgedIsNotFilledFromMemory) {
  see(0, kSecond, 1.0);
  sonar_.readings[31] = {0, Answer::not_seen, std::nan(""), std::nan("")};
  EXPECT_EQ(ask(0).reading.answer, Answer::not_seen);
}

TEST(Steady, ATurningNeckBlursAndAStillOneDoesNot) {
  MotionHistory history;
  for (int i = 0; i <= 20; ++i) {
    const double pan_rad = i < 10 ? i * 0.05 : 0.5;  // 5 rad/s, then at rest
    history.record(i * 10 * kMillisecond, {{}, {pan_rad, 0}});
  }
  EXPECT_FALSE(history.steady(50 * kMillisecond));
  EXPECT_FALSE(history.steady(105 * kMillisecond));
  EXPECT_TRUE(history.steady(150 * kMillisecond));
}

}  // namespace
}  // namespace mirada::robot
