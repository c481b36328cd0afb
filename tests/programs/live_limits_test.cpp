// What bounds a live robot's ticks: the wall clock, and the scripts that wait.
#include <gtest/gtest.h>

#include "programs/support.h"

namespace mirada::vm::test {
namespace {

/// A millisecond passes whenever somebody looks.
class HastyClock final : public Clock {
 public:
  Micros now() const override { return now_ += kMillisecond; }

 private:
  mutable Micros now_ = 0;
};

Json change(const std::string& name) {
  return block("data_changevariableby", {{"VALUE", number(1)}}, {{"VARIABLE", named(name)}});
}
Json forever(Json body) { return block("control_forever", {{"SUBSTACK", in(std::move(body))}}); }
Json wait(double seconds) { return block("control_wait", {{"DURATION", number(seconds)}}); }
Json all_at_once(Json body) { return block("control_all_at_once", {{"SUBSTACK", in(std::move(body))}}); }

TEST(LiveLimits, ATickEndsWhenItsWallTimeIsSpent) {
  const HastyClock wall;
  const Limits limits = live_limits(wall);
  Running run(program({hat({forever(change("i"))})}, {"i"}), limits);
  run.machine->tick();
  EXPECT_GT(run.value("i"), 0);
  EXPECT_LE(run.machine->block_executions(), 6 * limits.slice_executions);
}

TEST(LiveLimits, ManyShortTurnsEndWithTheTickToo) {
  const HastyClock wall;
  std::vector<Json> scripts(100, hat({forever(change("i"))}));
  Running run(program(std::move(scripts), {"i"}), live_limits(wall));
  run.machine->tick();
  EXPECT_GT(run.value("i"), 0);
  EXPECT_LT(run.value("i"), 1000);
}

/// A script that never waits, and one that begins to: its time is up after so many milliseconds.
std::uint64_t executions_beside(double wait_s) {
  const HastyClock wall;
  Running run(program({hat({wait(wait_s)}), hat({forever(change("i"))})}, {"i"}), live_limits(wall));
  run.machine->tick();
  const std::uint64_t first = run.machine->block_executions();
  EXPECT_GT(run.value("i"), 0);
  run.host.clock.advance(kMillisecond);
  run.machine->tick();
  return first + run.machine->block_executions();
}

TEST(LiveLimits, ATickEndsWhenASleeperIsDue) { EXPECT_LT(executions_beside(0.002), executions_beside(0.5)); }

TEST(LiveLimits, TheTimerIsTheNextSleepersTime) {
  Running run(program({hat({wait(0.5)}), hat({wait(0.3)}), hat({forever(change("i"))})}, {"i"}));
  EXPECT_EQ(run.machine->next_timer(), INT64_MAX);
  run.machine->tick();
  EXPECT_EQ(run.machine->next_timer(), 300 * kMillisecond);
  run.host.clock.advance(300 * kMillisecond);
  run.machine->tick();
  EXPECT_EQ(run.machine->next_timer(), 500 * kMillisecond);
}

TEST(LiveLimits, WhatWaitsOnlyForTheNextTickSetsNoTimer) {
  Running run(program({hat({wait(0)}), hat({wait(0.3)})}, {}));
  run.machine->tick();
  EXPECT_EQ(run.machine->next_timer(), 300 * kMillisecond);
}

TEST(LiveLimits, AWarpTurnCutShortGoesOnAtOnce) {
  const HastyClock wall;
  Running run(program({hat({all_at_once(forever(change("i")))})}, {"i"}), live_limits(wall));
  run.machine->tick();
  EXPECT_EQ(run.machine->next_timer(), run.host.clock.now() + 1);
  const std::uint64_t first = run.machine->block_executions();
  run.machine->tick();
  EXPECT_GT(run.machine->block_executions(), first + first / 2);
}

}  // namespace
}  // namespace mirada::vm::test
