#include "vision/exposure_watch.h"

#include <gtest/gtest.h>

#include "model/robot_config.h"

namespace mirada::vision {
namespace {

constexpr int kHorizonRow = 40;
constexpr int kFloor = 120;  // of 255
constexpr int kWall = 180;

/// A camera before a floor and, above the horizon, a wall; the floor has been learnt.
class ExposureOfAPicture : public ::testing::Test {
 protected:
  ExposureOfAPicture() {
    grid_.resize(RobotConfig{}.camera);
    grid_.stand({0, -1, 0});
    spans_.resize(static_cast<std::size_t>(grid_.columns()));
    for (int i = 0; i < grid_.columns(); ++i)
      spans_[static_cast<std::size_t>(i)] = {grid_.bottom_row(i), grid_.top_row(i), kHorizonRow};
    show(kFloor, kWall);
    home_ = looks_like();
    looks_.add(home_, 100);
    watch_.see(grid_, spans_, looks_, home_, home_, true);
  }
  void show(int floor, int wall) {
    picture_.setTo(cv::Scalar::all(wall));
    picture_.rowRange(kHorizonRow, picture_.rows).setTo(cv::Scalar::all(floor));
    grid_.look_at(picture_);
  }
  Look looks_like() const { return grid_.look(grid_.columns() / 2, grid_.rows() - 1); }
  void see(bool same_view) { watch_.see(grid_, spans_, looks_, home_, looks_like(), same_view); }

  cv::Mat picture_ = cv::Mat(240, 320, CV_8UC3);
  PictureGrid grid_;
  std::vector<ColumnSpan> spans_;
  FloorLooks looks_;
  Look home_;
  ExposureWatch watch_;
};

TEST_F(ExposureOfAPicture, AllOfItLighterIsAnotherExposure) {
  show(kFloor * 13 / 10, kWall * 13 / 10);
  see(true);
  EXPECT_EQ(watch_.light(), looks_like().light - home_.light);
  EXPECT_TRUE(watch_.has_changed());
  grid_.expose(watch_.light());
  EXPECT_EQ(looks_like().light, home_.light);
}

TEST_F(ExposureOfAPicture, BelowTheHorizonAloneAThingHasComeIntoTheWay) {
  show(kFloor * 13 / 10, kWall);
  see(true);
  EXPECT_EQ(watch_.light(), 0);
  see(false);  // elsewhere in the room the walls may well be as light
  EXPECT_GT(watch_.light(), 0);
}

TEST_F(ExposureOfAPicture, WhereTheFloorIsStillSeenAsItWasNothingHasChanged) {
  show(kFloor * 13 / 10, kWall * 13 / 10);
  picture_.rowRange(kHorizonRow, 130).setTo(cv::Scalar::all(kFloor));
  see(true);
  EXPECT_FALSE(watch_.has_changed());
}

TEST_F(ExposureOfAPicture, AnotherColourIsAnotherThing) {
  picture_.setTo(cv::Scalar(kFloor, kFloor, kFloor * 14 / 10));
  see(false);
  EXPECT_FALSE(watch_.has_changed());
}

}  // namespace
}  // namespace mirada::vision
