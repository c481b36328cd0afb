#include "server/client_message.h"

#include <gtest/gtest.h>

#include "server/message_scan.h"

namespace mirada::server {
namespace {

std::vector<std::string> places(const ReadMessage& read) {
  std::vector<std::string> out;
  for (const Fault& fault : read.faults) out.push_back(fault.place + " " + std::string(fault.code()));
  return out;
}

TEST(ScanObject, finds_the_members_as_they_came) {
  const ScannedObject scanned = scan_object(R"( {"a": [1, {"b": "}]"}], "c":"x\"y" ,"a":2} )");
  ASSERT_FALSE(scanned.broken_at);
  EXPECT_EQ(scanned.members.at("a"), "2");
  EXPECT_EQ(scanned.members.at("c"), R"("x\"y")");
}

TEST(ScanObject, tells_where_a_text_breaks) {
  for (const char* text :
       {"", "{", "[]", "\"x\"", "{\"a\"", "{\"a\":", "{\"a\":}", "{\"a\":1", "{\"a\":1,}", "{\"a\":[}", "{}x",
        "{\"a\":\"x}", "{\"a\":\"\\", "{a:1}", "{\"a\" 1}", "{\"a\":1 \"b\":2", "nonsense"}) {
    EXPECT_TRUE(scan_object(text).broken_at) << text;
  }
  EXPECT_FALSE(scan_object("{}").broken_at);
}

TEST(ClientMessage, five_thousand_blocks_in_one_stack_are_passed_on_unchanged) {
  std::string program;
  for (int i = 0; i < 5000; ++i) program += R"({"next":{"block":)";
  program += "{}";
  for (int i = 0; i < 5000; ++i) program += "}}";
  const ReadMessage read = read_client_message(R"({"type":"run","program":)" + program + "}");
  EXPECT_TRUE(read.faults.empty());
  EXPECT_EQ(read.message.program, program);
}

TEST(ClientMessage, depth_costs_no_stack) {
  const std::string program(2'000'000, '[');
  const ReadMessage broken = read_client_message(R"({"type":"run","program":)" + program + "}");
  EXPECT_EQ(broken.faults.size(), 1u);
  const ReadMessage whole =
      read_client_message(R"({"type":"run","program":)" + program + std::string(2'000'000, ']') + "}");
  EXPECT_TRUE(whole.faults.empty());
  EXPECT_EQ(whole.message.program.size(), 4'000'000u);
}

TEST(ClientMessage, every_fault_at_once) {
  EXPECT_EQ(places(read_client_message(R"({"type":"hello","version":"x","client":7,"code":[]})")),
            (std::vector<std::string>{"/version number_needed", "/client text_needed",
                                      "/client client_needed", "/code text_needed"}));
  EXPECT_EQ(
      places(read_client_message(R"({"type":"evaluate","request":-1})")),
      (std::vector<std::string>{"/request number_needed", "/block field_missing", "/program field_missing"}));
  EXPECT_EQ(places(read_client_message(R"({"type":"choose","world":1,"seed":0.5e300,"robot":null})")),
            (std::vector<std::string>{"/world text_needed", "/robot text_needed", "/seed number_needed"}));
}

TEST(ClientMessage, a_step_with_faces_says_what_it_lacks) {
  EXPECT_EQ(places(read_client_message(R"({"type":"faces","action":"allow"})")),
            std::vector<std::string>{"/on field_missing"});
  const ReadMessage none = read_client_message(R"({"type":"faces"})");
  EXPECT_EQ(places(none), (std::vector<std::string>{"/action choice_missing"}));
  const std::string to(10'000, 'a');
  EXPECT_EQ(
      places(read_client_message(R"({"type":"faces","action":"rename","name":"Ana","to":")" + to + "\"}")),
      std::vector<std::string>{"/to name_too_long"});
}

TEST(ClientMessage, what_is_no_message_is_told_so) {
  EXPECT_EQ(places(read_client_message("hello")), std::vector<std::string>{" message_broken"});
  EXPECT_EQ(places(read_client_message("{}")), std::vector<std::string>{"/type field_missing"});
  EXPECT_EQ(places(read_client_message(R"({"type":"fly"})")),
            std::vector<std::string>{"/type message_unknown"});
  EXPECT_EQ(places(read_client_message(R"({"type":"pause","on":tru})")),
            std::vector<std::string>{"/on json_broken"});
  EXPECT_EQ(places(read_client_message(R"({"type":"key","key":")" + std::string(5000, 'a') + "\"}")),
            std::vector<std::string>{"/key text_too_long"});
}

TEST(ClientMessage, a_program_over_the_limit_is_refused) {
  const ReadMessage read =
      read_client_message(R"({"type":"run","program":")" + std::string(kMaxProgramBytes, 'x') + "\"}");
  EXPECT_EQ(places(read), std::vector<std::string>{"/program message_too_large"});
}

TEST(ClientMessage, reads_every_verb) {
  const ReadMessage choose = read_client_message(R"({"type":"choose","world":"w","seed":9007199254740991})");
  EXPECT_EQ(choose.message.world, "w");
  EXPECT_FALSE(choose.message.robot);
  EXPECT_EQ(choose.message.seed, 9007199254740991u);
  const ReadMessage watch = read_client_message(R"({"type":"watch","camera":true,"room":true})");
  EXPECT_TRUE(watch.message.wanted.camera && watch.message.wanted.room && !watch.message.wanted.sonar);
  EXPECT_TRUE(read_client_message(R"({"type":"pause","on":true})").message.on);
  EXPECT_EQ(read_client_message(R"({"type":"key","key":"a","down":false})").message.key, "a");
  EXPECT_EQ(read_client_message(R"({"type":"stop"})").message.verb, ClientVerb::stop);
  EXPECT_EQ(read_client_message(R"({"type":"release"})").message.verb, ClientVerb::release);
  EXPECT_EQ(read_client_message(R"({"type":"put_back"})").message.verb, ClientVerb::put_back);
  const ReadMessage hello =
      read_client_message(R"({"type":"hello","version":1,"client":"0123-abcd","lang":"es","code":"AB2C3D"})");
  EXPECT_TRUE(hello.faults.empty());
  EXPECT_EQ(hello.message.client, "0123-abcd");
}

}  // namespace
}  // namespace mirada::server
