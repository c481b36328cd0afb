// Programs that nobody should write: each ends in words on a block, the other scripts go on, Stop works.
#include <algorithm>
#include <thread>

#include <gtest/gtest.h>

#include "programs/support.h"

namespace mirada::vm::test {
namespace {

Json set(const std::string& name, Json value) {
  return block("data_setvariableto", {{"VALUE", std::move(value)}}, {{"VARIABLE", named(name)}});
}
Json change(const std::string& name) {
  return block("data_changevariableby", {{"VALUE", number(1)}}, {{"VARIABLE", named(name)}});
}
Json with_mouth(const char* opcode, std::vector<Json> body, Json inputs = Json::object()) {
  inputs["SUBSTACK"] = in(stack(std::move(body)));
  return block(opcode, std::move(inputs));
}
Json with_id(Json json, const std::string& id) {
  json["id"] = id;
  return json;
}
/// A script that must still be alive when the others have failed.
Json survivor() { return hat({with_mouth("control_forever", {change("alive")})}); }

void expect_goes_on_and_stops(Running& run) {
  const double before = run.value("alive");
  run.machine->tick();
  run.machine->tick();
  EXPECT_GT(run.value("alive"), before);
  run.machine->stop();
  EXPECT_FALSE(run.machine->any_script_alive());
}

std::vector<std::string> codes(const Faults& faults) {
  std::vector<std::string> out;
  for (const Fault& fault : faults) out.emplace_back(fault.code());
  std::sort(out.begin(), out.end());
  return out;
}

/// `front` and `back` around each other `depth` times, then the script's head. `#` becomes a number of its
/// own.
std::string nested(const std::string& front, const std::string& core, const std::string& back, int depth) {
  std::string out =
      R"({"workspace":{"blocks":{"blocks":[{"type":"event_whenflagclicked","id":"h","next":{"block":)"
      R"({"type":"data_addtolist","id":"a","fields":{},"inputs":{"ITEM":)";
  for (int i = 0; i < depth; ++i) {
    std::string part = front;
    part.replace(part.find('#'), 1, "n" + std::to_string(i));
    out += part;
  }
  out += core;
  for (int i = 0; i < depth; ++i) out += back;
  return out + "}}}}]}}}";
}

bool named_once(const Faults& faults, std::string_view code) {
  return std::count_if(faults.begin(), faults.end(), [&](const Fault& f) { return f.code() == code; }) == 1;
}

TEST(Abuse, TenThousandDeepIsOneFaultInEverySocket) {
  const std::string literal = R"({"shadow":{"type":"text","id":"t","fields":{"TEXT":"x"}}})";
  const char* fronts[] = {R"({"block":{"type":"operator_join","id":"#","inputs":{"STRING1":)",
                          R"({"shadow":{"type":"operator_join","id":"#","inputs":{"STRING1":)",
                          R"({"block":{"type":"control_forever","id":"#","inputs":{"SUBSTACK":)",
                          R"({"shadow":{"type":"nobody_knows","id":"#","inputs":{"X":)"};
  for (const char* front : fronts) {
    const auto loaded = load_program(nested(front, literal, "}}}", 10'000), core_catalog());
    ASSERT_FALSE(loaded.ok()) << front;
    EXPECT_TRUE(named_once(loaded.faults(), "nested_too_deep")) << front;
  }
}

TEST(Abuse, ABlockThatCallsItselfForEverFaultsAndTheRestGoesOn) {
  const Json signature = {{"id", "p"}, {"name", "again"}, {"params", Json::array()}, {"warp", true}};
  Json define = block("procedures_definition");
  Json call = with_id(block("procedures_call"), "call");
  define["extraState"] = call["extraState"] = signature;
  Json first = call;
  first["id"] = "first";
  Limits limits;
  limits.warp_executions = 1'000'000;
  limits.executions_per_tick = 1'000'000;
  Running run(program({hat({first}), stack({define, call}), survivor()}, {"alive"}), limits);
  for (int i = 0; i < 5; ++i) run.machine->tick();
  const auto faults = run.machine->take_faults();
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].block, "call");
  EXPECT_EQ(faults[0].fault.code(), "too_deep");
  expect_goes_on_and_stops(run);
}

TEST(Abuse, ATextDoubledFortyTimesFaultsOnItsBlock) {
  const Json twice = block("operator_join", {{"STRING1", in(var("t"))}, {"STRING2", in(var("t"))}});
  Running run(program({hat({set("t", text("ab")),
                            with_mouth("control_repeat", {set("t", in(with_id(twice, "join"))), change("n")},
                                       {{"TIMES", number(40)}})}),
                       survivor()},
                      {"t", "n", "alive"}));
  for (int i = 0; i < 60; ++i) run.machine->tick();
  const auto faults = run.machine->take_faults();
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].block, "join");
  EXPECT_EQ(faults[0].fault.code(), "text_over_limit");
  EXPECT_LT(run.value("n"), 40);
  expect_goes_on_and_stops(run);
}

TEST(Abuse, ListsThatGrowForEverStopAtScratchsLimitOrAtTheMemorys) {
  const auto grow = [](const std::string& name, Json item) {
    return with_id(block("data_addtolist", {{"ITEM", std::move(item)}}, {{"LIST", named(name)}}),
                   "add-" + name);
  };
  Limits limits;
  limits.max_total_bytes = 16u << 20;
  limits.executions_per_tick = 1'000'000;
  const Json fresh =
      block("operator_join", {{"STRING1", in(var("alive"))}, {"STRING2", text(std::string(200, 'x'))}});
  Running run(program({hat({with_mouth("control_forever", {grow("numbers", number(1))})}),
                       hat({with_mouth("control_forever", {grow("texts", in(fresh))})}), survivor()},
                      {"alive"}, {"numbers", "texts"}),
              limits);
  for (int i = 0; i < 10; ++i) run.machine->tick();
  const auto faults = run.machine->take_faults();
  ASSERT_FALSE(faults.empty());
  for (const BlockFault& fault : faults) EXPECT_EQ(fault.fault.code(), "out_of_memory");
  EXPECT_LE(run.machine->lists(kWholeMonitors).at("numbers").size(), 200'000U);
  expect_goes_on_and_stops(run);
}

TEST(Abuse, AStormOfMessagesIsInterruptedAndStopped) {
  const Json storm = block("event_broadcast", Json::object(), {{"BROADCAST_INPUT", named("m")}});
  const Json receive =
      block("event_whenbroadcastreceived", Json::object(), {{"BROADCAST_OPTION", named("m")}});
  std::vector<Json> tops{hat({storm})};
  for (int i = 0; i < 1500; ++i) tops.push_back(stack({receive, storm, change("n")}));
  Limits limits;
  limits.executions_per_tick = UINT64_MAX;
  Running run(program(std::move(tops), {"n"}, {}, {"m"}), limits);
  std::thread other([&] {
    while (run.machine->block_executions() < 10'000) std::this_thread::yield();
    run.machine->interrupt();
  });
  run.machine->tick(true);
  other.join();
  run.machine->stop();
  EXPECT_FALSE(run.machine->any_script_alive());
}

Json sum_of(int blocks) {
  if (blocks <= 0) return number(1);
  const int left = (blocks - 1) / 2;
  return in(block("operator_add", {{"NUM1", sum_of(left)}, {"NUM2", sum_of(blocks - 1 - left)}}));
}

TEST(Abuse, NobodyWaitsForReceiversThatFoundNoMemoryToStart) {
  const Json ask = block("event_broadcastandwait", Json::object(), {{"BROADCAST_INPUT", named("m")}});
  const Json receive =
      block("event_whenbroadcastreceived", Json::object(), {{"BROADCAST_OPTION", named("m")}});
  const Json big = block("control_repeat", {{"TIMES", sum_of(200)}, {"SUBSTACK", in(change("r"))}});
  int refused = 0;
  for (std::size_t bytes = 0; bytes < 400; bytes += 8) {
    Limits limits;
    limits.max_total_bytes = bytes;
    Running run(program({hat({ask, change("n")}), stack({receive, big})}, {"n", "r"}, {}, {"m"}), limits);
    EXPECT_TRUE(run.finish()) << bytes;
    refused += run.value("n") == 1 && run.value("r") == 0;
  }
  EXPECT_GT(refused, 0);
}

TEST(Abuse, FiveThousandBlocksInOneExpressionAreWorkedOut) {
  Running run(program({hat({set("n", sum_of(4990))})}, {"n"}));
  run.finish();
  EXPECT_EQ(run.value("n"), 4991);
}

TEST(Abuse, DanglingAndDoubledIdsAreAllTold) {
  Json call = block("procedures_call");
  call["extraState"] = {{"id", "gone"}, {"name", "gone"}, {"params", Json::array()}};
  Json doubled = with_id(change("i"), "twice");
  const Json json =
      program({hat({doubled, doubled, set("nobody", text("x")),
                    block("event_broadcast", Json::object(), {{"BROADCAST_INPUT", named("nothing")}}),
                    block("data_addtolist", {{"ITEM", text("x")}}, {{"LIST", named("nowhere")}}), call})},
              {"i"});
  const auto loaded = load_program(json.dump(), core_catalog());
  ASSERT_FALSE(loaded.ok());
  EXPECT_EQ(codes(loaded.faults()),
            (std::vector<std::string>{"dangling_variable", "dangling_variable", "dangling_variable",
                                      "duplicate_id", "no_definition"}));
}

/// One block of every kind, all its sockets filled with `value`.
Json block_of(const BlockDef& def, const Json& value) {
  Json inputs = Json::object();
  Json fields = Json::object();
  for (const ArgDef& arg : def.args) {
    if (arg.type == ArgType::statements) {
      inputs[arg.name] = in(change("n"));
    } else if (arg.type == ArgType::variable || arg.type == ArgType::list || arg.type == ArgType::broadcast) {
      fields[arg.name] = named(arg.type == ArgType::variable ? "v" : arg.type == ArgType::list ? "L" : "m");
    } else if (arg.is_field) {
      fields[arg.name] = arg.options.empty() ? "any" : arg.options.front().value;
    } else {
      inputs[arg.name] = value;
    }
  }
  return block(def.opcode, std::move(inputs), std::move(fields));
}

Json quotient(double a) { return in(block("operator_divide", {{"NUM1", number(a)}, {"NUM2", number(0)}})); }

TEST(Abuse, NanAndInfinityInEverySocketHarmNobody) {
  const Json values[] = {text("NaN"), text("Infinity"), text("-Infinity"), quotient(0),
                         quotient(1), quotient(-1),     number(1e308)};
  for (const auto& [opcode, def] : core_catalog().all()) {
    if (def.pack == "procedures" || opcode == "control_stop" || def.shape == Shape::hat) continue;
    for (const Json& value : values) {
      const bool is_value = def.shape == Shape::reporter || def.shape == Shape::boolean;
      Json body = block_of(def, value);
      if (is_value) body = set("v", in(std::move(body)));
      Running run(
          program({hat({body, change("after")}), survivor()}, {"n", "v", "after", "alive"}, {"L"}, {"m"}));
      for (int i = 0; i < 3; ++i) run.machine->tick();
      EXPECT_TRUE(run.machine->take_faults().empty()) << opcode;
      expect_goes_on_and_stops(run);
    }
  }
}

}  // namespace
}  // namespace mirada::vm::test
