#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

#include <gmock/gmock.h>

#include "server/client_message.h"
#include "server_fixture.h"

namespace mirada::server {
namespace {

using nlohmann::json;

class WebSocketServerTest : public ServerTest {
 protected:
  /// Upgraded, greeted, welcomed.
  RawClient viewer(const std::string& name) {
    RawClient client = connect();
    EXPECT_TRUE(client.hello(name));
    EXPECT_FALSE(client.wait_for("welcome").is_null());
    return client;
  }
  /// How the server ends a connection that has sent these bytes after hello.
  int close_code_after(const std::string& bytes) {
    RawClient client = viewer("attacker");
    client.send(bytes);
    return client.wait_for_close();
  }
};

TEST_F(WebSocketServerTest, refuses_a_foreign_origin) {
  EXPECT_FALSE(connect().upgrade("http://evil.example"));
  EXPECT_FALSE(connect().upgrade("null"));
  EXPECT_TRUE(connect().upgrade());
}

TEST_F(WebSocketServerTest, runs_and_stops_for_a_client) {
  RawClient ann = viewer("ann");
  ann.text(R"({"type":"run","program":{"a":1}})");
  EXPECT_EQ(ann.wait_for("started")["run"], 1);
  RawClient bob = viewer("bob");
  bob.text(R"({"type":"stop"})");
  EXPECT_FALSE(ann.wait_for("stopped").is_null());
  EXPECT_EQ(station_.stops, 1);
  while (ann.wait_for("telemetry")["stop_reason"] != "stop_button") {
  }
}

TEST_F(WebSocketServerTest, broken_frames_end_with_the_code_of_the_standard) {
  EXPECT_EQ(close_code_after(RawClient::frame(1, "{}", true, false)), 1002) << "unmasked";
  EXPECT_EQ(close_code_after(RawClient::frame(1, "\xc3\x28")), 1007) << "not UTF-8";
  EXPECT_EQ(close_code_after(RawClient::frame(1, "\xe2\x82", false) + RawClient::frame(0, "\x28")), 1007);
  EXPECT_EQ(close_code_after(RawClient::frame(0x41, "{}")), 1002) << "reserved bit";
  EXPECT_EQ(close_code_after(RawClient::frame(3, "{}")), 1002) << "reserved opcode";
  EXPECT_EQ(close_code_after(RawClient::frame(9, std::string(126, 'x'))), 1002) << "large ping";
  EXPECT_EQ(close_code_after(RawClient::frame(0, "{}")), 1002) << "continues nothing";
  EXPECT_EQ(close_code_after(RawClient::frame(1, "{", false) + RawClient::frame(1, "}")), 1002);
  EXPECT_EQ(close_code_after(RawClient::frame(2, "{}")), 1003) << "binary";
  EXPECT_EQ(close_code_after(RawClient::frame(1, std::string(5u << 20, ' '))), 1009) << "5 MiB";
  EXPECT_TRUE(alive());
}

TEST_F(WebSocketServerTest, a_frame_that_claims_to_be_giant_is_refused) {
  std::string header("\x81\xff\x7f\xff\xff\xff\xff\xff\xff\xff\0\0\0\0", 14);
  RawClient client = viewer("attacker");
  client.send(header);
  const std::string piece(1u << 20, ' ');
  for (int i = 0; i < 6 && client.send(piece); ++i) {
  }
  EXPECT_EQ(client.wait_for_close(), 1009);
  EXPECT_TRUE(alive());
}

TEST_F(WebSocketServerTest, before_hello_little_is_taken) {
  RawClient large = connect();
  ASSERT_TRUE(large.upgrade());
  large.send(RawClient::frame(1, std::string(100'000, ' ')));
  EXPECT_EQ(large.wait_for_close(), 1009);
  RawClient rude = connect();
  ASSERT_TRUE(rude.upgrade());
  rude.text(R"({"type":"watch","camera":true})");
  EXPECT_EQ(rude.wait_for_close(), 1008);
}

TEST_F(WebSocketServerTest, a_message_in_pieces_is_one_message) {
  RawClient ann = viewer("ann");
  ann.send(RawClient::frame(1, R"({"type":"run",)", false) + RawClient::frame(9, "between") +
           RawClient::frame(0, R"("program":7})"));
  EXPECT_EQ(ann.wait_for("started")["run"], 1);
  EXPECT_THAT(station_.calls(), testing::Contains("start 7"));
}

TEST_F(WebSocketServerTest, a_program_of_four_mebibytes_arrives) {
  RawClient ann = viewer("ann");
  const std::string program = "\"" + std::string(kMaxProgramBytes - 2, 'x') + "\"";
  ann.text(R"({"type":"run","program":)" + program + "}");
  EXPECT_EQ(ann.wait_for("started")["run"], 1);
  ann.text(R"({"type":"run","program":"x)" + program.substr(1) + "}");
  EXPECT_EQ(ann.wait_for("refused")["faults"][0]["code"], "message_too_large");
}

TEST_F(WebSocketServerTest, stop_passes_a_program_that_is_being_compiled_and_one_that_is_being_received) {
  std::mutex mutex;
  std::condition_variable changed;
  bool compiling = false, go_on = false;
  station_.on_start = [&] {
    std::unique_lock lock(mutex);
    compiling = true;
    changed.notify_all();
    changed.wait(lock, [&] { return go_on; });
  };
  RawClient ann = viewer("ann");
  RawClient bob = viewer("bob");
  ann.text(R"({"type":"run","program":1})");
  {
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return compiling; });
  }
  const std::string large =
      RawClient::frame(1, R"({"type":"run","program":")" + std::string(4'000'000, 'x') + "\"}");
  bob.send(large.substr(0, 2'000'000));
  EXPECT_EQ(RawClient::status(connect().ask("POST", "/api/stop")), 204);
  EXPECT_EQ(station_.stops, 1);
  ann.text(R"({"type":"stop"})");
  EXPECT_FALSE(ann.wait_for("stopped").is_null());
  {
    const std::lock_guard lock(mutex);
    go_on = true;
    changed.notify_all();
  }
  EXPECT_EQ(ann.wait_for("refused")["faults"][0]["code"], "start_stopped");
  EXPECT_EQ(station_.telemetry()->state, session::RunState::idle);
}

TEST_F(WebSocketServerTest, a_viewer_who_does_not_read_loses_pictures_and_nothing_else) {
  RawClient slow = connect(4096);
  ASSERT_TRUE(slow.hello("slow"));
  slow.text(R"({"type":"watch","camera":true})");
  RawClient quick = viewer("quick");
  quick.text(R"({"type":"watch","camera":true})");
  std::uint64_t seen = 0;
  for (std::uint64_t frame = 1; seen < 100; ++frame) {
    station_.show({frame, 0, 320, 240, std::string(60'000, 'j')});
    const RawClient::Frame got = quick.next();
    ASSERT_GE(got.opcode, 0);
    if (got.opcode == 2) ++seen;
  }
  quick.text(R"({"type":"stop"})");
  EXPECT_FALSE(quick.wait_for("stopped").is_null());
  // What waited for the slow one comes in the end: Stop, and few of the pictures.
  std::size_t pictures = 0;
  for (;;) {
    const RawClient::Frame got = slow.next();
    ASSERT_GE(got.opcode, 0);
    if (got.opcode == 2) ++pictures;
    if (got.opcode == 1 && json::parse(got.payload)["type"] == "stopped") break;
  }
  EXPECT_LT(pictures, 50u);
}

TEST_F(WebSocketServerTest, a_client_that_takes_no_answers_is_closed) {
  RawClient deaf = connect(4096);
  ASSERT_TRUE(deaf.hello("deaf"));
  const std::string stop = RawClient::frame(1, R"({"type":"stop"})");
  bool taken = true;
  for (int i = 0; i < 10'000'000 && taken; ++i) taken = deaf.send(stop);
  EXPECT_FALSE(taken);
  EXPECT_TRUE(alive());
}

TEST_F(WebSocketServerTest, viewers_come_and_go_while_the_robot_works) {
  std::atomic<bool> done{false};
  std::thread robot([&] {
    for (std::uint64_t i = 1; !done; ++i) {
      station_.publish([&](session::Telemetry& t) { t.say = std::to_string(i); });
      station_.show({i, 0, 320, 240, "jpeg"});
      std::this_thread::yield();
    }
  });
  std::vector<std::thread> people;
  for (int person = 0; person < 4; ++person) {
    people.emplace_back([&, person] {
      for (int visit = 0; visit < 5; ++visit) {
        RawClient client = viewer("person" + std::to_string(person));
        client.text(R"({"type":"watch","camera":true,"room":true})");
        client.text(R"({"type":"run","program":1})");
        client.text(R"({"type":"evaluate","request":1,"program":1,"block":"b"})");
        station_.answer_all(vm::MonitorValue{"1", true, 1, false});
        EXPECT_FALSE(client.wait_for("telemetry").is_null());
        EXPECT_EQ(RawClient::status(connect().ask("POST", "/api/stop")), 204);
        client.text(R"({"type":"stop"})");
        EXPECT_FALSE(client.wait_for("stopped").is_null());
      }
    });
  }
  for (std::thread& person : people) person.join();
  done = true;
  robot.join();
  // A visitor may leave on another one's "stopped" before its own Stop is read; those by POST are all
  // answered.
  EXPECT_GE(station_.stops, 20);
}

TEST_F(WebSocketServerTest, closing_the_server_ends_all_and_late_answers_find_nobody) {
  RawClient ann = viewer("ann");
  ann.text(R"({"type":"evaluate","request":1,"program":1,"block":"b"})");
  ann.text(R"({"type":"run","program":1})");
  EXPECT_FALSE(ann.wait_for("started").is_null());
  server_.reset();
  station_.answer_all(vm::MonitorValue{});
  EXPECT_EQ(ann.wait_for_close(), 0);
}

TEST_F(WebSocketServerTest, a_busy_port_and_a_bad_address_are_told) {
  ServerOptions options;
  options.port = server_->port();
  const auto busy = Server::open(options, station_, packs_, {}, clock_);
  ASSERT_FALSE(busy.ok());
  EXPECT_EQ(busy.faults().front().code(), "port_busy");
  options.address = "300.1.1.1";
  EXPECT_EQ(Server::open(options, station_, packs_, {}, clock_).faults().front().code(), "address_bad");
  options.address = "192.0.2.1";
  EXPECT_EQ(Server::open(options, station_, packs_, {}, clock_).faults().front().code(), "address_bad");
}

}  // namespace
}  // namespace mirada::server
