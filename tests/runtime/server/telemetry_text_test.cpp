#include "server/telemetry_text.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/messages.h"
#include "model/percepts.h"

namespace mirada::server {
namespace {

using nlohmann::json;

session::Telemetry rich() {
  session::Telemetry t;
  t.t = 1'250'000;
  t.run = 3;
  t.state = session::RunState::running;
  t.running_blocks = std::make_shared<const std::vector<std::string>>(std::vector<std::string>{"a", "b\"c"});
  t.variables["n"] = {"0.5", true, 0.5, false};
  t.variables["inf"] = {"Infinity", true, std::numeric_limits<double>::infinity(), false};
  t.variables["yes"] = {"true", false, 0, true};
  t.variables["broken \xff"] = {"\xc3\x28", false, 0, false};
  t.lists["l"] = {{"1", true, 1, false}, {"x", false, 0, false}};
  t.say_log = {{2'000'000, "hola"}};
  t.faults = {{"a", make_fault("", messages::field_missing, {{"field", "x"}})}};
  t.X_OR = {1, 2, 0.5};
  Percepts percepts;
  percepts.sonar.frame = 7;
  percepts.sonar.readings = {{rad(-30), Answer::blocked, 0.5, 0.01}, {rad(30), Answer::not_seen, NAN, NAN}};
  percepts.sonar.boundary = {{1, 2, Answer::clear}};
  percepts.faces.frame = 8;
  percepts.faces.faces = {{1, 2, 3, 4, 0.9, 0.1}};
  t.percepts = std::make_shared<const Percepts>(percepts);
  t.scene_json = R"({"path_m":1})";
  memory::Snapshot memory;
  memory.X_OR = {1, 2, 0};
  memory.places = {{{0.5, 0.25}, 0.02, 1500 * kMillisecond}};
  memory.segments = {{{0, 0}, {1, 0}, 0.03, 0, 5}};
  memory.things = {{ThingKind::tag, 7, {1, -0.5}, 0.1, 4 * kSecond}};
  memory.free_m = {1.5, 0};
  t.memory = std::make_shared<const memory::Snapshot>(memory);
  return t;
}

TEST(TelemetryText, says_all_that_the_protocol_names) {
  const json out = json::parse(TelemetryText(rich()).assemble({true, true, true, true, true}, true));
  EXPECT_EQ(out["type"], "telemetry");
  EXPECT_EQ(out["t_us"], 1'250'000);
  EXPECT_EQ(out["state"], "running");
  EXPECT_EQ(out["stop_reason"], "none");
  EXPECT_EQ(out["blocks"][1], "b\"c");
  EXPECT_EQ(out["variables"]["n"], 0.5);
  EXPECT_EQ(out["variables"]["inf"], "Infinity");
  EXPECT_EQ(out["variables"]["yes"], true);
  EXPECT_EQ(out["lists"]["l"], (json{1, "x"}));
  EXPECT_EQ(out["say_log"][0]["t_s"], 2.0);
  EXPECT_EQ(out["faults"][0]["place"], "a");
  EXPECT_EQ(out["faults"][0]["message"]["es"], "Falta x.");
  EXPECT_EQ(out["sonar"]["readings"][0], (json{-30.0, "blocked", 0.5, 0.01}));
  EXPECT_EQ(out["sonar"]["readings"][1], (json{30.0, "not_seen", nullptr, nullptr}));
  EXPECT_EQ(out["sonar"]["boundary"][0], (json{1.0, 2.0, "clear"}));
  EXPECT_EQ(out["faces"]["faces"][0]["w"], 3.0);
  EXPECT_EQ(out["scene"]["path_m"], 1);
  EXPECT_EQ(out["memory"]["places"][0], (json{0.5, 0.25, 0.02, 1.5}));
  EXPECT_EQ(out["memory"]["segments"][0], (json{0.0, 0.0, 1.0, 0.0, 0.03, 0.0}));
  EXPECT_EQ(out["memory"]["things"][0], (json{"tag", 7, 1.0, -0.5, 0.1, 4.0}));
  EXPECT_EQ(out["memory"]["free"], (json{1.5, 0.0}));
  EXPECT_EQ(out["memory"]["next"]["watching"], "nothing");
}

TEST(TelemetryText, who_the_faces_are_is_not_for_everybody) {
  session::Telemetry named = rich();
  auto percepts = std::make_shared<Percepts>(*named.percepts);
  percepts->faces.faces[0].name = "Ana";
  percepts->faces.faces[0].familiar = Familiar::known;
  percepts->faces.lesson = LessonPercept{"Ben", 1, 8, nullptr};
  named.percepts = percepts;
  const TelemetryText text(named);
  const json told = json::parse(text.assemble({.faces = true}, true))["faces"];
  EXPECT_EQ(told["faces"][0]["name"], "Ana");
  EXPECT_EQ(told["lesson"]["name"], "Ben");
  EXPECT_EQ(json::parse(text.assemble({}, true))["faces"]["lesson"]["name"], "Ben");
  EXPECT_TRUE(json::parse(text.assemble({}, false))["faces"].is_null());
  const std::string others = text.assemble({.faces = true}, false);
  EXPECT_EQ(others.find("Ana"), std::string::npos);
  EXPECT_EQ(others.find("Ben"), std::string::npos);
  EXPECT_EQ(json::parse(others)["faces"]["faces"][0]["who"], "unsure");
}

TEST(TelemetryText, closed_panels_get_nothing) {
  const json out = json::parse(TelemetryText(rich()).assemble({}, true));
  EXPECT_TRUE(out["sonar"].is_null() && out["faces"].is_null() && out["scene"].is_null());
  EXPECT_EQ(out["run"], 3);
}

TEST(TelemetryText, time_alone_is_no_news) {
  session::Telemetry later = rich();
  later.t += kSecond;
  EXPECT_TRUE(TelemetryText(rich()).same_content(TelemetryText(later)));
  later.say = "hi";
  EXPECT_FALSE(TelemetryText(rich()).same_content(TelemetryText(later)));
}

TEST(PictureBytes, header_then_jpeg) {
  const std::string bytes = picture_bytes({5, 99, 320, 240, std::string("\xff\xd8jpeg", 6)});
  const std::size_t size = static_cast<unsigned char>(bytes[0]);
  EXPECT_EQ(bytes.substr(1, 3), std::string(3, '\0'));
  EXPECT_EQ(json::parse(bytes.substr(4, size)),
            (json{{"frame", 5}, {"t_us", 99}, {"width", 320}, {"height", 240}}));
  EXPECT_EQ(bytes.substr(4 + size), "\xff\xd8jpeg");
}

}  // namespace
}  // namespace mirada::server
