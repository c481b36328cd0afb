// Learning faces and knowing them again, by block programs in a simulated room.
#include <filesystem>

#include <gtest/gtest.h>

#include "follow_run.h"
#include "rig/lockstep.h"
#include "runtime/rig/program_text.h"
#include "vision/faces/face_net.h"

namespace mirada::scenarios {
namespace {

using namespace rig;

std::string who() { return block({"people_who", "who", text_input("NOBODY", "nobody I know"), ""}); }
std::string say_who(const std::string& next = "") {
  return block({"looks_say", "say", block_input("MESSAGE", who()), ""}, next);
}
std::string learn(const std::string& name, const std::string& next = "") {
  return block({"people_learn", "learn", text_input("NAME", name), ""}, next);
}
std::string looking_up(const std::string& next) {
  return program(flag(block({"looking_tilt_to", "tilt", number_input("ANGLE", "45"), ""}, wait("1", next))));
}

world::WorldConfig room_with(int face) {
  world::WorldConfig room = follow_room({}, 1);
  room.jitter = {0, 0, 0, 0, 0};
  room.people[0].path_m.clear();
  room.people[0].face = face;
  room.people[0].height_m = 0.7;
  world::wear_own_colours(room.people[0]);
  room.people[0].X_WP = {room.X_WR_start.x_m + 0.8, room.X_WR_start.y_m, M_PI};
  return room;
}

session::RunReport run(const std::string& program, int face, std::shared_ptr<vision::FaceBook> book,
                       double seconds = 12, std::function<bool()> stop_asked = {}) {
  LockstepOptions options;
  options.world = room_with(face);
  options.robot = *robot_by_name("mirada-sim");
  options.seed = 2;
  options.seconds = seconds;
  options.book = std::move(book);
  options.stop_asked = std::move(stop_asked);
  return run_lockstep(program, options);
}

std::shared_ptr<vision::FaceBook> open_book() {
  auto book = std::make_shared<vision::FaceBook>();
  EXPECT_TRUE(book->allow(true).ok());
  return book;
}

class Identity : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(vision::FaceNet::default_file()) || vision::face_identity_fallback())
      GTEST_SKIP() << "the models were not fetched";
  }
};

TEST_F(Identity, AFaceIsLearntKnownAgainAndAStrangerIsNot) {
  const auto book = open_book();
  const session::RunReport lesson = run(looking_up(learn("Ana", wait("1.5", say_who()))), 1, book);
  EXPECT_TRUE(lesson.faults.empty());
  ASSERT_EQ(lesson.say.size(), 1u);
  EXPECT_EQ(lesson.say[0].text, "Ana");
  EXPECT_LT(lesson.say[0].t, 9 * kSecond);
  const session::RunReport stranger = run(looking_up(wait("1.5", say_who())), 5, book);
  ASSERT_EQ(stranger.say.size(), 1u);
  EXPECT_EQ(stranger.say[0].text, "nobody I know");
}

TEST_F(Identity, TheSameRunTwiceIsTheSame) {
  const std::string program = looking_up(learn("Ana", wait("1.5", say_who())));
  EXPECT_EQ(run(program, 1, open_book()).hash, run(program, 1, open_book()).hash);
}

TEST_F(Identity, StopInTheMiddleOfALessonKeepsNothing) {
  const auto book = open_book();
  const auto stop = [&] { return book->lesson() && book->lesson()->looks >= 4; };
  const session::RunReport report = run(looking_up(learn("Ana")), 1, book, 12, stop);
  EXPECT_EQ(report.status, session::RunStatus::stopped);
  EXPECT_TRUE(book->people().empty());
  EXPECT_FALSE(book->lesson().has_value());
}

TEST(IdentityOff, TheBlocksSayThatATeacherMustAllowIt) {
  const session::RunReport report = run(looking_up(learn("Ana", say_who())), 1, nullptr, 5);
  ASSERT_EQ(report.faults.size(), 2u);
  for (const vm::BlockFault& fault : report.faults) {
    EXPECT_EQ(fault.fault.code(), "faces_not_allowed");
    EXPECT_EQ(fault.fault.severity, Severity::warning);
  }
  EXPECT_TRUE(report.say.empty());
}

TEST(IdentityOff, ALessonWithNobodyThereEndsInWordsAndLearnsNothing) {
  const auto book = open_book();
  const session::RunReport report = run(program(flag(learn("Ana"))), 1, book, 30);  // looks at the floor
  EXPECT_EQ(report.status, session::RunStatus::finished);
  ASSERT_EQ(report.faults.size(), 1u);
  EXPECT_EQ(report.faults[0].fault.code(), "face_not_learnt");
  EXPECT_TRUE(book->people().empty());
}

}  // namespace
}  // namespace mirada::scenarios
