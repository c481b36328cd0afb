#include "vision/faces/face_tracker.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/random.h"
#include "vision/faces/face_place.h"

namespace mirada::vision {
namespace {

constexpr Micros kPicture = 50 * kMillisecond;

/// People whose faces are where they are told, seen through mirada-sim's camera.
class FaceTrackerTest : public ::testing::Test {
 protected:
  /// A face at this place of O, as a detector would give it; nothing when it is out of the picture.
  void put(FacesPercept& picture, const Eigen::Vector3d& p_O, double noise_px = 0) {
    const Pose2 p = compose(inverse(X_OR), {p_O.x(), p_O.y(), 0});
    const Eigen::Isometry3d X_RC = robot.X_RC(neck);
    const Eigen::Vector3d p_C = X_RC.inverse() * Eigen::Vector3d(p.x_m, p.y_m, p_O.z());
    const auto pixel = robot.camera.project(p_C);
    if (!pixel || pixel->x() < 0 || pixel->x() > 320 || pixel->y() < 0 || pixel->y() > 240) return;
    const double w = 0.15 * robot.camera.fx_px / p_C.norm();
    const double h = 0.183 * robot.camera.fx_px / p_C.norm();
    const auto jitter = [&] { return noise_px * random.gaussian(); };
    const cv::Rect2d box(pixel->x() + 0.5 - w / 2 + jitter(), pixel->y() + 0.5 - h / 2 + jitter(),
                         w + jitter(), h + jitter());
    picture.faces.push_back(place_face({box, 0.95}, robot.camera, X_RC));
  }
  FacesPercept picture() {
    FacesPercept out;
    out.frame = ++frame;
    out.t_exposure = static_cast<Micros>(frame) * kPicture;
    return out;
  }
  FacesPercept shown(const std::vector<Eigen::Vector3d>& people, double noise_px = 0) {
    FacesPercept out = picture();
    for (const Eigen::Vector3d& p : people) put(out, p, noise_px);
    tracker.follow(out, neck, X_OR);
    return out;
  }

  RobotConfig robot = robot_by_name("mirada-sim").value();
  NeckAngles neck{0, rad(-35)};
  Pose2 X_OR;
  Random random{7, "faces"};
  std::uint64_t frame = 0;
  FaceTracker tracker{robot};
};

TEST_F(FaceTrackerTest, ADistanceComesFromTheSize) {
  for (const double away : {0.5, 1.0, 1.5, 2.5}) {
    FacesPercept seen = picture();
    put(seen, {away, 0.1 * away, 0.2 + 0.35 * away});
    ASSERT_EQ(seen.faces.size(), 1u) << away;
    EXPECT_NEAR(seen.faces[0].distance_m / std::hypot(away, 0.1 * away), 1, 0.08) << away;
    EXPECT_NEAR(seen.faces[0].bearing_rad, std::atan(0.1), 0.02);
    EXPECT_GT(seen.faces[0].sigma_m, 0.05 * away);
  }
}

TEST_F(FaceTrackerTest, TwoPeopleKeepTheirNumbersWhileTheNeckAndTheRobotTurn) {
  int left = 0, right = 0;
  for (int i = 0; i < 40; ++i) {
    neck.pan_rad = rad(12) * std::sin(i * 0.3);
    X_OR = {0.005 * i, 0, rad(10) * std::sin(i * 0.2)};
    const FacesPercept seen = shown({{1.6, 0.35, 1.0}, {1.6, -0.35, 1.1}}, 0.5);
    for (const FacePercept& face : seen.faces) {
      int& expected = face.p_O_m.y() > 0 ? left : right;
      if (expected == 0) expected = face.id;
      EXPECT_EQ(face.id, expected) << i;
    }
  }
  EXPECT_NE(left, 0);
  EXPECT_NE(left, right);
}

TEST_F(FaceTrackerTest, AFaceThatIsLostForAMomentIsPredictedWhereItGoesAndKeepsItsNumber) {
  Eigen::Vector3d person(1.5, -0.4, 1.0);
  int id = 0;
  for (int i = 0; i < 30; ++i) {
    person.y() += 0.3 * seconds(kPicture);
    id = shown({person}, 0.3).faces.at(0).id;
  }
  FacesPercept without;
  for (int i = 0; i < 6; ++i) {
    person.y() += 0.3 * seconds(kPicture);
    without = shown({});
  }
  ASSERT_EQ(without.faces.size(), 1u);
  EXPECT_TRUE(without.faces[0].predicted);
  EXPECT_EQ(without.faces[0].id, id);
  EXPECT_NEAR(without.faces[0].p_O_m.y(), person.y(), 0.05);
  for (int i = 0; i < 20; ++i) {
    person.y() += 0.3 * seconds(kPicture);
    without = shown({});
  }
  EXPECT_TRUE(without.faces.empty());
  EXPECT_EQ(shown({person}).faces.at(0).id, id);
}

TEST_F(FaceTrackerTest, HowHighAFaceIsTellsHowSomebodyComesWhileTheirBoxIsOnlyMovedAlong) {
  Eigen::Vector3d person(1.1, 0, 1.0);
  FacesPercept seen;
  for (int i = 0; i < 40; ++i) seen = shown({person});
  const FacePercept first = seen.faces.at(0);
  for (int i = 0; i < 20; ++i) {
    person.x() += 0.35 * seconds(kPicture);
    seen = picture();
    put(seen, person);
    const FacePercept& now = seen.faces.at(0);
    const double x = now.x_px + (now.w_px - first.w_px) / 2;
    const double y = now.y_px + (now.h_px - first.h_px) / 2;
    seen.faces = {place_face({{x, y, first.w_px, first.h_px}, 0.95}, robot.camera, robot.X_RC(neck))};
    tracker.follow(seen, neck, X_OR, false);
  }
  EXPECT_NEAR(seen.faces.at(0).p_O_m.x(), person.x(), 0.1);
  EXPECT_NEAR(seen.faces.at(0).v_O_mps.x(), 0.35, 0.1);
}

TEST_F(FaceTrackerTest, SomebodySeenByTheirClothesAfterALossIsWhereTheyAreSeen) {
  int id = 0;
  for (int i = 0; i < 10; ++i) id = shown({{1.2, 0, 1.0}}).faces.at(0).id;
  for (int i = 0; i < 120; ++i) shown({});
  FacesPercept seen = picture();
  tracker.follow(seen, neck, X_OR);
  ASSERT_EQ(tracker.lost_ahead(seen, neck, X_OR).size(), 1u);
  tracker.follow_bodies({{id, rad(20), 1.5, 0.8}}, seen, neck, X_OR);
  ASSERT_EQ(seen.bodies.size(), 1u);
  EXPECT_NEAR(seen.bodies[0].p_O_m.x(), 1.5 * std::cos(rad(20)), 0.05);
  EXPECT_LT(seen.bodies[0].v_O_mps.norm(), 0.05);
}

TEST_F(FaceTrackerTest, AFaceAfterFiveSecondsGetsANewNumberThoughTheClothesAreRemembered) {
  int id = 0;
  for (int i = 0; i < 10; ++i) id = shown({{1.2, 0, 1.0}}).faces.at(0).id;
  for (int i = 0; i < 100; ++i) shown({});
  EXPECT_NE(shown({{1.2, 0, 1.0}}).faces.at(0).id, id);
}

TEST_F(FaceTrackerTest, WhereTheClothesEndTellsHowFarABackIs) {
  Eigen::Vector3d person(1.1, 0, 1.0);
  const auto top = [&] {
    return std::atan2(person.z() - 0.16 - robot.X_RC(neck).translation().z(),
                      person.x() - robot.X_RC(neck).translation().x());
  };
  int id = 0;
  for (int i = 0; i < 40; ++i) {
    id = shown({person}).faces.at(0).id;
    tracker.learn_top({id, 0, 0, 0.8, top()}, neck, X_OR);
  }
  FacesPercept seen;
  for (int i = 0; i < 20; ++i) {
    person.x() += 0.3 * seconds(kPicture);
    seen = picture();
    tracker.follow(seen, neck, X_OR);
    tracker.follow_bodies({{id, 0, 0, 0.8, top()}}, seen, neck, X_OR);
  }
  EXPECT_NEAR(seen.bodies.at(0).p_O_m.x(), person.x(), 0.1);
}

TEST_F(FaceTrackerTest, WhoseClothesGoOnAboveThePictureIsNear) {
  const Eigen::Vector3d person(1.1, 0, 1.0);
  int id = 0;
  for (int i = 0; i < 40; ++i) {
    id = shown({person}).faces.at(0).id;
    const double lens_m = robot.X_RC(neck).translation().z();
    tracker.learn_top({id, 0, 0, 0.8, std::atan2(person.z() - 0.16 - lens_m, person.x() - 0.05)}, neck, X_OR);
  }
  FacesPercept seen;
  for (int i = 0; i < 20; ++i) {
    seen = picture();
    tracker.follow(seen, neck, X_OR);
    tracker.follow_bodies({{id, 0, 2, 0.8, std::nullopt, rad(48)}}, seen, neck, X_OR);
  }
  EXPECT_LT(seen.bodies.at(0).p_O_m.x(), 0.65);
}

TEST_F(FaceTrackerTest, WhoCameNearUnseenIsFoundAgainByTheirClothes) {
  Eigen::Vector3d person(1.0, 0, 0.55);
  int id = 0;
  for (int i = 0; i < 16; ++i) {
    id = shown({person}).faces.at(0).id;
    person.x() -= 0.5 * seconds(kPicture);
  }
  FacesPercept seen;
  for (int i = 0; i < 30; ++i) seen = shown({});
  for (int i = 0; i < 10; ++i) {
    seen = picture();
    tracker.follow(seen, neck, X_OR);
    tracker.follow_bodies({{id, 0, 0.6, 0.8}}, seen, neck, X_OR);
  }
  ASSERT_EQ(seen.bodies.size(), 1u);
  EXPECT_NEAR(seen.bodies[0].distance_m, 0.6, 0.1);
}

TEST_F(FaceTrackerTest, AFaceSeenOnceIsNotPredicted) {
  shown({{1.5, 0, 1.0}});
  EXPECT_TRUE(shown({}).faces.empty());
}

TEST_F(FaceTrackerTest, ABodyKeepsSomebodyWhoTurnedAwayAndNeverMakesAFace) {
  Eigen::Vector3d person(1.2, 0, 1.0);
  int id = 0;
  for (int i = 0; i < 10; ++i) id = shown({person}).faces.at(0).id;
  FacesPercept seen;
  for (int i = 0; i < 120; ++i) {
    person.y() += 0.2 * seconds(kPicture);
    seen = picture();
    tracker.follow(seen, neck, X_OR);
    tracker.follow_bodies({{id, std::atan2(person.y(), person.x()), person.head<2>().norm(), 0.8}}, seen,
                          neck, X_OR);
  }
  EXPECT_TRUE(seen.faces.empty());
  ASSERT_EQ(seen.bodies.size(), 1u);
  EXPECT_EQ(seen.bodies[0].id, id);
  EXPECT_NEAR(seen.bodies[0].p_O_m.y(), person.y(), 0.1);
}

}  // namespace
}  // namespace mirada::vision
