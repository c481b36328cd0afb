// The machine as a session uses it: ticks, budgets, stop, natives that take their time, clicks, highlights.
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "programs/support.h"

namespace mirada::vm::test {
namespace {

constexpr Message kBroken{"broken", "It is broken.", "Está roto."};

Json set(const std::string& name, Json value) {
  return block("data_setvariableto", {{"VALUE", std::move(value)}}, {{"VARIABLE", named(name)}});
}
Json change(const std::string& name) {
  return block("data_changevariableby", {{"VALUE", number(1)}}, {{"VARIABLE", named(name)}});
}
Json forever(std::vector<Json> body) {
  return block("control_forever", {{"SUBSTACK", in(stack(std::move(body)))}});
}
Json wait(double seconds) { return block("control_wait", {{"DURATION", number(seconds)}}); }
Json with_id(Json json, const std::string& id) {
  json["id"] = id;
  return json;
}

/// The core packs and a few native blocks of the test's own.
struct Natives {
  Natives() {
    for (const auto& [opcode, def] : core_catalog().all()) catalog.add(def);
  }
  void add(const std::string& opcode, Shape shape, NativeFn native, bool visible = false) {
    BlockDef def;
    def.opcode = opcode;
    def.pack = "test";
    def.shape = shape;
    def.native = std::move(native);
    def.visible = visible;
    catalog.add(def);
  }
  BlockCatalog catalog;
};

TEST(Machine, ATickEndsWhenItsBudgetIsSpentAndTheNextGoesOn) {
  Limits limits;
  limits.executions_per_tick = 1000;
  Running run(program({hat({forever({change("i")})})}, {"i"}), limits);
  run.machine->tick();
  EXPECT_NEAR(static_cast<double>(run.machine->block_executions()), 1000, 4);
  run.machine->tick();
  EXPECT_NEAR(run.value("i"), 1000, 4);
}

TEST(Machine, WarpGoesOverTicksWithoutLettingOthersIn) {
  Limits limits;
  limits.executions_per_tick = 1000;
  const Json loop = block("control_repeat", {{"TIMES", number(5000)}, {"SUBSTACK", in(change("i"))}});
  Running run(program({hat({block("control_all_at_once", {{"SUBSTACK", in(loop)}})}),
                       hat({set("seen", in(var("i")))})},
                      {"i", "seen"}),
              limits);
  for (int tick = 0; tick < 5; ++tick) {
    run.machine->tick();
    EXPECT_EQ(run.value("seen"), 0);
  }
  run.finish();
  EXPECT_EQ(run.value("i"), 5000);
  EXPECT_EQ(run.value("seen"), 5000);
}

TEST(Machine, WarpLetsOthersInWhenItsTimeIsUp) {
  Limits limits;
  limits.warp_executions = 10'000;
  const Json loop = block("control_forever", {{"SUBSTACK", in(change("i"))}});
  Running run(
      program({hat({block("control_all_at_once", {{"SUBSTACK", in(loop)}})}), hat({forever({change("j")})})},
              {"i", "j"}),
      limits);
  for (int tick = 0; tick < 10; ++tick) run.machine->tick();
  EXPECT_GT(run.value("j"), 0);
  EXPECT_GT(run.value("i"), 1000 * run.value("j"));
}

TEST(Machine, InterruptEndsARunningTick) {
  Limits limits;
  limits.executions_per_tick = UINT64_MAX;
  limits.warp_executions = UINT64_MAX;
  Running run(program({hat({forever({change("i")})})}, {"i"}), limits);
  std::thread other([&] {
    while (run.machine->block_executions() == 0) std::this_thread::yield();
    run.machine->interrupt();
  });
  run.machine->tick(true);
  other.join();
  run.machine->stop();
  EXPECT_FALSE(run.machine->any_script_alive());
}

TEST(Machine, AVisibleBlockEndsTheScriptsTurnsOfTheTick) {
  Natives natives;
  natives.add(
      "test_show", Shape::command, [](NativeCall&) { return NativeResult::finished(); }, true);
  Running run(
      program({hat({forever({block("test_show"), change("i")})}), hat({forever({change("j")})})}, {"i", "j"}),
      {}, natives.catalog);
  run.machine->tick();
  EXPECT_EQ(run.value("i"), 1);
  EXPECT_GT(run.value("j"), 1000);
  run.machine->tick();
  EXPECT_EQ(run.value("i"), 2);
}

TEST(Machine, ANativeMayTakeManyTicksAndKeepsItsState) {
  struct Count final : NativeState {
    int calls = 0;
  };
  Natives natives;
  natives.add("test_slow", Shape::reporter, [](NativeCall& call) {
    if (!call.state()) call.state() = std::make_unique<Count>();
    const int calls = ++static_cast<Count&>(*call.state()).calls;
    return calls < 4 ? NativeResult::again_at() : NativeResult::of(static_cast<double>(calls));
  });
  Running run(
      program({hat({set("x", in(block("test_slow"))), set("y", in(block("test_slow")))})}, {"x", "y"}), {},
      natives.catalog);
  for (int tick = 0; tick < 4; ++tick) run.machine->tick();
  EXPECT_EQ(run.value("x"), 4);
  run.finish();
  EXPECT_EQ(run.value("y"), 4);
}

TEST(Machine, ANativesFaultEndsItsScriptAndMarksTheBlock) {
  Natives natives;
  natives.add("test_break", Shape::command, [](NativeCall&) { return NativeResult::failed(kBroken); });
  Running run(program({hat({with_id(block("test_break"), "bad"), change("i")}), hat({wait(1), change("j")})},
                      {"i", "j"}),
              {}, natives.catalog);
  run.finish();
  const auto faults = run.machine->take_faults();
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].block, "bad");
  EXPECT_EQ(faults[0].fault.code(), "broken");
  EXPECT_EQ(run.value("i"), 0);
  EXPECT_EQ(run.value("j"), 1);
  EXPECT_EQ(run.host.ended, (std::vector{ThreadEnd::faulted, ThreadEnd::finished}));
}

TEST(Machine, ANativeHatFiresOnlyWhenItTurnsTrue) {
  Natives natives;
  bool near = false;
  natives.add("test_near", Shape::hat, [&](NativeCall&) { return NativeResult::of(near); });
  Running run(program({stack({block("test_near"), change("i")})}, {"i"}), {}, natives.catalog);
  const auto ticks = [&](bool value) {
    near = value;
    for (int tick = 0; tick < 3; ++tick) run.machine->tick();
  };
  ticks(false);
  ticks(true);
  EXPECT_EQ(run.value("i"), 1);
  ticks(false);
  ticks(true);
  EXPECT_EQ(run.value("i"), 2);
  EXPECT_TRUE(run.machine->waits_for_outside());
  EXPECT_FALSE(run.machine->may_fire_by_itself());
}

TEST(Machine, StopKillsEveryScriptAndKeepsVariables) {
  Running run(program({hat({forever({change("i")})}), hat({wait(100)})}, {"i"}));
  run.machine->tick();
  run.machine->stop();
  EXPECT_FALSE(run.machine->any_script_alive());
  EXPECT_GT(run.value("i"), 0);
  EXPECT_EQ(run.host.ended, (std::vector{ThreadEnd::killed, ThreadEnd::killed}));
  run.machine->tick();
  EXPECT_EQ(run.machine->next_wake(), INT64_MAX);
}

TEST(Machine, NextWakeIsWhenTheFirstSleeperWakes) {
  Running run(program({hat({wait(5)}), hat({wait(2)})}, {}));
  EXPECT_EQ(run.machine->next_wake(), 0);
  run.machine->tick();
  EXPECT_EQ(run.machine->next_wake(), 2 * kSecond);
}

TEST(Machine, AClickedReporterAnswersItsValueWhileTheProgramRuns) {
  const Json sum = block("operator_add", {{"NUM1", in(var("i"))}, {"NUM2", number(0.5)}});
  Running run(program({hat({set("i", number(41)), forever({wait(0.1)})}), with_id(sum, "sum")}, {"i"}));
  run.machine->tick();
  run.machine->evaluate("sum", 7);
  run.machine->evaluate("nothing", 8);
  run.machine->tick();
  const auto answers = run.machine->take_answers();
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_FALSE(answers[0].ok);
  EXPECT_EQ(answers[0].request, 8U);
  EXPECT_TRUE(answers[1].ok);
  EXPECT_EQ(answers[1].value.text, "41.5");
  EXPECT_TRUE(run.machine->any_script_alive());
}

TEST(Machine, AskingForAMyBlocksValueDoesNothingElse) {
  Natives natives;
  int acts = 0;
  natives.add("test_act", Shape::command, [&acts](NativeCall&) {
    ++acts;
    return NativeResult::finished();
  });
  const Json shape{{"id", "p"}, {"name", "p"}, {"params", Json::array()}, {"returns", true}, {"warp", false}};
  Json define = stack({block("procedures_definition"), block("test_act"),
                       block("procedures_return", {{"VALUE", number(7)}})});
  Json call = with_id(block("procedures_call_value"), "call");
  define["extraState"] = call["extraState"] = shape;
  Running run(program({define, hat({forever({wait(0.1)})}), call}, {}), {}, natives.catalog);
  run.machine->tick();
  run.machine->evaluate("call", 1);
  run.machine->tick();
  const auto answers = run.machine->take_answers();
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_EQ(answers[0].value.text, "7");
  EXPECT_EQ(acts, 0);
}

TEST(Machine, AMonitorShowsTheStartOfWhatIsLong) {
  const Json grow = block(
      "data_setvariableto",
      {{"VALUE", in(block("operator_join", {{"STRING1", in(var("s"))}, {"STRING2", text("\u00e9\u00e9")}}))}},
      {{"VARIABLE", named("s")}});
  const Json note = block("data_addtolist", {{"ITEM", in(var("s"))}}, {{"LIST", named("L")}});
  Running run(
      program({hat({block("control_repeat", {{"TIMES", number(600)}, {"SUBSTACK", in(grow)}}), note})}, {"s"},
              {"L"}));
  run.finish();
  const std::string shown = run.machine->variables().at("s").text;
  EXPECT_EQ(shown.size(),
            1 + 999 * 2 + 3U);  // the 0 it began with, letters of two bytes, a sign that it goes on
  EXPECT_EQ(run.machine->lists().at("L")[0].text, shown);
  EXPECT_EQ(run.machine->variables(kWholeMonitors).at("s").text.size(), 1 + 1200 * 2U);
}

TEST(Machine, RunningBlocksAreTheInnermostWithWhatHoldsThem) {
  Running run(program({hat({with_id(forever({with_id(wait(1), "wait")}), "loop")})}, {}));
  run.machine->tick();
  EXPECT_EQ(*run.machine->running_blocks(), (std::vector<std::string>{"loop", "wait"}));
}

/// A stack of `count` blocks below a flag hat, written as text from the front: a tree of JSON values that is
/// copied or written out recurses once a block, which is more than a sanitizer's stack holds.
std::string long_stack(int count) {
  std::string out = R"({"workspace":{"variables":[{"name":"i","id":"id-i","type":""}],)"
                    R"("blocks":{"blocks":[{"type":"event_whenflagclicked","id":"hat")";
  for (int i = 0; i < count; ++i) {
    out += R"(,"next":{"block":{"type":"data_changevariableby","id":"b)" + std::to_string(i) +
           R"(","fields":{"VARIABLE":{"id":"id-i"}},)"
           R"("inputs":{"VALUE":{"shadow":{"type":"math_number","fields":{"NUM":1}}}})";
  }
  for (int i = 0; i < count; ++i) out += "}}";
  return out + "}]}}}";
}

TEST(Machine, FiveThousandBlocksInOneStackRun) {
  Running run(std::string_view(long_stack(4999)));
  run.finish();
  EXPECT_EQ(run.value("i"), 4999);
}

TEST(Machine, NestingBeyondTheLimitIsOneFault) {
  Json inner = number(1);
  for (int depth = 0; depth < 300; ++depth) {
    inner = in(block("operator_add", {{"NUM1", std::move(inner)}, {"NUM2", number(1)}}));
  }
  const auto loaded =
      load_program(program({hat({set("x", std::move(inner))})}, {"x"}).dump(), core_catalog());
  ASSERT_FALSE(loaded.ok());
  ASSERT_EQ(loaded.faults().size(), 1U);
  EXPECT_EQ(loaded.faults()[0].code(), "nested_too_deep");
}

TEST(Machine, TenThousandDeepJsonAndBrokenJsonAreAnsweredInWords) {
  std::string deep;
  for (int i = 0; i < 10'000; ++i) deep += R"({"next":{"block":)";
  EXPECT_FALSE(load_program(deep, core_catalog()).ok());
  EXPECT_FALSE(load_program(std::string(100'000, '['), core_catalog()).ok());
  EXPECT_FALSE(load_program("", core_catalog()).ok());
  EXPECT_FALSE(load_program("[]", core_catalog()).ok());
  EXPECT_FALSE(load_program("{\"workspace\":{\"blocks\":7}}", core_catalog()).ok());
}

TEST(Machine, TenThousandScriptsTakeTurns) {
  std::vector<Json> tops;
  for (int i = 0; i < 2000; ++i) tops.push_back(hat({change("i")}));
  Running run(program(std::move(tops), {"i"}));
  run.finish(10, false);
  EXPECT_EQ(run.value("i"), 2000);
}

TEST(Machine, ABroadcastStormDoesNotGrow) {
  const Json storm = block("event_broadcast", Json::object(), {{"BROADCAST_INPUT", named("m")}});
  const Json receive =
      block("event_whenbroadcastreceived", Json::object(), {{"BROADCAST_OPTION", named("m")}});
  Running run(program({hat({storm}), stack({receive, storm, change("i")})}, {"i"}, {}, {"m"}));
  for (int tick = 0; tick < 100; ++tick) run.machine->tick();
  EXPECT_GT(run.value("i"), 100);
}

}  // namespace
}  // namespace mirada::vm::test
