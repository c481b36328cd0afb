#pragma once
// The cases of the camera contract: included once in each test program that has cameras.
#include "camera_contract.h"

namespace mirada::hal {

class CameraContract : public testing::TestWithParam<CameraMaker> {
 protected:
  CameraContract() : under_test_(GetParam().make()), camera_(*under_test_.camera) {}
  void next_picture() { under_test_.next_picture(); }
  Micros now() { return under_test_.now(); }

  CameraUnderTest under_test_;
  Camera& camera_;
};

TEST_P(CameraContract, IsOffWhenItIsOpened) { EXPECT_FALSE(camera_.poll()); }

TEST_P(CameraContract, CountsItsPicturesAndStampsThem) {
  camera_.enable(true);
  Micros before = -1;
  for (std::uint64_t number = 1; number <= 3; ++number) {
    next_picture();
    const std::optional<Frame> frame = camera_.poll();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->number, number);
    EXPECT_EQ(frame->bgr.type(), CV_8UC3);
    EXPECT_GT(frame->t_exposure, before);
    EXPECT_LE(frame->t_exposure, now());
    before = frame->t_exposure;
  }
  EXPECT_TRUE(camera_.health());
}

TEST_P(CameraContract, NeverGivesAPictureTwice) {
  camera_.enable(true);
  next_picture();
  EXPECT_TRUE(camera_.poll());
  EXPECT_FALSE(camera_.poll());
}

TEST_P(CameraContract, ASlowReaderGetsTheNewest) {
  camera_.enable(true);
  next_picture();
  const std::optional<Frame> first = camera_.poll();
  for (int i = 0; i < 5; ++i) next_picture();
  const std::optional<Frame> frame = camera_.poll();
  ASSERT_TRUE(first && frame);
  EXPECT_GT(frame->t_exposure, first->t_exposure);
  EXPECT_FALSE(camera_.poll()) << "the older ones are gone";
}

TEST_P(CameraContract, GivesNothingWhileDisabledAndGoesOnAfterwards) {
  camera_.enable(true);
  next_picture();
  const std::optional<Frame> before = camera_.poll();
  next_picture();
  camera_.enable(false);
  EXPECT_FALSE(camera_.poll());
  camera_.enable(true);
  next_picture();
  const std::optional<Frame> after = camera_.poll();
  ASSERT_TRUE(before && after);
  EXPECT_GT(after->number, before->number);
}

TEST_P(CameraContract, PicturesHandedOnAreNotWrittenAgain) {
  camera_.enable(true);
  next_picture();
  const std::optional<Frame> first = camera_.poll();
  ASSERT_TRUE(first);
  const cv::Mat copy = first->bgr.clone();
  for (int i = 0; i < 3; ++i) {
    next_picture();
    (void)camera_.poll();
  }
  EXPECT_EQ(cv::norm(copy, first->bgr, cv::NORM_INF), 0);
}

}  // namespace mirada::hal
