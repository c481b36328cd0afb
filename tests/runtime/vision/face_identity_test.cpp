#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "vision/identity/face_describer.h"
#include "vision/identity/face_namer.h"
#include "vision/identity/local_patterns.h"

namespace mirada::vision {
namespace {

// Debian's opencv-doc, which the tests install: two pictures of one person, one of another.
const std::string kPhotographs = "/usr/share/doc/opencv-doc/examples/data/";
struct Shown {
  cv::Mat bgr;
  cv::Rect2d face;
};
/// The picture cut and made larger, with a face in it.
Shown shown(const std::string& name, const cv::Rect& part, const cv::Rect2d& face) {
  constexpr double kLarger = 320.0 / 120;
  Shown out;
  cv::resize(cv::imread(kPhotographs + name)(part), out.bgr, {}, kLarger, kLarger, cv::INTER_CUBIC);
  out.face = {(face.x - part.x) * kLarger, (face.y - part.y) * kLarger, face.width * kLarger,
              face.height * kLarger};
  return out;
}
Shown one() { return shown("basketball1.png", {30, 75, 120, 90}, {71.4, 92, 33.2, 42.3}); }
Shown one_later() { return shown("basketball2.png", {30, 75, 120, 90}, {71.5, 91.7, 33.3, 41.7}); }
Shown other() { return shown("messi5.jpg", {185, 67, 120, 90}, {226, 92, 31, 40}); }

void expect_told_apart(FaceDescriber describer) {
  const auto feature = [&](const Shown& of) { return describer.describe(of.bgr, of.face).value(); };
  const FaceFeature first = feature(one());
  EXPECT_NEAR(likeness(first, first), 1, 1e-5);
  EXPECT_GT(likeness(first, feature(one_later())), describer.same_from()) << describer.kind();
  EXPECT_LT(likeness(first, feature(other())), describer.same_from() - 0.1) << describer.kind();
}

TEST(FaceDescriber, TellsPeopleApartInThePlainWay) { expect_told_apart(FaceDescriber::plain()); }

TEST(FaceDescriber, TellsPeopleApartByTheNetworks) {
  if (face_identity_fallback()) GTEST_SKIP() << "the networks were not fetched";
  ASSERT_EQ(FaceDescriber::open().kind(), "network-1");
  expect_told_apart(FaceDescriber::open());
}

TEST(FaceDescriber, SaysNothingOfFacesTooSmallOrCutOff) {
  FaceDescriber describer = FaceDescriber::plain();
  const Shown face = one();
  EXPECT_FALSE(describer.describe(face.bgr, {100, 100, 15, 18}).has_value());
  EXPECT_FALSE(describer.describe(face.bgr, {-40, 20, 80, 100}).has_value());
  EXPECT_FALSE(describer.describe(cv::Mat(), face.face).has_value());
}

TEST(LocalPatterns, LightChangesNothing) {
  cv::Mat grey(kPatternSide_px, kPatternSide_px, CV_8U), darker;
  cv::RNG(3).fill(grey, cv::RNG::UNIFORM, 60, 200);
  grey.convertTo(darker, -1, 1, -50);
  EXPECT_EQ(local_patterns(grey), local_patterns(darker));
}

/// Somebody whose face stays where it is, picture after picture.
class FaceNamerTest : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(book->allow(true).ok()); }
  FacesPercept look(const Shown& face, int id) {
    FacesPercept seen;
    seen.frame = ++frame;
    seen.t_exposure = static_cast<Micros>(frame) * 200 * kMillisecond;
    FacePercept percept;
    percept.x_px = face.face.x;
    percept.y_px = face.face.y;
    percept.w_px = face.face.width;
    percept.h_px = face.face.height;
    percept.id = id;
    seen.faces.push_back(percept);
    namer.look(face.bgr, seen, true);
    return seen;
  }
  FacesPercept looks(const Shown& face, int id, int count) {
    FacesPercept seen;
    for (int i = 0; i < count; ++i) seen = look(face, id);
    return seen;
  }
  void learn(const Shown& face, int id) {
    const auto lesson = book->begin_lesson("Ana");
    looks(face, id, 20);
    ASSERT_EQ(book->lesson()->looks, FaceBook::kLessonLooks);
    ASSERT_TRUE(book->end_lesson(lesson, true).ok());
  }
  std::shared_ptr<FaceBook> book = std::make_shared<FaceBook>();
  FaceNamer namer{book};
  std::uint64_t frame = 0;
};

TEST_F(FaceNamerTest, LearnsSomebodyKnowsThemAgainAndNobodyElse) {
  learn(one(), 1);
  EXPECT_EQ(look(one_later(), 2).faces[0].familiar, Familiar::unsure);
  const FacePercept again = looks(one_later(), 2, 6).faces[0];
  EXPECT_EQ(again.familiar, Familiar::known);
  EXPECT_EQ(again.name, "Ana");
  const FacePercept stranger = looks(other(), 3, 6).faces[0];
  EXPECT_EQ(stranger.familiar, Familiar::stranger);
  EXPECT_EQ(stranger.name, "");
}

TEST_F(FaceNamerTest, LooksCloselyAtOneFaceAPictureAndSeldomOnceItIsKnown) {
  learn(one(), 1);
  looks(one(), 2, 6);
  int described = 0;
  for (int i = 0; i < 15; ++i) described += look(one(), 2).described;
  EXPECT_LE(described, 2);  // in 3 s
}

TEST_F(FaceNamerTest, WhoStepsInDuringALessonIsNotLearnt) {
  const auto lesson = book->begin_lesson("Ana");
  looks(one(), 1, 4);
  const int before = book->lesson()->looks;
  EXPECT_GT(before, 0);
  looks(other(), 2, 6);
  EXPECT_EQ(book->lesson()->looks, before);
  EXPECT_EQ(book->lesson()->hint->code, "lesson_one_only");
  ASSERT_TRUE(book->end_lesson(lesson, false).ok());
}

TEST_F(FaceNamerTest, AFaceMissedInAPictureOrTwoDoesNotChangeTheAdvice) {
  (void)book->begin_lesson("Ana");
  Shown far = one();
  far.face.width = far.face.height = 18;
  look(far, 1);
  const auto looks_at_nobody = [&] {
    FacesPercept seen;
    seen.frame = ++frame;
    seen.t_exposure = static_cast<Micros>(frame) * 200 * kMillisecond;
    namer.look(far.bgr, seen, true);
    return book->lesson()->hint->code;
  };
  for (int i = 0; i < 3; ++i) EXPECT_EQ(looks_at_nobody(), "lesson_closer");
  EXPECT_EQ(looks_at_nobody(), "lesson_show_face");
}

TEST_F(FaceNamerTest, SwitchedOffItNamesNobodyAndLooksAtNobody) {
  learn(one(), 1);
  ASSERT_TRUE(book->allow(false).ok());
  const FacesPercept seen = looks(one(), 2, 6);
  EXPECT_EQ(seen.faces[0].familiar, Familiar::unsure);
  EXPECT_EQ(seen.described, 0);
}

TEST_F(FaceNamerTest, WhoIsForgottenHasNoNameAtOnce) {
  learn(one(), 1);
  ASSERT_EQ(looks(one(), 2, 6).faces[0].name, "Ana");
  ASSERT_TRUE(book->forget("Ana").ok());
  EXPECT_EQ(look(one(), 2).faces[0].name, "");
}

}  // namespace
}  // namespace mirada::vision
