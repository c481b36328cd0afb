#include <chrono>
#include <future>
#include <thread>

#include <gtest/gtest.h>

#include "program_text.h"
#include "rig/shipped_packs.h"
#include "rig/station_factory.h"

namespace mirada::rig {
namespace {

using session::RunState;
using session::StopReason;
using session::Telemetry;

class LiveStationTest : public ::testing::Test {
 protected:
  LiveStationTest() {
    StationOptions options;
    options.world = "sala-1";
    options.robot = "mirada-sim";
    station = std::move(make_station(options).value());
  }

  /// Looks again and again; generous, because the machine may be busy. It gives way between two looks,
  /// because a reader that hardly lets go of the station's locks keeps its threads from them.
  template <class Condition>
  bool comes(Condition condition) const {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (!condition(*station->telemetry())) {
      if (std::chrono::steady_clock::now() > deadline) return false;
      for (int turn = 0; turn < 200; ++turn) std::this_thread::yield();
    }
    return true;
  }
  static bool moving(const Telemetry& now) { return now.left_mps > 0.1; }

  std::unique_ptr<session::Station> station;
};

const std::string kRollOn = program(flag(set_speeds("50", "50", forever(wait("0.05")))));

TEST_F(LiveStationTest, AProgramDrivesAndStopStops) {
  const auto started = station->start(kRollOn);
  ASSERT_TRUE(started.ok());
  EXPECT_EQ(started->run, 1u);
  EXPECT_TRUE(comes(moving));
  EXPECT_TRUE(comes([](const Telemetry& now) { return now.X_OR.x_m > 0.02; }));
  station->stop(StopReason::owner_lost);
  EXPECT_TRUE(comes([](const Telemetry& now) { return now.state == RunState::idle; }));
  const auto now = station->telemetry();
  EXPECT_EQ(now->stop_reason, StopReason::owner_lost);
  EXPECT_EQ(now->left_mps, 0);
}

TEST_F(LiveStationTest, TheFlagAgainBeginsAnew) {
  ASSERT_TRUE(station->start(kRollOn).ok());
  EXPECT_TRUE(comes(moving));
  const auto again = station->start(program(flag(say("second"))));
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again->run, 2u);
  EXPECT_TRUE(comes(
      [](const Telemetry& now) { return now.run == 2 && now.stop_reason == StopReason::program_ended; }));
  EXPECT_EQ(station->telemetry()->say_log.at(0).text, "second");
}

TEST_F(LiveStationTest, EachRunBeginsWithTheCameraLevel) {
  const std::string look_up = block({"looking_tilt_to", "tilt", number_input("ANGLE", "30"), ""}, wait("60"));
  ASSERT_TRUE(station->start(program(flag(look_up))).ok());
  EXPECT_TRUE(comes([](const Telemetry& now) { return now.neck.tilt_rad < -0.3; }));
  ASSERT_TRUE(station->start(program(flag(wait("60")))).ok());
  EXPECT_TRUE(comes([](const Telemetry& now) { return now.run == 2 && now.neck.tilt_rad == 0; }));
}

TEST_F(LiveStationTest, ABrokenProgramStopsTheOldOneAndListsItsFaults) {
  ASSERT_TRUE(station->start(kRollOn).ok());
  EXPECT_TRUE(comes(moving));
  const auto refused = station->start("{");
  ASSERT_FALSE(refused.ok());
  EXPECT_TRUE(comes([](const Telemetry& now) { return now.state == RunState::idle; }));
}

TEST_F(LiveStationTest, StopFromManyThreadsWhileStartingLeavesTheRobotStill) {
  for (int round = 0; round < 10; ++round) {
    std::thread starter([&] { (void)station->start(kRollOn); });
    std::thread stopper([&] { station->stop(StopReason::stop_button); });
    starter.join();
    stopper.join();
    station->stop(StopReason::stop_button);
    EXPECT_TRUE(comes([](const Telemetry& now) { return now.state == RunState::idle; }));
    EXPECT_EQ(station->telemetry()->left_mps, 0);
  }
}

TEST_F(LiveStationTest, PauseStandsStillAndGoesOn) {
  ASSERT_TRUE(station->start(kRollOn).ok());
  EXPECT_TRUE(comes(moving));
  station->pause(true);
  EXPECT_TRUE(comes([](const Telemetry& now) { return now.state == RunState::paused && now.left_mps == 0; }));
  station->pause(false);
  EXPECT_TRUE(comes(moving));
}

TEST_F(LiveStationTest, AClickedReporterIsAnswered) {
  const std::string text = program(R"({"type": "vision_obstacle_distance", "id": "distance", "inputs": {)" +
                                   number_input("ANGLE", "0") + "}}");
  std::promise<Result<vm::MonitorValue>> answer;
  station->evaluate(text, "distance",
                    [&](Result<vm::MonitorValue> value) { answer.set_value(std::move(value)); });
  const auto value = answer.get_future().get();
  ASSERT_TRUE(value.ok());
  EXPECT_TRUE(value->is_number);
  EXPECT_GT(value->number, 10);
}

TEST_F(LiveStationTest, PicturesComeOnlyWhileSomebodyLooks) {
  EXPECT_EQ(station->picture(), nullptr);
  session::Wanted wanted;
  wanted.camera = wanted.sonar = true;
  station->want(wanted);
  EXPECT_TRUE(comes([&](const Telemetry& now) {
    return station->picture() && now.percepts && now.percepts->sonar.frame > 0;
  }));
  EXPECT_EQ(station->picture()->width_px, 320);
  EXPECT_GT(station->picture()->jpeg.size(), 1'000u);
  station->want({});
  EXPECT_TRUE(comes([&](const Telemetry&) { return station->picture() == nullptr; }));
}

TEST_F(LiveStationTest, TheRoomIsShownWhenItIsWanted) {
  session::Wanted wanted;
  wanted.room = true;
  station->want(wanted);
  EXPECT_TRUE(
      comes([](const Telemetry& now) { return now.scene_json.find("\"walls\"") != std::string::npos; }));
}

TEST_F(LiveStationTest, NobodyFarAwayOpensAFileByChoosingIt) {
  session::Setup setup = station->setup();
  setup.world = "/etc/hostname";
  setup.robot = "../robot.json";
  const Status refused = station->choose(setup);
  ASSERT_EQ(refused.faults().size(), 2u);
  for (const Fault& fault : refused.faults()) EXPECT_EQ(fault.code(), "not_offered");
}

TEST_F(LiveStationTest, ChoosingBuildsAnotherRobotOrLeavesTheOldOne) {
  session::Setup setup = station->setup();
  EXPECT_EQ(setup.world, "sala-1");
  setup.world = "no-such-room";
  setup.robot = "no-such-robot";
  const Status refused = station->choose(setup);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.faults().size(), 2u);
  EXPECT_EQ(station->setup().world, "sala-1");
  ASSERT_TRUE(station->start(kRollOn).ok());
  setup.world = "green-field";
  setup.robot = "mirada-sim";
  ASSERT_TRUE(station->choose(setup).ok());
  EXPECT_EQ(station->setup().world, "green-field");
  EXPECT_EQ(station->telemetry()->state, RunState::idle);
  EXPECT_EQ(station->start(kRollOn)->run, 2u);
}

TEST_F(LiveStationTest, PutBackStopsAndGoesToTheStart) {
  session::Wanted wanted;
  wanted.room = true;
  station->want(wanted);
  EXPECT_TRUE(comes([](const Telemetry& now) { return !now.scene_json.empty(); }));
  const std::string start = station->telemetry()->scene_json;
  ASSERT_TRUE(station->start(kRollOn).ok());
  EXPECT_TRUE(comes([&](const Telemetry& now) { return now.X_OR.x_m > 0.05 && now.scene_json != start; }));
  ASSERT_TRUE(station->put_back().ok());
  EXPECT_TRUE(
      comes([&](const Telemetry& now) { return now.state == RunState::idle && now.scene_json == start; }));
  EXPECT_EQ(station->telemetry()->stop_reason, StopReason::put_back);
}

TEST(MakeStation, ListsEveryFaultOfWhatItIsAskedFor) {
  StationOptions options;
  options.world = "no-room";
  options.robot = "no-robot";
  const auto station = make_station(options);
  ASSERT_FALSE(station.ok());
  EXPECT_EQ(station.faults().size(), 2u);
  options = {};
  options.camera = "no-such-file.mp4";
  EXPECT_FALSE(make_station(options).ok());
}

TEST(ShippedPacks, LoadWithoutAFault) {
  const auto packs = load_shipped_packs();
  EXPECT_TRUE(packs->faults.empty()) << to_text(packs->faults, Lang::en);
  EXPECT_NE(packs->catalog.find("vision_obstacle_distance"), nullptr);
}

}  // namespace
}  // namespace mirada::rig
