#include "vision/face_finder.h"

#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "base/files.h"
#include "vision/faces/face_net.h"
#include "vision/faces/haar_faces.h"

namespace mirada::vision {
namespace {

// Debian's opencv-doc, which the tests install.
const std::string kPhotographs = "/usr/share/doc/opencv-doc/examples/data/";

cv::Mat photograph(const std::string& name, cv::Size size = {320, 240}) {
  cv::Mat out = cv::imread(kPhotographs + name);
  if (out.empty()) return out;
  // Cut to the wanted shape, then scaled.
  const double shape = static_cast<double>(size.width) / size.height;
  const int width = std::min(out.cols, cvRound(out.rows * shape));
  const int height = std::min(out.rows, cvRound(out.cols / shape));
  out = out(cv::Rect((out.cols - width) / 2, 0, width, height)).clone();
  cv::resize(out, out, size, 0, 0, cv::INTER_AREA);
  return out;
}

Frame frame_of(cv::Mat bgr) { return {std::move(bgr), 0, 1}; }

RobotConfig robot() { return robot_by_name("mirada-sim").value(); }

/// A head of this photograph, as wide as asked for, put into another one; where its face is then.
cv::Rect2d put_head(cv::Mat& scene, double face_px, cv::Point at) {
  const cv::Mat player = cv::imread(kPhotographs + "messi5.jpg");
  const cv::Rect head(205, 70, 75, 85);
  const cv::Rect2d face(226 - head.x, 92 - head.y, 31, 40);
  const double scale = face_px / face.width;
  cv::Mat small;
  cv::resize(player(head), small, {}, scale, scale, scale < 1 ? cv::INTER_AREA : cv::INTER_CUBIC);
  small.copyTo(scene(cv::Rect(at, small.size())));
  return {at.x + face.x * scale, at.y + face.y * scale, face.width * scale, face.height * scale};
}

double overlap(const FacePercept& a, const cv::Rect2d& b) {
  const cv::Rect2d box(a.x_px, a.y_px, a.w_px, a.h_px);
  const double both = (box & b).area();
  return both / (box.area() + b.area() - both);
}

class FaceNetTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::error_code error;
    if (!std::filesystem::exists(FaceNet::default_file(), error)) GTEST_SKIP() << "the model was not fetched";
    cv::setNumThreads(1);
    auto opened = FaceFinder::open(robot());
    ASSERT_TRUE(opened.ok());
    finder = std::move(*opened);
  }
  std::unique_ptr<FaceFinder> finder;
};

TEST_F(FaceNetTest, FindsSmallAndLargeFacesWhereTheyAre) {
  for (const double px : {24, 32, 48}) {
    for (const char* name : {"home.jpg", "building.jpg", "fruits.jpg"}) {
      cv::Mat scene = photograph(name);
      const cv::Rect2d face = put_head(scene, px, {150, 60});
      const FacesPercept seen = finder->find(frame_of(scene), {});
      ASSERT_EQ(seen.faces.size(), 1u) << name << " " << px;
      EXPECT_GT(overlap(seen.faces.front(), face), 0.5) << name << " " << px;
      EXPECT_EQ(seen.detector, "ultraface");
    }
  }
}

TEST_F(FaceNetTest, GivesTheSameAnswerTwiceAndInAnySize) {
  cv::Mat scene = photograph("home.jpg");
  const cv::Rect2d face = put_head(scene, 40, {60, 80});
  const FacesPercept once = finder->find(frame_of(scene), {});
  const FacesPercept twice = finder->find(frame_of(scene), {});
  ASSERT_EQ(once.faces.size(), 1u);
  EXPECT_EQ(once.faces.front().x_px, twice.faces.front().x_px);
  EXPECT_EQ(once.faces.front().score, twice.faces.front().score);
  cv::Mat large;
  cv::resize(scene, large, {}, 3, 3, cv::INTER_CUBIC);
  const FacesPercept in_large = finder->find(frame_of(large), {});
  ASSERT_EQ(in_large.faces.size(), 1u);
  const cv::Rect2d there(face.x * 3, face.y * 3, face.width * 3, face.height * 3);
  EXPECT_GT(overlap(in_large.faces.front(), there), 0.5);
}

TEST_F(FaceNetTest, SeesNoFaceWhereThereIsNone) {
  for (const char* name : {"aero1.jpg", "aloeL.jpg", "building.jpg", "home.jpg", "fruits.jpg", "leuvenA.jpg",
                           "stuff.jpg", "board.jpg", "left01.jpg", "apple.jpg", "sudoku.png"}) {
    const cv::Mat scene = photograph(name);
    ASSERT_FALSE(scene.empty()) << name;
    EXPECT_TRUE(finder->find(frame_of(scene), {}).faces.empty()) << name;
  }
}

TEST_F(FaceNetTest, LooksAtPicturesOfAnyShapeAndAtNone) {
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(640, 20), cv::Size(20, 640), cv::Size(640, 360)})
    EXPECT_TRUE(finder->find(frame_of(cv::Mat(size, CV_8UC3, cv::Scalar(90, 90, 90))), {}).faces.empty());
  EXPECT_TRUE(finder->find(frame_of({}), {}).faces.empty());
  EXPECT_TRUE(finder->find(frame_of(cv::Mat(240, 320, CV_8UC1, cv::Scalar(0))), {}).faces.empty());
}

TEST(FaceModel, AFileThatIsNoNetworkIsSaidSo) {
  const std::string file = ::testing::TempDir() + "/no_model.onnx";
  ASSERT_TRUE(write_file_atomically(file, "no network").ok());
  const auto opened = FaceFinder::open(robot(), file);
  ASSERT_FALSE(opened.ok());
  EXPECT_EQ(opened.faults().front().code(), "face_net_broken");
  EXPECT_EQ(check_face_model("/nowhere.onnx").faults().front().code(), "face_net_missing");
  EXPECT_FALSE(face_fallback(file).has_value());
}

TEST(HaarFaces, FindsALargeFaceAndNoneWhereThereIsNone) {
  auto haar = HaarFaces::open();
  ASSERT_TRUE(haar.ok());
  cv::Mat scene = photograph("home.jpg");
  EXPECT_TRUE(haar->find(scene).empty());
  const cv::Rect2d face = put_head(scene, 60, {120, 40});
  const auto seen = haar->find(scene);
  ASSERT_EQ(seen.size(), 1u);
  EXPECT_GT((seen.front().box_px & face).area(), 0.6 * face.area());
}

TEST(HaarFaces, FindsWhatASearchEverywhereFindsAndLooksAtPicturesOfAnyShape) {
  auto textured = HaarFaces::open();
  auto everywhere = HaarFaces::open(HaarFaces::Search::everywhere);
  ASSERT_TRUE(textured.ok() && everywhere.ok());
  for (const char* name : {"home.jpg", "building.jpg", "board.jpg", "fruits.jpg"}) {
    for (const double px : {26.0, 44.0, 80.0}) {
      cv::Mat scene = photograph(name);
      put_head(scene, px, {40, 20});
      ASSERT_EQ(everywhere->find(scene).size(), 1u) << name << " " << px;
      EXPECT_EQ(textured->find(scene).size(), 1u) << name << " " << px;
    }
  }
  // Plain all round, so that only a few squares were asked at first.
  cv::Mat scene = photograph("home.jpg");
  put_head(scene, 24, {84, 20});
  EXPECT_EQ(textured->find(scene).size(), 1u);
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(24, 24), cv::Size(320, 25), cv::Size(100, 200)}) {
    cv::Mat noise(size, CV_8UC3);
    cv::RNG(7).fill(noise, cv::RNG::UNIFORM, 0, 256);
    EXPECT_TRUE(textured->find(noise).empty());
  }
}

/// Which part of a picture the areas for this size hold.
double share_of(TexturedAreas& areas, const cv::Mat& gray, int side_px) {
  areas.look(gray);
  cv::Mat held(gray.size(), CV_8U, cv::Scalar(0));
  for (const cv::Rect& area : areas.of_side(side_px)) held(area) = 1;
  return static_cast<double>(cv::countNonZero(held)) / static_cast<double>(gray.total());
}

TEST(TexturedAreas, LieInThePictureAndHoldAtLeastOneSquare) {
  TexturedAreas areas;
  for (const cv::Size size : {cv::Size(24, 24), cv::Size(321, 25), cv::Size(100, 199), cv::Size(20, 20)}) {
    cv::Mat noise(size, CV_8U);
    cv::RNG(7).fill(noise, cv::RNG::UNIFORM, 0, 256);
    areas.look(noise);
    for (const int side : {20, 24, 37, 199}) {
      const std::vector<cv::Rect> found = areas.of_side(side);
      EXPECT_EQ(found.empty(), side > std::min(size.width, size.height)) << side;
      cv::Rect all;
      for (const cv::Rect& area : found) {
        EXPECT_EQ(area & cv::Rect({}, size), area);
        EXPECT_GE(std::min(area.width, area.height), side);
        all |= area;
      }
      EXPECT_EQ(all, found.empty() ? cv::Rect() : cv::Rect({}, size));
    }
  }
}

TEST(TexturedAreas, LeaveOutWallsAndEdgesAndKeepAFaceInAnyLight) {
  cv::Mat wall(240, 320, CV_8U, cv::Scalar(150));
  wall(cv::Rect(0, 0, 320, 100)) = 220;   // where the ceiling begins
  wall(cv::Rect(90, 100, 40, 140)) = 40;  // a door post
  cv::Mat noise(wall.size(), CV_16S);
  cv::randn(noise, 0, 3);
  cv::add(wall, noise, wall, {}, CV_8U);
  TexturedAreas areas;
  for (const int side : {24, 60}) EXPECT_LT(share_of(areas, wall, side), 0.1) << side;

  cv::Mat scene = photograph("home.jpg"), gray;
  scene.setTo(cv::Scalar::all(150));
  const cv::Rect2d face = put_head(scene, 40, {200, 100});
  cv::cvtColor(scene, gray, cv::COLOR_BGR2GRAY);
  const cv::Mat bright = gray.clone();
  for (const auto& [light, haze] : {std::pair(1.0, 0.0), {0.25, 0.0}, {0.4, 90.0}}) {
    bright.convertTo(gray, -1, light, haze);
    areas.look(gray);
    const auto holds = [&](const cv::Rect& area) {
      return (cv::Rect2d(area) & face).area() > 0.99 * face.area();
    };
    EXPECT_TRUE(std::ranges::any_of(areas.of_side(48), holds)) << light;
    EXPECT_LT(share_of(areas, gray, 48), 0.35) << light;
  }
}

}  // namespace
}  // namespace mirada::vision
