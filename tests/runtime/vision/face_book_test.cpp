#include "vision/identity/face_book.h"

#include <chrono>
#include <filesystem>
#include <future>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/files.h"
#include "vision/messages.h"

namespace mirada::vision {
namespace {

namespace fs = std::filesystem;

FaceFeature along(std::size_t axis) {
  FaceFeature out(8, 0.F);
  out[axis] = 1;
  return out;
}

class FaceBookTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder = fs::temp_directory_path() / ("mirada-book-" + std::to_string(::getpid()));
    fs::remove_all(folder);
    file = folder / "faces/known.json";
  }
  void TearDown() override { fs::remove_all(folder); }
  std::vector<std::string> names(const FaceBook& book) const {
    std::vector<std::string> out;
    for (const FaceBook::Person& person : book.people()) out.push_back(person.name);
    return out;
  }
  fs::path folder, file;
};

TEST_F(FaceBookTest, IsOffUntilItIsAllowedAndSaysSoAfterARestart) {
  {
    const auto book = FaceBook::open(file).value();
    EXPECT_FALSE(book->allowed());
    EXPECT_FALSE(fs::exists(file));
    ASSERT_TRUE(book->allow(true).ok());
  }
  EXPECT_TRUE(FaceBook::open(file).value()->allowed());
}

TEST_F(FaceBookTest, PeopleAreLearntRenamedAndForgotten) {
  const auto book = FaceBook::open(file).value();
  ASSERT_TRUE(book->learn("Zoe", "a", {along(0)}).ok());
  ASSERT_TRUE(book->learn("Ana", "a", {along(1), along(2)}).ok());
  EXPECT_THAT(names(*book), testing::ElementsAre("Ana", "Zoe"));
  EXPECT_EQ(book->rename("Ana", "Zoe").faults().front().code(), "face_name_taken");
  EXPECT_EQ(book->rename("Eva", "Ada").faults().front().code(), "face_unknown_name");
  EXPECT_EQ(book->rename("Ana", "  ").faults().front().code(), "face_name_bad");
  ASSERT_TRUE(book->rename("Zoe", "Ñandú").ok());
  const auto again = FaceBook::open(file).value();
  EXPECT_EQ(names(*again), names(*book));
  EXPECT_EQ(again->match(along(0), "a").name, "Ñandú");
  ASSERT_TRUE(again->forget("Ana").ok());
  EXPECT_EQ(read_file(file).value().find("Ana"), std::string::npos);
  ASSERT_TRUE(again->forget_all().ok());
  EXPECT_TRUE(FaceBook::open(file).value()->people().empty());
}

TEST_F(FaceBookTest, TheMostAlikeIsTheMatchAndOtherKindsAreNotCompared) {
  FaceBook book;
  ASSERT_TRUE(book.learn("Ana", "a", {along(0)}).ok());
  ASSERT_TRUE(book.learn("Zoe", "a", {along(1)}).ok());
  const FaceFeature mostly_zoe{0.6F, 0.8F, 0, 0, 0, 0, 0, 0};
  const FaceBook::Match match = book.match(mostly_zoe, "a");
  EXPECT_EQ(match.name, "Zoe");
  EXPECT_NEAR(match.likeness, 0.8, 1e-6);
  EXPECT_NEAR(match.next_likeness, 0.6, 1e-6);
  EXPECT_EQ(book.match(mostly_zoe, "b").name, "");
}

TEST_F(FaceBookTest, NoMoreLooksAndPeopleThanItMayHold) {
  FaceBook book;
  ASSERT_TRUE(book.learn("Ana", "a", std::vector<FaceFeature>(30, along(0))).ok());
  EXPECT_EQ(book.people().front().looks, FaceBook::kMostLooks);
  for (std::size_t i = 1; i < FaceBook::kMostPeople; ++i)
    ASSERT_TRUE(book.learn("P" + std::to_string(i), "a", {along(1)}).ok());
  EXPECT_EQ(book.learn("one more", "a", {along(1)}).faults().front().code(), "face_book_full");
}

TEST_F(FaceBookTest, AFileThatCannotBeReadIsAFaultAndStays) {
  fs::create_directories(file.parent_path());
  for (const char* text : {"{", "[]", R"({"format":"mirada-faces","version":7,"people":[]})",
                           R"({"format":"mirada-faces","version":1,"people":[{"name":3}]})"}) {
    ASSERT_TRUE(write_file_atomically(file, text).ok());
    const auto book = FaceBook::open(file);
    ASSERT_FALSE(book.ok()) << text;
    EXPECT_EQ(book.faults().front().code(), "face_book_broken");
    EXPECT_EQ(read_file(file).value(), text);
  }
}

TEST_F(FaceBookTest, ALessonIsKeptOrDroppedAndANewOneTakesItsPlace) {
  FaceBook book;
  ASSERT_TRUE(book.allow(true).ok());
  const auto first = book.begin_lesson("Ana");
  book.teach(first, "a", along(0), &messages::lesson_move);
  EXPECT_EQ(book.lesson()->looks, 1);
  EXPECT_EQ(book.lesson()->name, "Ana");
  ASSERT_TRUE(book.end_lesson(first, false).ok());
  EXPECT_TRUE(book.people().empty());
  const auto second = book.begin_lesson("Ana");
  const auto third = book.begin_lesson("Zoe");
  book.teach(second, "a", along(0), nullptr);
  book.teach(third, "a", along(1), nullptr);
  ASSERT_TRUE(book.end_lesson(second, true).ok());
  ASSERT_TRUE(book.end_lesson(third, true).ok());
  EXPECT_THAT(names(book), testing::ElementsAre("Zoe"));
}

TEST_F(FaceBookTest, ALessonEndsWhenLearningIsSwitchedOff) {
  FaceBook book;
  ASSERT_TRUE(book.allow(true).ok());
  const auto lesson = book.begin_lesson("Ana");
  book.teach(lesson, "a", along(0), nullptr);
  ASSERT_TRUE(book.allow(false).ok());
  EXPECT_FALSE(book.lesson().has_value());
  ASSERT_TRUE(book.end_lesson(lesson, true).ok());
  EXPECT_TRUE(book.people().empty());
}

TEST_F(FaceBookTest, ACopyIsNotWritten) {
  ASSERT_TRUE(FaceBook::open(file).value()->learn("Ana", "a", {along(0)}).ok());
  const auto copy = FaceBook::copy_of(file).value();
  EXPECT_TRUE(copy->allowed());
  ASSERT_TRUE(copy->forget("Ana").ok());
  EXPECT_THAT(names(*FaceBook::open(file).value()), testing::ElementsAre("Ana"));
  EXPECT_TRUE(FaceBook::copy_of(folder / "none.json").value()->people().empty());
}

TEST_F(FaceBookTest, WhatAnotherProgramDoesToTheFileIsNotUndone) {
  const auto one = FaceBook::open(file).value();
  const auto other = FaceBook::open(file).value();
  ASSERT_TRUE(one->learn("Ana", "a", {along(0)}).ok());
  ASSERT_TRUE(other->learn("Zoe", "a", {along(1)}).ok());
  EXPECT_THAT(names(*FaceBook::open(file).value()), testing::ElementsAre("Ana", "Zoe"));
  EXPECT_THAT(names(*other), testing::ElementsAre("Ana", "Zoe"));
  ASSERT_TRUE(one->forget("Zoe").ok());
  ASSERT_TRUE(other->allow(true).ok());
  EXPECT_THAT(names(*FaceBook::open(file).value()), testing::ElementsAre("Ana"));
  // Somebody deleted it, or spoilt it.
  fs::remove(file);
  ASSERT_TRUE(one->learn("Leo", "a", {along(2)}).ok());
  EXPECT_THAT(names(*FaceBook::open(file).value()), testing::ElementsAre("Leo"));
  ASSERT_TRUE(write_file_atomically(file, "{").ok());
  EXPECT_EQ(one->learn("Mia", "a", {along(3)}).faults().front().code(), "face_book_broken");
  EXPECT_EQ(read_file(file).value(), "{");
  EXPECT_THAT(names(*one), testing::ElementsAre("Leo"));
}

TEST_F(FaceBookTest, WhatAnotherProgramDidIsNoticed) {
  auto book = FaceBook::open(file).value();
  const auto other = FaceBook::open(file).value();
  const auto noticed = [&] {
    const std::uint64_t before = book->revision();
    book->notice_changes();
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (book->revision() == before && std::chrono::steady_clock::now() < end) std::this_thread::yield();
  };
  ASSERT_TRUE(other->allow(true).ok());
  noticed();
  EXPECT_TRUE(book->allowed());
  ASSERT_TRUE(other->learn("Ana", "a", {along(0)}).ok());
  noticed();
  EXPECT_THAT(names(*book), testing::ElementsAre("Ana"));
  ASSERT_TRUE(other->forget("Ana").ok());
  noticed();
  EXPECT_TRUE(book->people().empty());
  fs::remove(file);
  noticed();
  EXPECT_FALSE(book->allowed());
}

TEST_F(FaceBookTest, TwoProgramsThatLearnAtOnceLoseNobody) {
  const auto learn = [&](const std::string& prefix) {
    const auto book = FaceBook::open(file).value();
    for (int i = 0; i < 20; ++i) EXPECT_TRUE(book->learn(prefix + std::to_string(i), "a", {along(0)}).ok());
  };
  std::thread one(learn, "A"), other(learn, "B");
  one.join();
  other.join();
  EXPECT_EQ(FaceBook::open(file).value()->people().size(), 40u);
}

TEST_F(FaceBookTest, ANoThatCouldNotBeWrittenHoldsWhenTheFileIsReadAgain) {
  const auto book = FaceBook::open(file).value();
  ASSERT_TRUE(book->allow(true).ok());
  ASSERT_TRUE(book->learn("Ana", "a", {along(0)}).ok());
  ASSERT_TRUE(book->learn("Zoe", "a", {along(1)}).ok());
  const fs::path in_the_way = file.string() + ".new";
  fs::create_directory(in_the_way);
  EXPECT_FALSE(book->allow(false).ok());
  EXPECT_FALSE(book->rename("Ana", "Leo").ok());
  EXPECT_FALSE(book->allowed());
  EXPECT_FALSE(book->forget_all().ok());
  EXPECT_FALSE(book->learn("Mia", "a", {along(2)}).ok());
  EXPECT_TRUE(book->people().empty());
  fs::remove(in_the_way);
  ASSERT_TRUE(book->learn("Mia", "a", {along(2)}).ok());
  const auto again = FaceBook::open(file).value();
  EXPECT_FALSE(again->allowed());
  EXPECT_THAT(names(*again), testing::ElementsAre("Mia"));
}

TEST_F(FaceBookTest, ANoAndForgettingEverybodyHoldThoughTheFileIsSpoilt) {
  const auto book = FaceBook::open(file).value();
  ASSERT_TRUE(book->allow(true).ok());
  ASSERT_TRUE(book->learn("Ana", "a", {along(0)}).ok());
  ASSERT_TRUE(write_file_atomically(file, "{").ok());
  (void)book->begin_lesson("Zoe");
  EXPECT_EQ(book->allow(false).faults().front().code(), "face_book_broken");
  EXPECT_FALSE(book->allowed());
  EXPECT_FALSE(book->lesson());
  EXPECT_FALSE(book->forget_all().ok());
  EXPECT_TRUE(book->people().empty());
  EXPECT_EQ(read_file(file).value(), "{");
}

TEST_F(FaceBookTest, ALessonThatIsKeptWhenTheBookIsClosedIsInTheFile) {
  for (int round = 0; round < 20; ++round) {
    fs::remove(file);
    auto book = FaceBook::open(file).value();
    ASSERT_TRUE(book->allow(true).ok());
    const auto lesson = book->begin_lesson("Ana");
    book->teach(lesson, "a", along(0), nullptr);
    std::future<Status> kept = book->keep_lesson(lesson);
    book.reset();
    ASSERT_EQ(kept.wait_for(std::chrono::seconds(0)), std::future_status::ready);
    EXPECT_TRUE(kept.get().ok());
    EXPECT_THAT(names(*FaceBook::open(file).value()), testing::ElementsAre("Ana"));
  }
}

TEST(FaceBook, NamesAreTextAndNothingElse) {
  EXPECT_TRUE(check_face_name("Zoë 😀"));
  for (const char* bad : {"", "  ", "a\x1b[2J", "a\nb", "\u202Eana", "a\u2028b", "\u061Cb", "a\u0085"})
    EXPECT_FALSE(check_face_name(bad)) << bad;
}

TEST_F(FaceBookTest, AFileWithANameThatWasOnceTakenLoads) {
  fs::create_directories(file.parent_path());
  const Status kept = write_file_atomically(file, R"({"format": "mirada-faces", "version": 1, "allowed": true,
    "people": [{"name": "\u200Fana\t", "kind": "k", "looks": []}]})");
  ASSERT_TRUE(kept.ok());
  const auto book = FaceBook::open(file);
  ASSERT_TRUE(book.ok());
  EXPECT_THAT(names(**book), testing::ElementsAre("ana"));
}

TEST(FaceBook, WhatChangesNothingIsNoChange) {
  FaceBook book;
  ASSERT_TRUE(book.allow(true).ok());
  ASSERT_TRUE(book.learn("Ana", "k", {along(0)}).ok());
  const std::uint64_t before = book.revision();
  EXPECT_TRUE(book.allow(true).ok());
  EXPECT_TRUE(book.rename("Ana", "Ana").ok());
  EXPECT_EQ(book.revision(), before);
  EXPECT_TRUE(book.allow(false).ok());
  EXPECT_GT(book.revision(), before);
}

TEST(FaceBook, ForgettingAndForbiddingHoldAgainstLessonsOnOtherThreads) {
  for (int round = 0; round < 50; ++round) {
    FaceBook book;
    ASSERT_TRUE(book.allow(true).ok());
    const std::uint64_t lesson = book.begin_lesson("Ana");
    book.teach(lesson, "k", along(0), nullptr);
    std::thread keeps([&] { (void)book.end_lesson(lesson, true); });
    std::thread allows([&] { (void)book.allow(true); });
    ASSERT_TRUE(book.allow(false).ok());
    keeps.join();
    allows.join();
    ASSERT_TRUE(book.forget_all().ok());
    EXPECT_TRUE(book.people().empty());
    ASSERT_TRUE(book.allow(false).ok());
    EXPECT_FALSE(book.allowed());
    EXPECT_FALSE(book.lesson());
  }
}

}  // namespace
}  // namespace mirada::vision
