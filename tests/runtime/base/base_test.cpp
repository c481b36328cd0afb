#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/clock.h"
#include "base/files.h"
#include "base/json_reader.h"
#include "base/messages.h"
#include "base/random.h"

namespace mirada {
namespace {

constexpr Message kGreeting{"greeting", "Hello {name}, {count} times", "Hola {name}, {count} veces"};

TEST(Message, PutsArgumentsIntoEachLanguage) {
  EXPECT_EQ(format(kGreeting, {{"name", "Ana"}, {"count", "2"}}, Lang::en), "Hello Ana, 2 times");
  EXPECT_EQ(format(kGreeting, {{"count", "2"}, {"name", "Ana"}}, Lang::es), "Hola Ana, 2 veces");
}

TEST(Message, AnArgumentThatHoldsBracesIsNotExpandedAgain) {
  EXPECT_EQ(format(kGreeting, {{"name", "{count}"}, {"count", "1"}}, Lang::en), "Hello {count}, 1 times");
}

TEST(NumberText, HasNoTrailingZerosAndNoMinusZero) {
  EXPECT_EQ(number_text(2.5), "2.5");
  EXPECT_EQ(number_text(100), "100");
  EXPECT_EQ(number_text(-0.0001), "0");
}

TEST(WrapRad, StaysInTheHalfOpenCircle) {
  EXPECT_NEAR(wrap_rad(3 * std::numbers::pi), std::numbers::pi, 1e-12);
  EXPECT_NEAR(wrap_rad(-std::numbers::pi), std::numbers::pi, 1e-12);
  EXPECT_NEAR(wrap_rad(7.0), 7.0 - 2 * std::numbers::pi, 1e-12);
}

TEST(WrapRad, TheQuickWayGivesTheSameToTheBit) {
  for (double angle = -11; angle < 11; angle += 0.00037)
    ASSERT_EQ(wrap_rad(angle), wrap_any_rad(angle)) << angle;
  for (const double turns : {-3, -2, -1, 0, 1, 2, 3})
    ASSERT_EQ(wrap_rad(turns * std::numbers::pi), wrap_any_rad(turns * std::numbers::pi)) << turns;
}

TEST(Random, IsTheSameForTheSameSeedAndDiffersBetweenStreams) {
  Random a(7, "wheels");
  Random b(7, "wheels");
  Random other(7, "light");
  const std::uint32_t first = a.next();
  EXPECT_EQ(first, b.next());
  EXPECT_NE(first, other.next());
}

TEST(Random, IntegersCoverTheRangeEvenly) {
  Random random(1, "dice");
  int count[7] = {};
  for (int i = 0; i < 6000; ++i) ++count[random.integer(1, 6)];
  for (int face = 1; face <= 6; ++face) EXPECT_NEAR(count[face], 1000, 130) << face;
  EXPECT_EQ(random.integer(5, 5), 5);
}

TEST(Random, GaussianHasMeanZeroAndUnitDeviation) {
  Random random(3, "noise");
  double sum = 0;
  double squares = 0;
  for (int i = 0; i < 20000; ++i) {
    const double x = random.gaussian();
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / 20000, 0, 0.03);
  EXPECT_NEAR(std::sqrt(squares / 20000), 1, 0.03);
}

TEST(JsonReader, ReportsEveryFaultWithPlaceValueAndRange) {
  const auto json =
      nlohmann::json::parse(R"({"fx": -3, "name": 5, "list": [1, "x"], "kind": "round", "odd": 1})");
  Faults faults;
  JsonReader reader(json, "", faults);
  reader.number("fx", 1, 10000);
  reader.number("fy", 1, 10000);
  reader.text("name");
  reader.numbers("list", 2, 2, 0, 1);
  reader.choice("kind", {"brown", "fisheye"});
  reader.only({"fx", "fy", "name", "list", "kind"});
  ASSERT_EQ(faults.size(), 6u);
  EXPECT_EQ(faults[0].text(Lang::en), "/fx must be a number from 1 to 10000, not -3.");
  EXPECT_EQ(faults[1].code(), "number_missing");
  EXPECT_EQ(faults[2].place, "/name");
  EXPECT_EQ(faults[3].place, "/list/1");
  EXPECT_EQ(faults[4].text(Lang::es), "/kind debe ser uno de brown, fisheye, no \"round\".");
  EXPECT_EQ(faults[5].severity, Severity::warning);
  EXPECT_TRUE(has_errors(faults));
}

TEST(JsonReader, SurvivesWhatIsNoObject) {
  const auto json = nlohmann::json::parse("[1, 2]");
  Faults faults;
  JsonReader reader(json, "", faults);
  EXPECT_EQ(reader.number("fx", 1, 2), 1);
  EXPECT_EQ(faults.size(), 2u);
}

TEST(ParseJson, SaysWhereItBreaks) {
  const auto broken = parse_json("{\"a\": ", "robot.json");
  ASSERT_FALSE(broken);
  EXPECT_EQ(broken.faults().front().code(), "json_broken");
  EXPECT_EQ(broken.faults().front().place, "robot.json");
}

class Files : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("mirada-files-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path folder_;
};

TEST_F(Files, AreWrittenWholeOrNotAtAll) {
  const auto path = folder_ / "a.json";
  ASSERT_TRUE(write_file_atomically(path, "one"));
  ASSERT_TRUE(write_file_atomically(path, "two"));
  EXPECT_EQ(read_file(path).value(), "two");
  EXPECT_FALSE(std::filesystem::exists(path.string() + ".new"));
  ASSERT_TRUE(write_file_atomically(path, "mine", 0600));
  EXPECT_EQ(std::filesystem::status(path).permissions(),
            std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  const Status refused = write_file_atomically(folder_ / "none" / "a.json", "x");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.faults().front().code(), "file_not_written");
}

TEST_F(Files, SayInWordsWhyTheyCannotBeRead) {
  EXPECT_EQ(read_file(folder_ / "missing").faults().front().code(), "file_missing");
  EXPECT_EQ(read_file(folder_).faults().front().code(), "file_is_folder");
  ASSERT_TRUE(write_file_atomically(folder_ / "big", std::string((2 << 20) + 1, 'x')));
  EXPECT_EQ(read_file(folder_ / "big", 1 << 20).faults().front().code(), "file_too_large");
}

TEST(ManualClock, MovesOnlyWhenTold) {
  ManualClock clock;
  EXPECT_EQ(clock.now(), 0);
  clock.advance(5);
  EXPECT_EQ(clock.now(), 5);
}

}  // namespace
}  // namespace mirada
