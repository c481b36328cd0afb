#include <filesystem>

#include <gtest/gtest.h>

#include "base/files.h"
#include "follow_run.h"
#include "vision/faces/face_net.h"

namespace mirada::scenarios {
namespace {

/// With the plain cascade faces are found too seldom to follow somebody who walks.
class Follow : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(vision::FaceNet::default_file()))
      GTEST_SKIP() << "the model was not fetched";
  }
};

TEST_F(Follow, StaysWithSomebodyWhoWalks) {
  const FollowRun run = run_follow({0.25, true, false, false, false}, 3, 14);
  EXPECT_EQ(run.contacts, 0);
  EXPECT_GT(run.in_view_share, 0.9);
  EXPECT_LT(std::abs(run.end_off_m), 0.4);
}

}  // namespace
}  // namespace mirada::scenarios
