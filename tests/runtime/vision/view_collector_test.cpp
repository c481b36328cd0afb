#include "vision/calibration/view_collector.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "base/units.h"
#include "vision/tags/tag_picture.h"

namespace mirada::vision {
namespace {

using Verdict = ViewCollector::Verdict;

BoardSpec board_9x6() { return *chessboard_spec("9x6", 25); }

/// The corners of a board held so, as a finder would give them.
BoardView seen(const Eigen::Isometry3d& X_CB, const CameraModel& camera,
               const BoardSpec& board = board_9x6()) {
  BoardView view;
  view.size_px = {camera.width_px, camera.height_px};
  for (int i = 0; i < board.corner_count(); ++i) {
    const cv::Point3f p = board.corner_B_m(i);
    const auto pixel = camera.project(X_CB * Eigen::Vector3d(p.x, p.y, p.z));
    view.corners_px.emplace_back(static_cast<float>(pixel->x()), static_cast<float>(pixel->y()));
    view.corners_B_m.push_back(p);
  }
  return view;
}

TEST(ViewCollector, TakesABoardOnlyWhenItIsHeldStillSomewhereNew) {
  const CameraModel camera;
  ViewCollector collector(board_9x6(), camera);
  const Eigen::Isometry3d here = *pose_for({0.5, 0.5, 0.6, 0, 0}, board_9x6(), camera);
  const Eigen::Isometry3d there = *pose_for({0, 0, 0.5, rad(20), 0}, board_9x6(), camera);
  EXPECT_EQ(collector.look(seen(here, camera), false), Verdict::moving);
  EXPECT_EQ(collector.look(seen(there, camera), false), Verdict::moving);
  EXPECT_EQ(collector.look(seen(there, camera), false), Verdict::taken);
  EXPECT_EQ(collector.look(seen(there, camera), false), Verdict::known);
  collector.look_in_vain();
  EXPECT_EQ(collector.look(seen(here, camera), false), Verdict::moving);
  EXPECT_EQ(collector.look(seen(*pose_for({1, 1, 0.5, 0, 0}, board_9x6(), camera), camera), true),
            Verdict::taken);
  EXPECT_EQ(collector.views().size(), 2u);
}

TEST(ViewCollector, FollowingItsWishesIsEnoughWhateverTheLensAndTheBoard) {
  CameraModel wide;
  wide.width_px = 1280;
  wide.height_px = 720;
  wide.cx_px = 639.5;
  wide.cy_px = 359.5;
  wide.fx_px = wide.fy_px = 420;
  wide.lens = CameraModel::Lens::fisheye;
  CameraModel narrow;
  narrow.fx_px = narrow.fy_px = 420;
  narrow.distortion = {-0.1, 0.02, 0, 0, 0};
  for (const CameraModel& camera : {CameraModel(), wide, narrow}) {
    for (const char* size : {"9x6", "6x9", "4x4"}) {
      const BoardSpec board = *chessboard_spec(size, 30);
      ViewCollector collector(board, camera);
      int wishes = 0;
      while (const auto next = collector.next()) {
        ASSERT_LT(++wishes, 20);
        const auto outline = outline_px(next->X_CB, board, camera);
        ASSERT_FALSE(outline.empty());
        for (const cv::Point2f& p : outline) {
          EXPECT_TRUE(p.x > 0 && p.y > 0 && p.x < static_cast<float>(camera.width_px) &&
                      p.y < static_cast<float>(camera.height_px));
        }
        const std::size_t before = collector.views().size();
        collector.look(seen(next->X_CB, camera, board), true);
        ASSERT_EQ(collector.views().size(), before + 1) << next->words->en;
      }
      EXPECT_TRUE(collector.enough())
          << size << ": " << collector.views().size() << " views, coverage " << collector.coverage().share
          << ", tilt " << deg(collector.tilt_spread_rad());
    }
  }
}

TEST(ViewCollector, APlaceThatCannotBeReachedIsGivenUp) {
  const CameraModel camera;
  ViewCollector collector(board_9x6(), camera);
  const Eigen::Isometry3d elsewhere = *pose_for({1, 1, 0.4, 0, 0}, board_9x6(), camera);
  const Message* first = collector.next()->words;
  for (int i = 0; i < 200 && collector.next()->words == first; ++i) {
    collector.look(seen(elsewhere, camera), false);
  }
  EXPECT_NE(collector.next()->words, first);
}

TEST(BoardHold, IsFoundAgainFromItsCorners) {
  const CameraModel camera;
  const Eigen::Isometry3d X_CB = *pose_for({0.3, 0.6, 0.5, rad(20), rad(-15)}, board_9x6(), camera);
  const auto told = hold_at(X_CB, board_9x6(), camera);
  const auto found = hold_of(seen(X_CB, camera), board_9x6(), camera);
  ASSERT_TRUE(told && found);
  EXPECT_LT((told->middle - found->middle).norm(), 1e-3);
  EXPECT_NEAR(told->size, found->size, 1e-3);
  EXPECT_GT(told->normal_C.dot(found->normal_C), std::cos(rad(0.5)));
}

TEST(TagPicture, EveryFamilysMarksAreFoundAgain) {
  for (const TagFamily family :
       {TagFamily::april_36h11, TagFamily::aruco_4x4, TagFamily::aruco_5x5, TagFamily::aruco_6x6}) {
    TagFinder finder(family);
    for (const int id : {0, 7, 101, 249}) {
      const cv::Mat mark = tag_picture(family, id);
      cv::Mat page(260, 320, CV_8UC1, cv::Scalar(255));
      cv::Mat large;
      cv::resize(mark, large, {160, 160}, 0, 0, cv::INTER_NEAREST);
      large.copyTo(page(cv::Rect(80, 50, 160, 160)));
      const auto found = finder.find(page);
      ASSERT_EQ(found.size(), 1u) << id;
      EXPECT_EQ(found[0].id, id);
    }
  }
}

}  // namespace
}  // namespace mirada::vision
