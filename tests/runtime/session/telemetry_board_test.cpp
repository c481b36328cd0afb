#include "session/telemetry_board.h"

#include <gtest/gtest.h>

namespace mirada::session {
namespace {

Telemetry at(Micros t) {
  Telemetry telemetry;
  telemetry.t = t;
  return telemetry;
}

TEST(TelemetryBoard, IsNeverEmpty) { EXPECT_NE(TelemetryBoard().latest(), nullptr); }

TEST(TelemetryBoard, IsDueTwentyTimesASecond) {
  TelemetryBoard board;
  EXPECT_TRUE(board.due(0, 0, RunState::idle));
  board.publish(at(0));
  EXPECT_FALSE(board.due(49'999, 0, RunState::idle));
  EXPECT_TRUE(board.due(50'000, 0, RunState::idle));
}

TEST(TelemetryBoard, IsDueAtOnceWhenTheRunChanges) {
  TelemetryBoard board;
  board.publish(at(0));
  EXPECT_TRUE(board.due(1, 0, RunState::running));
  EXPECT_TRUE(board.due(1, 1, RunState::idle));
}

TEST(TelemetryBoard, KeepsTheOldWhenOnlyTimeHasPassed) {
  TelemetryBoard board;
  Telemetry first = at(50'000);
  first.say = "hi";
  board.publish(first);
  const auto seen = board.latest();
  first.t = 100'000;
  board.publish(first);
  EXPECT_EQ(board.latest(), seen);
}

template <class Change>
bool is_news(Change change) {
  TelemetryBoard board;
  board.publish(at(50'000));
  const auto seen = board.latest();
  Telemetry next = at(100'000);
  change(next);
  board.publish(next);
  return board.latest() != seen;
}

auto blocks(std::vector<std::string> ids) {
  return std::make_shared<const std::vector<std::string>>(std::move(ids));
}

TEST(TelemetryBoard, ShowsWhatIsNew) {
  EXPECT_TRUE(is_news([](Telemetry& next) { next.X_OR.y_m = 1; }));
  EXPECT_TRUE(is_news([](Telemetry& next) { next.variables["a"] = {}; }));
  EXPECT_TRUE(is_news([](Telemetry& next) { next.lists["a"] = {{}}; }));
  EXPECT_TRUE(is_news([](Telemetry& next) { next.running_blocks = blocks({"b"}); }));
  EXPECT_TRUE(is_news([](Telemetry& next) { next.scene_json = "{}"; }));
  EXPECT_TRUE(is_news([](Telemetry& next) { next.percepts = std::make_shared<const Percepts>(); }));
  EXPECT_TRUE(is_news([](Telemetry& next) { next.say_log = {{0, "a"}}; }));
  EXPECT_TRUE(is_news([](Telemetry& next) { next.stop_reason = StopReason::stuck; }));
}

}  // namespace
}  // namespace mirada::session
