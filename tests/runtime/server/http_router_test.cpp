#include "server/http_router.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "fake_station.h"
#include "server/api.h"

namespace mirada::server {
namespace {

using nlohmann::json;

HttpRequest request(std::string_view method, std::string_view target) {
  HttpRequest out;
  out.method = method;
  out.target = target;
  out.hosts = {"localhost:8080"};
  return out;
}

unsigned refused(const HttpRequest& request) {
  const auto reply = refuse(request, "127.0.0.1", "robot");
  return reply ? reply->status : 0;
}

TEST(Api, what_is_no_scratch_file_is_told_so) {
  const std::string answer = open_scratch("no archive", {});
  EXPECT_NE(answer.find("Scratch"), std::string::npos) << answer;
}

TEST(Api, nothing_at_all_is_no_program) {
  for (const char* text : {"{}", " { } "}) {
    const json answer = json::parse(check_program(text, {}));
    EXPECT_NE(answer.dump().find("workspace_missing"), std::string::npos) << answer.dump();
  }
}

TEST(HttpRouter, refuses_an_ambiguous_length_and_host) {
  HttpRequest get = request("GET", "/");
  EXPECT_EQ(refused(get), 0u);
  get.transfer_encoding = true;
  EXPECT_EQ(refused(get), 400u);
  get = request("GET", "/");
  get.content_lengths = {"1", "1"};
  EXPECT_EQ(refused(get), 400u);
  get = request("GET", "/");
  get.hosts = {};
  EXPECT_EQ(refused(get), 400u);
  get.hosts = {"localhost:8080", "localhost:8080"};
  EXPECT_EQ(refused(get), 400u);
  get.hosts = {"evil.example"};
  EXPECT_EQ(refused(get), 421u);
}

TEST(HttpRouter, only_get_and_stop_go_without_the_right_origin) {
  EXPECT_EQ(refused(request("GET", "/api/packs")), 0u);
  EXPECT_EQ(refused(request("POST", "/api/stop")), 0u);
  EXPECT_EQ(refused(request("POST", "/api/check")), 403u);
  EXPECT_EQ(refused(request("POST", "/api/scratch")), 403u);
  EXPECT_EQ(refused(request("DELETE", "/")), 403u);
  HttpRequest socket = request("GET", "/ws");
  socket.upgrade = true;
  EXPECT_EQ(refused(socket), 403u);
  socket.origin = "http://evil.example";
  EXPECT_EQ(refused(socket), 403u);
  socket.origin = "http://localhost:8080";
  EXPECT_EQ(refused(socket), 0u);
  HttpRequest stop = request("POST", "/api/stop");
  stop.hosts = {"evil.example"};
  EXPECT_EQ(refused(stop), 421u);
}

TEST(HttpRouter, answers_the_api_and_says_what_is_missing) {
  FakeStation station;
  const RouterData data{station, StaticFiles("/nowhere"), R"({"packs":[]})", R"({"examples":[]})", Lang::es,
                        "robot"};
  EXPECT_EQ(answer(request("GET", "/api/packs"), data).body, R"({"packs":[]})");
  EXPECT_EQ(answer(request("GET", "/api/examples?x=1"), data).body, R"({"examples":[]})");
  const json setup = json::parse(answer(request("GET", "/api/setup"), data).body);
  EXPECT_EQ(setup["lang"], "es");
  EXPECT_EQ(setup["setup"]["robot"], "bot");
  EXPECT_EQ(setup["robots"][0]["id"], "bot");
  EXPECT_EQ(answer(request("GET", "/api/check"), data).status, 405u);
  EXPECT_EQ(answer(request("POST", "/api/packs"), data).status, 405u);
  const HttpReply missing = answer(request("GET", "/api/nothing"), data);
  EXPECT_EQ(missing.status, 404u);
  EXPECT_EQ(json::parse(missing.body)["faults"][0]["code"], "page_missing");
}

TEST(HttpRouter, a_missing_editor_is_a_friendly_page) {
  FakeStation station;
  const RouterData data{station, StaticFiles("/nowhere"), "", "", Lang::en, "robot"};
  const HttpReply page = answer(request("GET", "/"), data);
  EXPECT_EQ(page.status, 200u);
  EXPECT_NE(page.body.find("scripts/run"), std::string::npos);
  EXPECT_EQ(answer(request("GET", "/x.js"), data).status, 404u);
}

TEST(HttpRouter, nothing_that_was_sent_comes_back_in_a_page) {
  EXPECT_EQ(refusal(404, {"x", "no {value}", "no {value}"}, "/<script>").body.find("<script>"),
            std::string::npos);
}

TEST(HttpRouter, bodies_are_small_but_for_programs) {
  EXPECT_EQ(body_limit(request("POST", "/api/check")), 4u << 20);
  EXPECT_EQ(body_limit(request("POST", "/api/scratch")), 4u << 20);
  EXPECT_EQ(body_limit(request("POST", "/api/other")), 256u << 10);
}

}  // namespace
}  // namespace mirada::server
