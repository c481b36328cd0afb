#include <vector>

#include <gmock/gmock.h>

#include "server_fixture.h"

namespace mirada::server {
namespace {

using testing::HasSubstr;

class HttpServerTest : public ServerTest {
 protected:
  /// The status of the answer to these bytes on a connection of their own; 0 = none.
  int status_of(const std::string& bytes) {
    RawClient client = connect();
    client.send(bytes);
    client.finish_sending();
    return RawClient::status(client.read_all());
  }
  std::string head(const std::string& line) {
    return line + " HTTP/1.1\r\nHost: " + connect().host() + "\r\n";
  }
};

TEST_F(HttpServerTest, answers_with_the_headers_that_keep_pages_apart) {
  const std::string answer = connect().ask("GET", "/");
  EXPECT_EQ(RawClient::status(answer), 200);
  EXPECT_THAT(answer, HasSubstr("default-src 'none'"));
  EXPECT_THAT(answer, HasSubstr("frame-ancestors 'none'"));
  EXPECT_THAT(answer, HasSubstr("X-Content-Type-Options: nosniff"));
  EXPECT_THAT(answer, HasSubstr("Referrer-Policy: no-referrer"));
  EXPECT_THAT(answer, testing::Not(HasSubstr("Access-Control")));
  EXPECT_THAT(answer, HasSubstr("scripts/run"));
}

TEST_F(HttpServerTest, several_requests_on_one_connection) {
  RawClient client = connect();
  for (int i = 0; i < 5; ++i) EXPECT_EQ(RawClient::status(client.ask("GET", "/api/packs")), 200);
  EXPECT_EQ(RawClient::status(client.ask("POST", "/api/stop")), 204);
  EXPECT_EQ(RawClient::status(client.ask("GET", "/api/setup")), 200);
}

TEST_F(HttpServerTest, head_has_no_body) {
  RawClient client = connect();
  client.send(head("HEAD /api/setup") + "\r\n" + head("GET /api/packs") + "Connection: close\r\n\r\n");
  const std::string answer = client.read_all();
  EXPECT_THAT(answer, HasSubstr("Content-Length"));
  EXPECT_EQ(answer.find("\"setup\""), std::string::npos);
  EXPECT_THAT(answer, HasSubstr("\"packs\""));
}

TEST_F(HttpServerTest, requests_that_can_be_read_in_two_ways_are_refused) {
  EXPECT_EQ(status_of(head("POST /api/check") + "Transfer-Encoding: chunked\r\n\r\n0\r\n\r\n"), 400);
  EXPECT_EQ(status_of(head("POST /api/check") + "Transfer-Encoding: chunked\r\nContent-Length: 3\r\n\r\nabc"),
            400);
  EXPECT_EQ(status_of(head("POST /api/check") + "Content-Length: 3\r\nTransfer-Encoding: chunked\r\n\r\nabc"),
            400);
  EXPECT_EQ(status_of(head("POST /api/check") + "Content-Length: 3\r\nContent-Length: 3\r\n\r\nabc"), 400);
  EXPECT_EQ(status_of(head("POST /api/check") + "Content-Length: 3\r\nContent-Length: 4\r\n\r\nabcd"), 400);
  EXPECT_EQ(status_of(head("POST /api/check") + "Content-Length: -1\r\n\r\n"), 400);
  EXPECT_EQ(status_of("GET / HTTP/1.1\r\n\r\n"), 400);
  EXPECT_EQ(status_of(head("GET /") + "Host: localhost\r\n\r\n"), 400);
  EXPECT_EQ(status_of("GET / HTTP/1.1\r\nHost: evil.example\r\n\r\n"), 421);
  EXPECT_TRUE(alive());
}

TEST_F(HttpServerTest, garbage_is_answered_or_dropped_and_the_server_goes_on) {
  for (const std::string& bytes :
       {std::string("\x16\x03\x01\x02\x00\x01", 6), std::string(100, '\0'), std::string("GET\r\n\r\n"),
        std::string("\r\n\r\n\r\n"), std::string("GET / HTTP/9.9\r\n\r\n"), std::string(3000, '\xff'),
        std::string("GET / HTTP/1.1\nHost: localhost\n\n"),
        std::string("GET / HTTP/1.1\r\nHost : localhost\r\n\r\n")}) {
    const int status = status_of(bytes);
    EXPECT_TRUE(status == 0 || status == 400) << status << " for " << bytes.substr(0, 20);
  }
  EXPECT_TRUE(alive());
}

TEST_F(HttpServerTest, half_a_request_and_gone) {
  for (const char* bytes : {"G", "GET / HT", "GET / HTTP/1.1\r\nHost: loc", ""})
    EXPECT_EQ(status_of(bytes), 0);
  EXPECT_EQ(status_of(head("POST /api/check") + "Origin: http://" + connect().host() +
                      "\r\nContent-Length: 9\r\n\r\nabc"),
            0);
  EXPECT_TRUE(alive());
}

TEST_F(HttpServerTest, a_large_header_is_refused) {
  EXPECT_EQ(status_of(head("GET /") + "X: " + std::string(9000, 'x') + "\r\n\r\n"), 431);
  EXPECT_EQ(status_of("GET /" + std::string(9000, 'x') + " HTTP/1.1\r\n"), 431);
  EXPECT_TRUE(alive());
}

TEST_F(HttpServerTest, a_hundred_megabytes_are_refused_before_they_come) {
  RawClient client = connect();
  client.send(head("POST /api/check") + "Origin: http://" + client.host() +
              "\r\nContent-Length: 100000000\r\n\r\n");
  const std::string header = client.read_header();
  EXPECT_EQ(RawClient::status(header), 413);
  EXPECT_THAT(client.read_bytes(RawClient::content_length(header)), HasSubstr("4096"));
  EXPECT_TRUE(alive());
}

TEST_F(HttpServerTest, those_who_send_them_all_the_same_still_read_the_answer) {
  RawClient client = connect();
  client.send(head("POST /api/check") + "Origin: http://" + client.host() +
              "\r\nContent-Length: 100000000\r\n\r\n");
  const std::string piece(1'000'000, 'x');
  for (int i = 0; i < 100; ++i) {
    if (!client.send(piece)) break;
  }
  EXPECT_EQ(RawClient::status(client.read_header()), 413);
}

TEST_F(HttpServerTest, check_needs_its_origin_and_tells_the_faults) {
  EXPECT_EQ(RawClient::status(connect().ask("POST", "/api/check", "", "{}")), 403);
  RawClient client = connect();
  const std::string answer =
      client.ask("POST", "/api/check", "Origin: http://" + client.host() + "\r\n", "nonsense");
  EXPECT_EQ(RawClient::status(answer), 200);
  EXPECT_THAT(answer, HasSubstr("\"ok\":false"));
  EXPECT_THAT(answer, HasSubstr("\"severity\":\"error\""));
}

TEST_F(HttpServerTest, waits_with_a_body_until_it_is_wanted) {
  RawClient client = connect();
  client.send(head("POST /api/check") + "Origin: http://" + client.host() +
              "\r\nExpect: 100-continue\r\nContent-Length: 2\r\n\r\n");
  EXPECT_EQ(RawClient::status(client.read_header()), 100);
  client.send("{}");
  EXPECT_EQ(RawClient::status(client.read_header()), 200);
}

TEST_F(HttpServerTest, stop_needs_the_host_alone_and_waits_for_no_body) {
  EXPECT_EQ(status_of("POST /api/stop HTTP/1.1\r\nHost: evil.example\r\n\r\n"), 421);
  EXPECT_EQ(station_.stops, 0);
  EXPECT_EQ(RawClient::status(connect().ask("POST", "/api/stop", "Origin: http://evil.example\r\n")), 204);
  EXPECT_EQ(station_.stops, 1);
  RawClient waiting = connect();
  waiting.send(head("POST /api/stop") + "Content-Length: 1000000\r\n\r\n");
  EXPECT_EQ(RawClient::status(waiting.read_header()), 204);
  EXPECT_EQ(station_.stops, 2);
}

TEST_F(HttpServerTest, stop_works_when_the_robot_is_full_of_visitors) {
  std::vector<RawClient> crowd;
  for (int i = 0; i < 64; ++i) crowd.push_back(connect());
  // A request on the last of them is answered only after all were accepted.
  EXPECT_EQ(RawClient::status(crowd.back().ask("GET", "/api/setup")), 200);
  std::vector<RawClient> watching;
  while (watching.size() < 63) {
    RawClient viewer = std::move(crowd[watching.size()]);
    ASSERT_TRUE(viewer.upgrade());
    watching.push_back(std::move(viewer));
  }
  ASSERT_TRUE(crowd.back().upgrade());
  EXPECT_EQ(RawClient::status(connect().ask("GET", "/")), 503);
  EXPECT_EQ(RawClient::status(connect().ask("POST", "/api/stop")), 204);
  EXPECT_EQ(station_.stops, 1);
}

TEST_F(HttpServerTest, two_hundred_connections_leave_it_standing) {
  {
    std::vector<RawClient> crowd;
    for (int i = 0; i < 200; ++i) crowd.push_back(connect());
    int served = 0;
    for (RawClient& client : crowd)
      served += RawClient::status(client.ask("GET", "/api/setup")) == 200 ? 1 : 0;
    EXPECT_GE(served, 64);
  }
  while (RawClient::status(connect().ask("GET", "/api/setup")) != 200) {
  }
}

TEST_F(HttpServerTest, an_idle_connection_makes_room_for_a_new_one) {
  std::vector<RawClient> idle;
  for (int i = 0; i < 64; ++i) {
    idle.push_back(connect());
    ASSERT_EQ(RawClient::status(idle.back().ask("GET", "/api/setup")), 200);
  }
  EXPECT_EQ(RawClient::status(connect().ask("GET", "/api/setup")), 200);
}

}  // namespace
}  // namespace mirada::server
