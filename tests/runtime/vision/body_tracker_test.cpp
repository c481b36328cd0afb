#include "vision/faces/body_tracker.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace mirada::vision {
namespace {

/// Somebody in red before a grey wall, 320 x 240; their face is 40 pixels wide.
cv::Mat somebody(double middle_px) {
  cv::Mat out(240, 320, CV_8UC3, cv::Scalar(190, 190, 190));
  cv::rectangle(out, cv::Rect(static_cast<int>(middle_px) - 32, 90, 64, 150), cv::Scalar(40, 40, 200),
                cv::FILLED);
  return out;
}

FacePercept face_at(double middle_px) {
  FacePercept face{middle_px - 20, 30, 40, 48};
  face.id = 1;
  face.distance_m = 1;
  return face;
}

class BodyTrackerTest : public ::testing::Test {
 protected:
  BodyTrackerTest() {
    for (int i = 0; i < 6; ++i) {
      tracker.look(somebody(160));
      tracker.learn(face_at(160));
    }
  }
  BodyTracker tracker;
};

TEST_F(BodyTrackerTest, TellsWhereTheClothesEnd) {
  tracker.look(somebody(170));
  const auto body = tracker.find(face_at(160));
  ASSERT_TRUE(body);
  ASSERT_TRUE(body->top_px);
  EXPECT_NEAR(*body->top_px, 90, 2);
  EXPECT_NEAR(body->width_px, 64, 4);
}

TEST_F(BodyTrackerTest, ABackInTheShadeIsAsWideAsTheFrontWas) {
  cv::Mat picture = somebody(160);
  cv::rectangle(picture, cv::Rect(128, 90, 40, 150), cv::Scalar(34, 34, 150), cv::FILLED);
  tracker.look(picture);
  const auto body = tracker.find(face_at(160));
  ASSERT_TRUE(body);
  EXPECT_NEAR(body->width_px, 64, 4);
  EXPECT_NEAR(body->box_px.x + body->box_px.width / 2, 160, 4);
}

TEST_F(BodyTrackerTest, IsFoundWhereTheClothesAreAndNotOnlyAtTheHeightThatWasExpected) {
  cv::Mat picture(240, 320, CV_8UC3, cv::Scalar(190, 190, 190));
  cv::rectangle(picture, cv::Rect(128, 120, 64, 70), cv::Scalar(40, 40, 200), cv::FILLED);
  tracker.look(picture);
  FacePercept face = face_at(160);
  face.y_px = -30;
  const auto body = tracker.find(face);
  ASSERT_TRUE(body);
  EXPECT_NEAR(body->width_px, 64, 4);
  ASSERT_TRUE(body->top_px);
  EXPECT_NEAR(*body->top_px, 120, 3);
}

TEST_F(BodyTrackerTest, AFaceInProfileBeforeItsBodyDoesNotTeachTheWallForClothes) {
  for (int i = 0; i < 12; ++i) {
    tracker.look(somebody(160));
    tracker.learn(face_at(112));
  }
  tracker.look(somebody(200));
  const auto body = tracker.find(face_at(180));
  ASSERT_TRUE(body);
  EXPECT_GT(body->likeness, 0.8);
  EXPECT_NEAR(body->width_px, 64, 4);
}

TEST_F(BodyTrackerTest, TellsThatTheClothesGoOnAboveThePicture) {
  cv::Mat picture(240, 320, CV_8UC3, cv::Scalar(190, 190, 190));
  cv::rectangle(picture, cv::Rect(100, 0, 120, 150), cv::Scalar(40, 40, 200), cv::FILLED);
  tracker.look(picture);
  const auto body = tracker.find(face_at(160));
  ASSERT_TRUE(body);
  EXPECT_TRUE(body->goes_above);
  EXPECT_FALSE(body->top_px);
  EXPECT_NEAR(body->width_px, 120, 6);
}

/// A floor in the clothes' own colour from this row on, and the hem of the clothes at the picture's top.
cv::Mat floor_alike(int from_px, int columns) {
  cv::Mat out(240, 320, CV_8UC3, cv::Scalar(190, 190, 190));
  cv::rectangle(out, cv::Rect(160, from_px, columns, 240 - from_px), cv::Scalar(40, 40, 200), cv::FILLED);
  cv::rectangle(out, cv::Rect(128, 0, 64, 30), cv::Scalar(40, 40, 200), cv::FILLED);
  return out;
}

TEST_F(BodyTrackerTest, AFloorInTheirColourIsNotTheyWhenTheyAreAboveThePicture) {
  tracker.look(floor_alike(80, 120));
  FacePercept face = face_at(160);
  face.y_px = -100;
  const auto body = tracker.find(face);
  ASSERT_TRUE(body);
  EXPECT_TRUE(body->goes_above);
  EXPECT_NEAR(body->box_px.x + body->box_px.width / 2, 160, 4);
}

TEST_F(BodyTrackerTest, WhatFillsThePictureFromSideToSideTellsNotWhereTheyAre) {
  tracker.look(cv::Mat(240, 320, CV_8UC3, cv::Scalar(40, 40, 200)));
  EXPECT_FALSE(tracker.find(face_at(160)));
}

TEST_F(BodyTrackerTest, AfterALossItFindsThemAnywhereInThePicture) {
  tracker.look(somebody(40));
  EXPECT_FALSE(tracker.find(face_at(250)));
  const auto body = tracker.find_again(face_at(160));
  ASSERT_TRUE(body);
  EXPECT_NEAR(body->box_px.x + body->box_px.width / 2, 40, 4);
}

TEST_F(BodyTrackerTest, AfterALossItFindsWhoHasGoneTwiceAsFarMeanwhile) {
  cv::Mat picture(240, 320, CV_8UC3, cv::Scalar(190, 190, 190));
  cv::rectangle(picture, cv::Rect(200, 150, 32, 75), cv::Scalar(40, 40, 200), cv::FILLED);
  tracker.look(picture);
  FacePercept face = face_at(160);
  face.age = 2 * kSecond;
  const auto body = tracker.find_again(face);
  ASSERT_TRUE(body);
  EXPECT_NEAR(body->box_px.x + body->box_px.width / 2, 216, 4);
  EXPECT_NEAR(body->width_px, 32, 4);
  EXPECT_NEAR(tracker.distance_m(1, *body), 2, 0.25);
  ASSERT_TRUE(body->top_px);
  EXPECT_NEAR(*body->top_px, 150, 3);
}

TEST_F(BodyTrackerTest, AfterALossSomethingMuchNarrowerOfThatColourIsNotThey) {
  cv::Mat picture(240, 320, CV_8UC3, cv::Scalar(190, 190, 190));
  cv::rectangle(picture, cv::Rect(60, 90, 24, 150), cv::Scalar(40, 40, 200), cv::FILLED);
  tracker.look(picture);
  EXPECT_FALSE(tracker.find_again(face_at(160)));
}

}  // namespace
}  // namespace mirada::vision
