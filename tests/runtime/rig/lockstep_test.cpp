#include "rig/lockstep.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "program_text.h"

namespace mirada::rig {
namespace {

using session::RunReport;
using session::RunStatus;

LockstepOptions no_world() {
  LockstepOptions options;
  options.robot = robot_by_name("mirada-sim").value();
  options.seconds = 20;
  return options;
}

LockstepOptions in_room(const std::string& room) {
  LockstepOptions options = no_world();
  options.world = world::world_by_name(room).value();
  return options;
}

RunReport run(const std::string& blocks, const LockstepOptions& options = no_world()) {
  return run_lockstep(program(blocks), options);
}

bool has_fault(const RunReport& report, const std::string& stem, const std::string& code) {
  return std::ranges::any_of(report.faults, [&](const vm::BlockFault& fault) {
    return fault.block.starts_with(stem + "#") && fault.fault.code() == code;
  });
}

TEST(Lockstep, DrivesAndTurnsInAChildsWords) {
  const RunReport report = run(flag(drive("forward", "50", turn("right", "90", drive("backward", "20")))));
  EXPECT_EQ(report.status, RunStatus::finished);
  EXPECT_NEAR(report.robot->x_m, 0.5, 0.01);
  EXPECT_NEAR(report.robot->y_m, 0.2, 0.02);
  EXPECT_NEAR(report.robot->heading_deg, -90, 1.5);
  EXPECT_NEAR(report.robot->path_m, 0.7, 0.02);
}

TEST(Lockstep, TheProgramsClockBeginsWithItsFirstBlock) {
  const RunReport report = run(flag(say("a", wait("1", say("b")))));
  ASSERT_EQ(report.say.size(), 2u);
  EXPECT_EQ(report.say[0].t, 0);
  EXPECT_NEAR(seconds(report.say[1].t), 1.0, 0.021);
}

TEST(Lockstep, AFaultEndsItsScriptAndTheOthersGoOn) {
  const std::string infinite = block(
      {"operator_divide", "division", number_input("NUM1", "1") + ", " + number_input("NUM2", "0"), ""});
  const std::string fast = block(
      {"motion_set_speeds", "speeds", block_input("LEFT", infinite) + ", " + number_input("RIGHT", "10"), ""},
      say("never"));
  const RunReport report = run(flag(fast) + "," + flag(wait("0.5", say("still here"))));
  EXPECT_EQ(report.status, RunStatus::faulted);
  EXPECT_TRUE(has_fault(report, "speeds", "number_not_finite"));
  ASSERT_EQ(report.say.size(), 1u);
  EXPECT_EQ(report.say[0].text, "still here");
  EXPECT_EQ(report.robot->path_m, 0);
}

TEST(Lockstep, MoreThanTheWheelsCanDoIsAFault) {
  EXPECT_TRUE(has_fault(run(flag(set_speeds("101", "0", wait("1")))), "speeds", "beyond_limit"));
}

TEST(Lockstep, SetSpeedsEndsWithTheProgramAndSaysWhy) {
  const RunReport report = run(flag(set_speeds("50", "50")));
  EXPECT_EQ(report.status, RunStatus::finished);
  EXPECT_TRUE(has_fault(report, "speeds", "program_ended_moving"));
  EXPECT_EQ(report.robot->path_m, 0);
}

TEST(Lockstep, SetSpeedsGoesOnWhileAnotherScriptLives) {
  const RunReport report = run(flag(set_speeds("50", "50")) + "," + flag(wait("2")));
  EXPECT_GT(report.robot->path_m, 0.25);
  EXPECT_LT(report.robot->path_m, 0.36);
}

TEST(Lockstep, TheNewestMotionWinsAndTheOvertakenBlockEnds) {
  const std::string second = wait("0.5", turn("left", "90", say("turned")));
  const RunReport report = run(flag(drive("forward", "100", say("overtaken"))) + "," + flag(second));
  ASSERT_EQ(report.say.size(), 2u);
  EXPECT_EQ(report.say[0].text, "overtaken");
  EXPECT_NEAR(seconds(report.say[0].t), 0.5, 0.1);
  EXPECT_NEAR(report.robot->heading_deg, 90, 2);
  EXPECT_LT(report.robot->x_m, 0.2);
}

TEST(Lockstep, EndingTheScriptEndsItsMotion) {
  const std::string stop = block({"control_stop", "stop", "", R"("STOP_OPTION": "other scripts in sprite")"});
  const RunReport report = run(flag(drive("forward", "100")) + "," + flag(wait("1", stop)));
  EXPECT_LT(report.robot->path_m, 0.25);
  EXPECT_NEAR(report.simulated_s, 1, 0.1);
}

TEST(Lockstep, TimeIsUpForWhatNeverEnds) {
  LockstepOptions options = no_world();
  options.seconds = 1.5;
  const RunReport report = run(flag(forever(wait("0.1"))), options);
  EXPECT_EQ(report.status, RunStatus::time_up);
  EXPECT_NEAR(report.simulated_s, 1.5, 1e-9);
}

TEST(Lockstep, NobodyIsThereToPressAKey) {
  const std::string key =
      block({"event_whenkeypressed", "key", "", R"("KEY_OPTION": "space")"}, say("never"));
  const RunReport report = run(flag(say("done")) + "," + key);
  EXPECT_EQ(report.status, RunStatus::finished);
  EXPECT_LT(report.simulated_s, 1);
}

TEST(Lockstep, StopEndsIt) {
  LockstepOptions options = no_world();
  int looks = 0;
  options.stop_asked = [&] { return ++looks > 10; };
  EXPECT_EQ(run(flag(forever(wait("0.1"))), options).status, RunStatus::stopped);
}

TEST(Lockstep, AProgramThatCannotStartListsEveryFault) {
  const RunReport report = run(flag(block({"no_such", "x1", "", ""}, block({"nor_this", "x2", "", ""}))));
  EXPECT_EQ(report.status, RunStatus::invalid);
  EXPECT_TRUE(has_fault(report, "x1", "unknown_block"));
  EXPECT_TRUE(has_fault(report, "x2", "unknown_block"));
  EXPECT_FALSE(report.robot.has_value());
}

/// What the program says that says this reporter's value.
std::string said(const std::string& reporter, const std::string& inputs = "",
                 const std::string& fields = "") {
  const std::string value = block({reporter, "reporter", inputs, fields});
  return run(flag(block({"looks_say", "say", block_input("MESSAGE", value), ""}))).say.at(0).text;
}

/// The crate of Sala 1 has the floor's colour in shade: when its side fills the picture it must not pass for
/// floor.
TEST(Lockstep, WhatStoodInTheWayStaysThereWhenTheRobotComesNearer) {
  LockstepOptions options = in_room("sala-1");
  options.world->jitter = {};
  options.world->X_WR_start = {0.56, 0.92, rad(-112)};
  const auto step_and_say = [](const std::string& rest) {
    const std::string clear = block({"vision_way_clear", "clear", number_input("DISTANCE", "60"), ""});
    return drive("forward", "4",
                 wait("0.2", block({"looks_say", "say", block_input("MESSAGE", clear), ""}, rest)));
  };
  std::string steps;
  for (int i = 0; i < 7; ++i) steps = step_and_say(steps);
  const RunReport report = run(flag(steps), options);
  ASSERT_EQ(report.say.size(), 7u);
  for (const session::SaidText& said : report.say) EXPECT_EQ(said.text, "false") << seconds(said.t);
}

TEST(Lockstep, WithoutAWorldNothingIsSeen) {
  EXPECT_EQ(said("vision_obstacle_distance", number_input("ANGLE", "0")), "0");
  EXPECT_EQ(said("vision_how_sure", number_input("ANGLE", "0")), "0");
  EXPECT_EQ(said("vision_nearest_direction"), "180");
  EXPECT_EQ(said("vision_obstacle_seen"), "false");
  EXPECT_EQ(said("vision_way_clear", number_input("DISTANCE", "40")), "false");
  EXPECT_EQ(said("vision_face_seen"), "false");
  EXPECT_EQ(said("vision_face", "", R"("WHAT": "x")"), "0");
}

TEST(Lockstep, LooksWhereItIsToldAsFarAsItCan) {
  const auto look = [](const std::string& degrees) {
    return block(
        {"looking_pan_to", "look", number_input("ANGLE", degrees), ""},
        block({"looks_say", "say", block_input("MESSAGE", block({"looking_pan_angle", "p", "", ""})), ""}));
  };
  EXPECT_EQ(run(flag(look("40"))).say.at(0).text, "40");
  const RunReport far = run(flag(look("-120")));
  EXPECT_EQ(far.say.at(0).text, "-80");
  EXPECT_TRUE(has_fault(far, "look", "pan_clamped"));
  EXPECT_EQ(far.status, RunStatus::finished);
}

TEST(Lockstep, SaysHowSureItIsOfADistanceThatItSees) {
  const std::string sure = block({"vision_how_sure", "sure", number_input("ANGLE", "0"), ""});
  const RunReport report =
      run(flag(block({"looks_say", "say", block_input("MESSAGE", sure), ""})), in_room("sala-1"));
  ASSERT_EQ(report.say.size(), 1u);
  EXPECT_GT(std::stod(report.say[0].text), 20);
  EXPECT_LE(std::stod(report.say[0].text), 100);
}

TEST(Lockstep, SeesTheFirstTimeItIsAsked) {
  const std::string distance = block({"vision_obstacle_distance", "d", number_input("ANGLE", "0"), ""});
  const RunReport report =
      run(flag(block({"looks_say", "say", block_input("MESSAGE", distance), ""})), in_room("sala-1"));
  ASSERT_EQ(report.say.size(), 1u);
  EXPECT_GT(std::stod(report.say[0].text), 30);
  EXPECT_LT(report.simulated_s, 0.5);
}

TEST(Lockstep, DrivesInARoomAsFarAsItSays) {
  const RunReport report = run(flag(drive("forward", "40")), in_room("green-field"));
  EXPECT_EQ(report.status, RunStatus::finished);
  EXPECT_NEAR(report.robot->path_m, 0.4, 0.02);
  EXPECT_EQ(report.robot->contacts, 0);
}

TEST(Lockstep, TheSameSeedTheSameHash) {
  const std::string moves = flag(drive("forward", "10", turn("left", "30", say("x"))));
  LockstepOptions options = in_room("workshop");
  const std::string hash = run(moves, options).hash;
  EXPECT_EQ(run(moves, options).hash, hash);
  options.seed = 2;
  EXPECT_NE(run(moves, options).hash, hash);
}

}  // namespace
}  // namespace mirada::rig
