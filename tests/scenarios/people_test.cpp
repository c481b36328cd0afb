#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "base/files.h"
#include "follow_run.h"
#include "rig/lockstep.h"
#include "runtime/rig/program_text.h"
#include "vision/faces/face_net.h"

namespace mirada::scenarios {
namespace {

using namespace rig;

std::string set_variable(const std::string& name, const std::string& reporter, const std::string& next) {
  return block({"data_setvariableto", "set", block_input("VALUE", reporter),
                R"("VARIABLE": {"id": ")" + name + R"(", "name": ")" + name + R"(", "type": ""})"},
               next);
}

std::string face_value(const std::string& n, const std::string& what) {
  return block({"people_face", "face", number_input("N", n), R"("WHAT": ")" + what + "\""});
}

/// Looks up, waits, and keeps what the blocks say of the first face.
std::string ask_program() {
  std::string ask;
  for (const char* what : {"name", "number", "size", "distance", "direction", "x"})
    ask = set_variable(what, face_value("1", what), ask);
  ask = set_variable("second", face_value("2", "distance"), ask);
  ask = set_variable("count", block({"people_count", "count", "", ""}), ask);
  const std::string first =
      flag(block({"looking_tilt_to", "tilt", number_input("ANGLE", "35"), ""}, wait("1", ask)));
  std::string variables;
  for (const char* name : {"name", "number", "size", "distance", "direction", "x", "second", "count"})
    variables += std::string(variables.empty() ? "" : ", ") + R"({"name": ")" + name + R"(", "id": ")" +
                 name + R"(", "type": ""})";
  return R"({"blocks": {"languageVersion": 0, "blocks": [)" + first + R"(]}, "variables": [)" + variables +
         "]}";
}

session::RunReport run(const std::string& program, world::WorldConfig room, double seconds) {
  LockstepOptions options;
  options.world = std::move(room);
  options.robot = *robot_by_name("mirada-sim");
  options.seed = 2;
  options.seconds = seconds;
  options.book = std::make_shared<vision::FaceBook>();
  EXPECT_TRUE(options.book->allow(true).ok());
  return run_lockstep(program, options);
}

world::WorldConfig room_with_somebody(double x_m, double y_m) {
  world::WorldConfig room = follow_room({}, 1);
  room.jitter = {0, 0, 0, 0, 0};
  room.people[0].path_m.clear();
  room.people[0].X_WP = {room.X_WR_start.x_m + x_m, room.X_WR_start.y_m + y_m, std::atan2(-y_m, -x_m)};
  return room;
}

class PeopleWithModel : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(vision::FaceNet::default_file()))
      GTEST_SKIP() << "the model was not fetched";
  }
};

TEST_F(PeopleWithModel, AFaceHasItsDirectionDistanceAndNumber) {
  const session::RunReport report = run(ask_program(), room_with_somebody(1.4, 0.3), 6);
  ASSERT_TRUE(report.faults.empty());
  const auto number = [&](const char* name) { return std::stod(report.variables.at(name).text); };
  EXPECT_EQ(number("count"), 1);
  EXPECT_EQ(number("number"), 1);
  EXPECT_NEAR(number("distance"), 100 * std::hypot(1.4, 0.3), 17);
  EXPECT_NEAR(number("direction"), -12.1, 2.5);
  EXPECT_LT(number("x"), -20);
  EXPECT_GT(number("size"), 15);
  EXPECT_EQ(number("second"), 0);
}

TEST(People, WithNobodyThereEveryValueIsSafe) {
  world::WorldConfig room = room_with_somebody(1.4, 0);
  room.people.clear();
  const session::RunReport report = run(ask_program(), std::move(room), 6);
  ASSERT_TRUE(report.faults.empty());
  for (const char* name : {"count", "number", "size", "distance", "direction", "x", "second"})
    EXPECT_EQ(report.variables.at(name).text, "0") << name;
  EXPECT_EQ(report.variables.at("name").text, "");
}

TEST_F(PeopleWithModel, SaysWhenAFaceAppearsAndWhenItGoes) {
  using namespace rig;
  const auto hat = [](const char* type, const char* words) {
    return block({type, "hat", "", ""}, block({"looks_say", "say", text_input("MESSAGE", words), ""}));
  };
  const std::string look = flag(
      block({"looking_tilt_to", "tilt", number_input("ANGLE", "35"), ""},
            wait("1.5", block({"looking_pan_to", "pan", number_input("ANGLE", "75"), ""}, wait("1.5")))));
  const std::string text = R"({"blocks": {"languageVersion": 0, "blocks": [)" + look + ", " +
                           hat("people_when_appears", "here") + ", " + hat("people_when_goes", "gone") +
                           R"(]}, "variables": []})";
  const session::RunReport report = run(text, room_with_somebody(1.4, 0), 5);
  ASSERT_TRUE(report.faults.empty());
  std::vector<std::string> said;
  for (const auto& line : report.say) said.push_back(line.text);
  EXPECT_EQ(said, (std::vector<std::string>{"here", "gone"}));
}

TEST_F(PeopleWithModel, FollowingTheFaceTurnsWithoutDrivingAndStopEndsIt) {
  using namespace rig;
  const std::string stop = block({"people_stop_following", "stop", "", ""}, wait("1"));
  const std::string text =
      program(flag(block({"looking_tilt_to", "tilt", number_input("ANGLE", "35"), ""},
                         block({"people_follow_face", "follow", "", ""}, wait("4", stop)))));
  const session::RunReport report = run(text, room_with_somebody(1.2, 0.55), 8);
  ASSERT_TRUE(report.faults.empty());
  ASSERT_TRUE(report.robot.has_value());
  EXPECT_LT(report.robot->path_m, 0.05);
  EXPECT_GT(report.robot->heading_deg, 10);
  EXPECT_EQ(report.robot->contacts, 0);
}

}  // namespace
}  // namespace mirada::scenarios
