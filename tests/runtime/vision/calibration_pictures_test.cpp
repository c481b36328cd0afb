#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "model/camera_file.h"
#include "vision/calibration/board_finder.h"
#include "vision/calibration/camera_json.h"
#include "vision/calibration/judge.h"
#include "vision/calibration/messages.h"
#include "vision/calibration/picture_set.h"
#include "vision/calibration/solve.h"

namespace mirada::vision {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

// Debian's package opencv-doc: thirteen photographs of a 9x6 board by each camera of a stereo pair.
const std::filesystem::path kPhotographs = "/usr/share/doc/opencv-doc/examples/data";

std::vector<std::filesystem::path> photographs(const std::string& side) {
  std::vector<std::filesystem::path> files;
  for (int i = 1; i <= 14; ++i) {
    if (i != 10) files.push_back(kPhotographs / (side + (i < 10 ? "0" : "") + std::to_string(i) + ".jpg"));
  }
  return files;
}

cv::Mat photograph(const std::string& name) {
  return cv::imread((kPhotographs / name).string(), cv::IMREAD_GRAYSCALE);
}

BoardSpec board_9x6() { return *chessboard_spec("9x6", 25); }

std::string refusal(const cv::Mat& gray, const BoardSpec& board = board_9x6()) {
  auto view = BoardFinder(board).find(gray, "p");
  return view ? "" : to_text(view.faults(), Lang::en);
}

/// A board of so many inner corners drawn in perspective on a grey table.
cv::Mat drawn_board(int columns, int rows) {
  constexpr int kSquare = 60;
  cv::Mat flat((rows + 3) * kSquare, (columns + 3) * kSquare, CV_8UC1, cv::Scalar(240));
  for (int y = 0; y <= rows; ++y) {
    for (int x = y % 2; x <= columns; x += 2) {
      cv::rectangle(flat, {(x + 1) * kSquare, (y + 1) * kSquare, kSquare, kSquare}, 25, cv::FILLED);
    }
  }
  const auto w = static_cast<float>(flat.cols);
  const auto h = static_cast<float>(flat.rows);
  const std::vector<cv::Point2f> from = {{0, 0}, {w, 0}, {w, h}, {0, h}};
  const std::vector<cv::Point2f> to = {{90, 60}, {560, 100}, {530, 400}, {70, 430}};
  cv::Mat out;
  cv::warpPerspective(flat, out, cv::getPerspectiveTransform(from, to), {640, 480}, cv::INTER_AREA,
                      cv::BORDER_CONSTANT, 150);
  cv::GaussianBlur(out, out, {}, 0.8);
  return out;
}

TEST(CalibrateFromPhotographs, BoardsOfAnotherSizeAreRefused) {
  for (const char* wrong : {"8x6", "9x5", "7x6", "10x7"}) {
    const PictureSet set = read_pictures(photographs("left"), *chessboard_spec(wrong, 25));
    EXPECT_THAT(set.views, IsEmpty()) << wrong;
    EXPECT_EQ(set.refused.size(), 13u) << wrong;
  }
}

TEST(CalibrateFromPhotographs, LeftCameraMeetsItsNumbersAndComesBackFromItsFile) {
  PictureSet set = read_pictures(photographs("left"), board_9x6());
  EXPECT_THAT(to_text(set.refused, Lang::en), IsEmpty());
  auto found = solve(std::move(set.views), LensChoice::automatic);
  ASSERT_TRUE(found) << to_text(found.faults(), Lang::en);
  EXPECT_EQ(found->views.size(), 13u);
  EXPECT_LE(found->rms_px, 0.197);
  EXPECT_NEAR(found->camera.fx_px, 532.8, 1);
  EXPECT_EQ(found->camera.lens, CameraModel::Lens::brown);
  EXPECT_THAT(to_text(distrust(*found), Lang::en), IsEmpty());

  Faults warnings;
  const auto read = read_camera_file(camera_json(*found, board_9x6(), "").dump(), "camera.json", &warnings);
  ASSERT_TRUE(read) << to_text(read.faults(), Lang::en);
  EXPECT_THAT(warnings, IsEmpty());
  EXPECT_DOUBLE_EQ(read->fx_px, found->camera.fx_px);
  EXPECT_EQ(read->distortion, found->camera.distortion);
}

TEST(CalibrateFromPhotographs, RightCameraMeetsItsNumbers) {
  PictureSet set = read_pictures(photographs("right"), board_9x6());
  auto found = solve(std::move(set.views), LensChoice::brown);
  ASSERT_TRUE(found) << to_text(found.faults(), Lang::en);
  EXPECT_EQ(found->views.size(), 13u);
  EXPECT_LE(found->rms_px, 0.208);
  EXPECT_NEAR(found->camera.fx_px, 537.4, 1);
}

TEST(CalibrateFromPhotographs, PicturesOfAnotherSizeAndFilesThatAreNoneAreNamed) {
  auto files = photographs("left");
  files.resize(3);
  files.push_back(kPhotographs / "left.jpg");
  files.push_back(kPhotographs / "letter-recognition.data");
  files.push_back(kPhotographs / "none.jpg");
  const PictureSet set = read_pictures(files, board_9x6());
  EXPECT_EQ(set.views.size(), 3u);
  EXPECT_EQ(set.refused.size(), 3u) << "one sentence a picture";
  const std::string text = to_text(set.refused, Lang::en);
  EXPECT_THAT(text, HasSubstr("left.jpg: This picture is 612x459, most are 640x480"));
  EXPECT_THAT(text, HasSubstr("letter-recognition.data: This is no picture"));
  EXPECT_THAT(text, HasSubstr("There is no file"));
}

TEST(BoardFinder, BoardsThatAreCutOffAreRefused) {
  for (const auto& [name, part] : {std::pair<const char*, cv::Rect>{"left01.jpg", {0, 0, 440, 330}},
                                   {"left02.jpg", {230, 100, 400, 300}},
                                   {"left12.jpg", {200, 60, 400, 300}}}) {
    cv::Mat cut;
    cv::resize(photograph(name)(part), cut, {640, 480}, 0, 0, cv::INTER_CUBIC);
    EXPECT_THAT(refusal(cut), HasSubstr("cut off by the picture's edge")) << name;
  }
}

TEST(BoardFinder, BoardsOfAnotherSizeAreCountedAndRefused) {
  EXPECT_EQ(refusal(drawn_board(9, 6)), "");
  EXPECT_THAT(refusal(drawn_board(8, 6)), HasSubstr("I count 8x6 inner corners, not 9x6"));
  EXPECT_THAT(refusal(drawn_board(10, 7)), HasSubstr("I count 10x7 inner corners, not 9x6"));
  EXPECT_THAT(refusal(drawn_board(7, 5)), HasSubstr("I count 7x5"));
  EXPECT_NE(refusal(drawn_board(9, 6), *chessboard_spec("8x5", 25)), "");
}

TEST(BoardFinder, BlurredAndMovedPicturesAreRefused) {
  cv::Mat soft;
  cv::GaussianBlur(photograph("left03.jpg"), soft, {}, 2.5);
  EXPECT_THAT(refusal(soft), HasSubstr("Blurred: an edge is"));
  cv::Mat moved;
  cv::blur(photograph("left04.jpg"), moved, {13, 1});
  EXPECT_THAT(refusal(moved), HasSubstr("Blurred"));
}

TEST(BoardFinder, StripesOfAScreenAreRefusedAndNoiseIsNot) {
  cv::Mat striped = photograph("left07.jpg");
  cv::Mat noisy = striped.clone();
  cv::RNG random(7);
  for (int y = 0; y < striped.rows; ++y) {
    for (int x = 0; x < striped.cols; ++x) {
      const double stripes = 16 * (std::sin(x * 0.9 + y * 0.13) + std::sin(x * 0.21 - y * 0.7));
      striped.at<uchar>(y, x) = cv::saturate_cast<uchar>(striped.at<uchar>(y, x) + stripes);
      noisy.at<uchar>(y, x) = cv::saturate_cast<uchar>(noisy.at<uchar>(y, x) + random.gaussian(5));
    }
  }
  EXPECT_THAT(refusal(striped), HasSubstr("as on a screen"));
  EXPECT_EQ(refusal(noisy), "");
}

TEST(BoardFinder, PicturesWithNothingToSeeGetOneSentence) {
  EXPECT_THAT(refusal(cv::Mat(1, 1, CV_8UC1, cv::Scalar(7))), HasSubstr("1x1 pixels are too few"));
  EXPECT_THAT(refusal(cv::Mat(480, 640, CV_8UC1, cv::Scalar(3))), HasSubstr("black"));
  EXPECT_THAT(refusal(cv::Mat(480, 640, CV_8UC1, cv::Scalar(255))), HasSubstr("white"));
  EXPECT_THAT(refusal(cv::Mat(480, 640, CV_8UC1, cv::Scalar(128))), HasSubstr("all grey"));
  EXPECT_THAT(refusal(photograph("fruits.jpg")), HasSubstr("I see no board"));
}

TEST(BoardFinder, AVeryLargePictureGivesTheSameCorners) {
  const cv::Mat small = photograph("left06.jpg");
  cv::Mat large;
  cv::resize(small, large, {8000, 6000}, 0, 0, cv::INTER_CUBIC);
  const auto a = BoardFinder(board_9x6()).find(small, "small");
  const auto b = BoardFinder(board_9x6()).find(large, "large");
  ASSERT_TRUE(a && b);
  for (std::size_t i = 0; i < a->corners_px.size(); ++i) {
    const cv::Point2f expected = (a->corners_px[i] + cv::Point2f(0.5F, 0.5F)) * 12.5F;
    EXPECT_LT(cv::norm(b->corners_px[i] - expected), 6.25) << i;
  }
}

}  // namespace
}  // namespace mirada::vision
