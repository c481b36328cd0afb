#include "robot/perception.h"

#include <gtest/gtest.h>

#include "doubles.h"
#include "robot/messages.h"

namespace mirada::robot {
namespace {

class PerceptionTest : public ::testing::Test {
 protected:
  Detectors detectors() {
    Detectors out;
    out.sonar = [this](const Frame& frame, const NeckAngles& neck, const Pose2& X_OR) {
      ++sonar_looks;
      SonarPercept percept;
      percept.frame = frame.number;
      percept.t_exposure = frame.t_exposure;
      percept.neck = neck;
      percept.X_OR = X_OR;
      return percept;
    };
    out.faces = [this](const Frame& frame, const NeckAngles&, const Pose2&) -> Result<FacesPercept> {
      ++face_looks;
      if (faces_broken) return make_fault("", messages::no_robot);
      FacesPercept percept;
      percept.frame = frame.number;
      return percept;
    };
    out.lines = [this](const Frame& frame, const NeckAngles&, const Pose2& X_OR) {
      ++line_looks;
      return LinesPercept{frame.number, frame.t_exposure, X_OR, {}};
    };
    return out;
  }

  int line_looks = 0;
  int sonar_looks = 0;
  int face_looks = 0;
  bool faces_broken = false;
  ListCamera camera;
  MotionHistory history;
  LatencyConfig latency;  // sonar 10 ms, faces 80 ms
  Perception perception{&camera, detectors(), latency, Timing::simulated};
};

TEST_F(PerceptionTest, NothingWorksUntilItIsNeeded) {
  camera.offer(1, 0);
  EXPECT_FALSE(perception.step(0, history));
  EXPECT_FALSE(camera.enabled_);
  perception.need({true, false, false});
  EXPECT_TRUE(camera.enabled_);
  EXPECT_TRUE(perception.step(0, history));
  EXPECT_EQ(sonar_looks + face_looks, 0);
  EXPECT_EQ(perception.frame().number, 1u);
  perception.need({});
  EXPECT_FALSE(camera.enabled_);
}

TEST_F(PerceptionTest, AnAnswerComesItsLatencyAfterTheFrame) {
  perception.need({true, true, false});
  camera.offer(1, 0);
  perception.step(30'000, history);
  EXPECT_EQ(perception.percepts()->sonar.frame, 0u);
  perception.step(39'999, history);
  EXPECT_EQ(perception.percepts()->sonar.frame, 0u);
  perception.step(40'000, history);
  EXPECT_EQ(perception.percepts()->sonar.frame, 1u);
}

TEST_F(PerceptionTest, LinesAreLookedForOnlyByWhoAsksWhereItIs) {
  perception.need({.frames = true, .sonar = true});
  camera.offer(1, 0);
  perception.step(30'000, history);
  EXPECT_EQ(line_looks, 0);
  perception.need({.frames = true, .place = true});
  camera.offer(2, 50'000);
  perception.step(80'000, history);
  EXPECT_EQ(line_looks, 1);
  EXPECT_EQ(perception.percepts()->lines.frame, 0u);
  perception.step(90'000, history);
  EXPECT_EQ(perception.percepts()->lines.frame, 2u);
  perception.forget();
  EXPECT_EQ(perception.percepts()->lines.frame, 0u);
}

TEST_F(PerceptionTest, OneFaceAnswerAtATime) {
  perception.need({true, false, true});
  for (int i = 0; i < 4; ++i) {
    camera.offer(static_cast<std::uint64_t>(i + 1), i * 50'000);
    perception.step(i * 50'000, history);
  }
  EXPECT_EQ(face_looks, 2);
  EXPECT_EQ(perception.percepts()->faces.frame, 1u);
}

TEST_F(PerceptionTest, ThePoseIsThatOfTheExposure) {
  history.record(0, {{0, 0, 0}, {0, 0}});
  history.record(100'000, {{1, 0, 0}, {0.5, 0}});
  perception.need({true, true, false});
  camera.offer(1, 50'000);
  perception.step(90'000, history);
  perception.step(100'000, history);
  EXPECT_DOUBLE_EQ(perception.percepts()->sonar.X_OR.x_m, 0.5);
  EXPECT_DOUBLE_EQ(perception.percepts()->sonar.neck.pan_rad, 0.25);
}

TEST_F(PerceptionTest, ASnapshotNeverChanges) {
  perception.need({true, true, false});
  camera.offer(1, 0);
  perception.step(0, history);
  perception.step(10'000, history);
  const auto before = perception.percepts();
  camera.offer(2, 50'000);
  perception.step(50'000, history);
  perception.step(60'000, history);
  EXPECT_EQ(before->sonar.frame, 1u);
  EXPECT_EQ(perception.percepts()->sonar.frame, 2u);
}

TEST_F(PerceptionTest, SaysWhyThereAreNoFaces) {
  faces_broken = true;
  perception.need({true, false, true});
  camera.offer(1, 0);
  perception.step(0, history);
  ASSERT_TRUE(perception.faces_trouble().has_value());
  EXPECT_EQ(perception.faces_trouble()->code(), "faces_unavailable");
}

TEST_F(PerceptionTest, ForgetsWhatItSawElsewhere) {
  perception.need({true, true, false});
  camera.offer(1, 0);
  perception.step(0, history);
  perception.forget();
  perception.step(20'000, history);
  EXPECT_EQ(perception.percepts()->sonar.frame, 0u);
}

TEST(FaceWorker, AnswersOnItsOwnThreadWithTheNewestPicture) {
  const auto caller = std::this_thread::get_id();
  std::atomic<bool> elsewhere{true};
  std::atomic<int> calls{0};
  std::uint64_t last = 0;
  {
    FaceWorker worker([&](const Frame& frame, const NeckAngles&, const Pose2&) -> Result<FacesPercept> {
      if (std::this_thread::get_id() == caller) elsewhere = false;
      FacesPercept percept;
      percept.frame = frame.number;
      ++calls;
      return percept;
    });
    for (std::uint64_t number = 1; number <= 50; ++number) worker.offer({cv::Mat(), 0, number}, {}, {});
    while (last != 50) {
      if (const auto found = worker.take()) last = found->value().frame;
      std::this_thread::yield();
    }
  }
  EXPECT_TRUE(elsewhere);
  EXPECT_LE(calls.load(), 50);
}

}  // namespace
}  // namespace mirada::robot
