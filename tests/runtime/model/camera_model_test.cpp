#include "model/camera_model.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/random.h"
#include "base/units.h"

namespace mirada {
namespace {

CameraModel plain() {
  CameraModel camera;
  camera.cx_px = 161.3;
  camera.cy_px = 117.8;
  camera.fy_px = 264.1;
  return camera;
}

CameraModel brown_camera() {
  CameraModel camera = plain();
  camera.fx_px = camera.fy_px = 315;
  camera.distortion = {0.0485, -0.1917, -0.0009, -0.0025, -0.2197};
  return camera;
}

CameraModel barrel_camera() {
  CameraModel camera = plain();
  camera.distortion = {-0.31, 0.12, 0.001, -0.0007, -0.02};
  return camera;
}

CameraModel fisheye_camera() {
  CameraModel camera = plain();
  camera.lens = CameraModel::Lens::fisheye;
  camera.fx_px = camera.fy_px = 150;
  camera.distortion = {0.02, -0.013, 0.004, -0.0006, 0};
  return camera;
}

class EveryLens : public ::testing::TestWithParam<CameraModel> {};

TEST_P(EveryLens, UnprojectIsTheExactInverseOfProject) {
  const CameraModel camera = GetParam();
  Random random(7, "camera");
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector2d pixel(random.uniform(0, 319), random.uniform(0, 239));
    const auto ray = camera.unproject(pixel);
    ASSERT_TRUE(ray) << pixel.transpose();
    const auto back = camera.project(*ray * random.uniform(0.05, 20));
    ASSERT_TRUE(back);
    EXPECT_NEAR((*back - pixel).norm(), 0, 1e-7) << pixel.transpose();
  }
}

TEST_P(EveryLens, ProjectThenUnprojectGivesTheRayBack) {
  const CameraModel camera = GetParam();
  Random random(8, "camera");
  int seen = 0;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector3d ray(random.uniform(-0.6, 0.6), random.uniform(-0.45, 0.45), 1);
    const auto pixel = camera.project(ray);
    if (!pixel) continue;
    ++seen;
    const auto back = camera.unproject(*pixel);
    ASSERT_TRUE(back) << ray.transpose();
    EXPECT_NEAR((*back - ray).norm(), 0, 1e-9) << ray.transpose();
  }
  EXPECT_GT(seen, 1500);
}

TEST_P(EveryLens, ASmallerPictureSeesTheSameRays) {
  const CameraModel camera = GetParam();
  const CameraModel half = camera.scaled_to(160, 120);
  for (const double u : {0.0, 40.0, 91.0, 159.0}) {
    const auto small = half.unproject({u, 30});
    const auto large = camera.unproject({2 * u + 0.5, 60.5});
    ASSERT_TRUE(small && large);
    EXPECT_NEAR((*small - *large).norm(), 0, 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Lenses, EveryLens,
                         ::testing::Values(plain(), brown_camera(), barrel_camera(), fisheye_camera()));

TEST(CameraModel, NothingBehindTheCameraIsSeen) {
  EXPECT_FALSE(plain().project({0.1, 0, 0}));
  EXPECT_FALSE(plain().project({0.1, 0, -1}));
}

TEST(CameraModel, AFoldedLensHasNoRayBeyondTheFold) {
  CameraModel camera = plain();
  camera.distortion = {-0.5, 0, 0, 0, 0};  // folds at r = sqrt(2/3): 0.544 normalised
  EXPECT_FALSE(camera.project({0.9, 0, 1}));
  EXPECT_TRUE(camera.project({0.8, 0, 1}));
  EXPECT_FALSE(camera.unproject({camera.cx_px + 0.56 * camera.fx_px, camera.cy_px}));
  EXPECT_TRUE(camera.unproject({camera.cx_px + 0.54 * camera.fx_px, camera.cy_px}));
}

TEST(CameraModel, KnowsItsFieldOfView) {
  CameraModel camera;
  camera.fx_px = 160 / std::tan(rad(31.1));
  EXPECT_NEAR(deg(camera.hfov_rad()), 62.2, 1e-9);
}

}  // namespace
}  // namespace mirada
